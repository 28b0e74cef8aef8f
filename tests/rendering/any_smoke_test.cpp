// Whatever the numbers of a document are within their ranges, it becomes a picture or a sentence: nothing throws, and
// no pixel is no number.
#include "tests/any_document.h"
#include "tests/helpers.h"

#include <algorithm>
#include <cmath>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr int kEdge = 16;
constexpr int kFew = 80; ///< smokes of a kind

bool isPicture(const Image& image)
{
    const auto row = static_cast<std::size_t>(image.width) * 4;
    for (int y = 0; y < image.height; ++y) {
        if (!std::all_of(image.row(y), image.row(y) + row, [](float value) { return std::isfinite(value); })) {
            return false;
        }
    }
    return true;
}

/// Whether a document becomes a picture of numbers, or a sentence that says what to change.
bool isShown(const Effect& document, int number)
{
    try {
        const SampledEffect effect = sampled(document);
        Simulator simulator(effect);
        const auto frame = simulator.frame(number);
        if (!frame) {
            return frame.error().code == ErrorCode::OutOfRange && !frame.error().text().empty();
        }
        Renderer renderer;
        Image image;
        const Status status = renderer.render(*frame.value(), effect, kEdge, kEdge, image);
        if (!status) {
            qWarning("%s", status.error().text().c_str());
        }
        return status && isPicture(image);
    } catch (const std::exception& thrown) {
        qWarning("%s", thrown.what());
        return false;
    }
}

/// Sources without extent of each shape, with and without what moves their air.
std::vector<Effect> pointSources()
{
    std::vector<Effect> points;
    for (int shape = 0; shape < 3; ++shape) {
        for (int i = 0; i < 64; ++i) {
            Effect effect = pointInStillAir();
            effect.emitter.shape = static_cast<EmitterShape>(shape);
            effect.emitter.width = (i & 1) != 0 ? 0.0F : 0.4F;
            effect.emitter.depth = 0.0F;
            effect.emitter.mode = (i & 2) != 0 ? EmissionMode::Burst : EmissionMode::Continuous;
            effect.emitter.speed = (i & 4) != 0 ? 0.09F : 0.0F; // as fast as air of no buoyancy is taken to rise
            effect.emitter.normal = (i & 8) != 0 ? glm::vec3(0.0F, -1.0F, 0.0F) : glm::vec3(0.0F, 1.0F, 0.0F);
            effect.motion.buoyancy = effect.air.buoyancy = (i & 16) != 0 ? 0.0F : 2.0F;
            effect.emitter.position = (i & 32) != 0 ? glm::vec3(10000.0F, -10000.0F, 10000.0F) : glm::vec3(0.0F);
            points.push_back(effect);
        }
    }
    return points;
}

int tellingFrame(const Effect& effect)
{
    return std::min(19, effect.timeline.length - 1);
}

} // namespace

class AnySmokeTest : public QObject {
    Q_OBJECT

private slots:
    void aPointInStillAirIsShown()
    {
        for (const Effect& effect : pointSources()) {
            const Effect small = made(effect);
            Simulator simulator(sampled(small));
            QVERIFY(simulator.frame(tellingFrame(small)));
            QVERIFY(isShown(small, tellingFrame(small)));
        }
    }

    void everyDocumentIsShownOrRefused()
    {
        for (int i = 0; i < smokesOfAKind(kFew); ++i) {
            const Effect effect = made(anyDocument(static_cast<std::uint32_t>(i)));
            QVERIFY2(isShown(effect, tellingFrame(effect)), qPrintable(QString::number(i)));
        }
    }

    void everyVariationOfVariationsIsShownOrRefused()
    {
        Breeder breeder;
        for (int i = 0; i < smokesOfAKind(kFew); ++i) {
            const Effect effect = made(breeder.bred(i));
            QVERIFY2(isShown(effect, tellingFrame(effect)), qPrintable(QString::number(i)));
        }
    }

    void aParticleThatIsNowhereIsAnError()
    {
        for (const float place : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
            const Effect effect = made(pointInStillAir());
            Simulator simulator(sampled(effect));
            Frame frame = *simulator.frame(10).value();
            const auto living = static_cast<std::size_t>(
                std::find_if(frame.particles.birthStep.begin(), frame.particles.birthStep.end(),
                    [](std::int32_t step) { return step >= 0; })
                - frame.particles.birthStep.begin());
            frame.particles.x[living + 3] = place;
            Renderer renderer;
            Image image;
            const Status status = renderer.render(frame, sampled(effect), kEdge, kEdge, image);
            QVERIFY(!status);
            QCOMPARE(status.error().code, ErrorCode::OutOfRange);
        }
    }
};

QTEST_GUILESS_MAIN(AnySmokeTest)
#include "any_smoke_test.moc"
