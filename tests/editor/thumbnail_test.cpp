// Small pictures that are kept from one start to the next.
#include "editor_helpers.h"
#include "picture_helpers.h"

#include "ui/presets/shipped_thumbnails.h"
#include "ui/presets/thumbnailer.h"

#include "core/preset/library.h"

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

    void everyBuiltInPresetBringsItsPicture()
    {
        const QByteArray folder = qgetenv("FUMAGE_WRITE_THUMBNAILS"); // ./dev thumbnails
        for (const LibraryEntry& entry : builtinPresets()) {
            const Scene scene = loadPreset(entry).value().preset.scene;
            const QString file = shippedThumbnailFile(QString::fromStdString(entry.id), scene);
            if (!folder.isEmpty()) {
                constexpr int kQuality = 85;
                QVERIFY(isThumbnailShipped(scene)
                    || renderThumbnail(scene, kShippedThumbnailEdge)
                           .save(QString::fromLocal8Bit(folder) + u'/' + file, "JPG", kQuality));
                continue;
            }
            QVERIFY2(isThumbnailShipped(scene),
                qPrintable(file + u" is missing: the preset has changed, ./dev thumbnails makes its picture"_q));
            QVERIFY2(showsSomething(shippedThumbnail(scene, kShippedThumbnailEdge)), qPrintable(file));
        }
    }

    void noPictureIsShippedThatNobodyShows()
    {
        QStringList wanted;
        for (const LibraryEntry& entry : builtinPresets()) {
            wanted += shippedThumbnailFile(QString::fromStdString(entry.id), loadPreset(entry).value().preset.scene);
        }
        qint64 bytes = 0;
        const QFileInfoList shipped = QDir(u":/thumbnails"_q).entryInfoList();
        for (const QFileInfo& file : shipped) {
            QVERIFY2(wanted.contains(file.fileName()) || qEnvironmentVariableIsSet("FUMAGE_WRITE_THUMBNAILS"),
                qPrintable(file.fileName() + u" is of no preset: ./dev thumbnails"_q));
            bytes += file.size();
        }
        QVERIFY2(bytes < static_cast<qint64>(builtinPresets().size()) * 16 * 1024, qPrintable(QString::number(bytes)));
    }

    void whatIsAtHandDoesNotWaitForWhatIsRendered()
    {
        Thumbnailer thumbnailer(store());
        QSignalSpy ready(&thumbnailer, &Thumbnailer::ready);
        thumbnailer.request(u"first"_q, tinyEffect(), kEdge); // may have begun before the others are asked for
        Effect slow = tinyEffect();
        slow.emitter.count = 100000;
        thumbnailer.request(u"slow"_q, slow, kEdge);
        for (const LibraryEntry& entry : builtinPresets()) {
            thumbnailer.request(QString::fromStdString(entry.id), loadPreset(entry).value().preset.scene, kEdge);
        }
        const qsizetype all = static_cast<qsizetype>(builtinPresets().size()) + 2;
        QTRY_COMPARE_WITH_TIMEOUT(ready.size(), all, 60000);
        const auto place = [&](const QString& name) {
            return std::find_if(ready.begin(), ready.end(), [&](const QList<QVariant>& each) {
                return each[0].toString() == name;
            }) - ready.begin();
        };
        QVERIFY(place(u"slow"_q) <= 1 || place(u"slow"_q) == all - 1); // it had begun, or it comes last
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
