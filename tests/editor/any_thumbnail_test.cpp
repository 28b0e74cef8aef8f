// Whatever the numbers of a document are, the editor has a thumbnail of it, or none because the core refuses it with a
// sentence: nothing throws, and nothing takes for ever. FUMAGE_SMOKES=10000 tries as many of each kind, of which it
// tells every 500; QTEST_FUNCTION_TIMEOUT must then be as long.
#include "editor_helpers.h"

#include "tests/any_document.h"

#include "ui/presets/thumbnailer.h"

#include "core/rendering/renderer.h"
#include "core/simulation/simulator.h"

#include <ctime>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr int kFew = 20;
constexpr int kEdge = 24;

/// Whether the core says why there is no picture of the end of a document.
bool isRefused(const Effect& document)
{
    const SampledEffect effect = sampled(document);
    Simulator simulator(effect);
    const auto frame = simulator.frame(std::max(0, document.timeline.length - 1));
    if (!frame) {
        return !frame.error().text().empty();
    }
    Image image;
    const Status status = Renderer().render(*frame.value(), effect, kEdge, kEdge, image);
    return !status && !status.error().text().empty();
}

/// What has become of the documents so far.
struct Tally {
    int shown = 0;
    int refused = 0;
    double slowest = 0.0; ///< s that the program has computed for one: a clock on the wall tells how long others have
    int slowestNumber = 0; ///< counted from 0

    /// @return whether there is a picture, or a reason
    bool add(const Effect& effect)
    {
        const std::clock_t begin = std::clock();
        const bool isShown = !ui::renderThumbnail(effect, kEdge).isNull();
        const double taken = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
        if (taken > slowest) {
            slowest = taken;
            slowestNumber = shown + refused;
        }
        (isShown ? shown : refused) += 1;
        constexpr int kOften = 500;
        if ((shown + refused) % kOften == 0) {
            qInfo("%d shown, %d refused, slowest number %d with %.2f s", shown, refused, slowestNumber, slowest);
        }
        return isShown || isRefused(effect);
    }
};

} // namespace

class AnyThumbnailTest : public QObject {
    Q_OBJECT

private slots:
    void everyDocumentHasAThumbnailOrIsRefused()
    {
        Tally tally;
        for (int i = 0; i < smokesOfAKind(kFew); ++i) {
            QVERIFY2(tally.add(made(anyDocument(static_cast<std::uint32_t>(i)))), qPrintable(QString::number(i)));
        }
        QVERIFY(tally.shown > 0);
    }

    void everyVariationOfVariationsHasAThumbnailOrIsRefused()
    {
        Tally tally;
        Breeder breeder;
        for (int i = 0; i < smokesOfAKind(kFew); ++i) {
            QVERIFY2(tally.add(made(breeder.bred(i))), qPrintable(QString::number(i)));
        }
        QVERIFY(tally.shown > 0);
    }
};

FUMAGE_TEST_MAIN(AnyThumbnailTest)
#include "any_thumbnail_test.moc"
