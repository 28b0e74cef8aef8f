// Small pictures that are kept from one start to the next.
#include "editor_helpers.h"
#include "picture_helpers.h"

#include "ui/presets/thumbnailer.h"

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr int kEdge = 24;

QImage mark()
{
    QImage image(kEdge, kEdge, QImage::Format_RGB32);
    image.fill(Qt::red);
    return image;
}

} // namespace

class ThumbnailTest : public QObject {
    Q_OBJECT

private slots:
    void cleanup() { QDir(m_folder.path()).removeRecursively(); }

    void aPictureOfTheSameContentIsNotRenderedAgain()
    {
        store().put(tinyEffect(), kEdge, mark());
        QCOMPARE(picture(tinyEffect()), mark());
    }

    void anotherEffectOrSizeIsAnotherPicture()
    {
        store().put(tinyEffect(), kEdge, mark());
        Effect other = tinyEffect();
        other.look.opacity *= 2.0F;
        QVERIFY(picture(other) != mark());
        QVERIFY(store().find(tinyEffect(), 2 * kEdge).isNull());
    }

    void fineAirIsCoarseInThumbnails()
    {
        Effect effect = tinyEffect();
        effect.air.enabled = true;
        effect.air.resolution = 32;
        const QImage coarse = renderThumbnail(effect, kEdge, {});
        effect.air.resolution = 128;
        QCOMPARE(renderThumbnail(effect, kEdge, {}), coarse);
    }

    void smokeThatGrowsIsShownAsItsTimelineHasIt()
    {
        Effect effect = tinyEffect();
        effect.timeline.length = 2; // far shorter than a life
        effect.timeline.prewarm = false;
        const QImage growing = renderThumbnail(effect, kEdge, {});
        effect.timeline.prewarm = true;
        QVERIFY(growing != renderThumbnail(effect, kEdge, {}));
    }

    void whatWasRenderedIsKept()
    {
        const QImage first = picture(tinyEffect());
        QCOMPARE(store().find(tinyEffect(), kEdge), first);
    }

    void aBrokenFileIsRenderedAnew()
    {
        const QImage first = picture(tinyEffect());
        const QFileInfoList files = QDir(m_folder.path()).entryInfoList(QDir::Files);
        QCOMPARE(files.size(), 1);
        QVERIFY(QFile::resize(files[0].filePath(), 40));
        QCOMPARE(picture(tinyEffect()), first);
    }

    void theFolderDoesNotGrowForEver()
    {
        QVERIFY(QDir().mkpath(m_folder.path()));
        constexpr int kMany = 450;
        for (int i = 0; i < kMany; ++i) {
            QFile file(m_folder.filePath(u"%1.png"_q.arg(i)));
            QVERIFY(file.open(QIODevice::WriteOnly));
        }
        store().prune();
        QCOMPARE(QDir(m_folder.path()).entryList(QDir::Files).size(), 400);
    }

private:
    [[nodiscard]] ThumbnailStore store() const { return ThumbnailStore(QDir(m_folder.path())); }

    /// What a thumbnailer of its own makes, as that of the next start would be.
    QImage picture(const Effect& effect)
    {
        Thumbnailer thumbnailer(store());
        QSignalSpy ready(&thumbnailer, &Thumbnailer::ready);
        thumbnailer.request(u"it"_q, effect, kEdge);
        return ready.wait(20000) ? ready[0][1].value<QImage>() : QImage();
    }

    QTemporaryDir m_folder;
};

FUMAGE_TEST_MAIN(ThumbnailTest)
#include "thumbnail_test.moc"
