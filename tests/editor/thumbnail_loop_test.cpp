// Thumbnails that play.
#include "editor_helpers.h"
#include "picture_helpers.h"

#include "ui/presets/loop_player.h"
#include "ui/presets/preset_list.h"
#include "ui/presets/scene_card.h"
#include "ui/presets/thumbnailer.h"

#include "core/preset/library.h"

#include <QListWidget>
#include <QSignalSpy>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr int kEdge = 24;
constexpr int kEndMs = 240000; ///< what is done by then on a busy machine

Preset tinyPreset(const std::string& name)
{
    Preset preset;
    preset.name = name;
    preset.scene = tinyEffect();
    preset.scene.air.enabled = false;
    preset.scene.timeline.length = 48;
    return preset;
}

void moveMouse(QListWidget& list, const QListWidgetItem& item)
{
    const QPoint at = list.visualItemRect(&item).center();
    QMouseEvent event(
        QEvent::MouseMove, at, list.viewport()->mapToGlobal(at), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(list.viewport(), &event);
}

void leave(QListWidget& list)
{
    QEvent event(QEvent::Leave);
    QApplication::sendEvent(list.viewport(), &event);
}

} // namespace

class ThumbnailLoopTest : public QObject {
    Q_OBJECT

private slots:
    void cleanup()
    {
        QDir(m_folder.path()).removeRecursively();
        QDir(fromPath(userPresetFolder())).removeRecursively();
    }

    void aLoopGoesFromTheBeginningToTheEnd()
    {
        const Scene scene = tinyPreset("a").scene;
        const std::vector<QImage> loop = renderThumbnailLoop(scene, kEdge, 4);
        QCOMPARE(loop.size(), std::size_t{4});
        for (const QImage& frame : loop) {
            QCOMPARE(frame.size(), QSize(kEdge, kEdge));
        }
        QVERIFY(loop[0] != loop[3]);
        QVERIFY(renderThumbnailLoop(scene, kEdge, 4) == loop);
    }

    void whatIsStoppedIsEmpty()
    {
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(renderThumbnailLoop(tinyPreset("a").scene, kEdge, 4, stop.get_token()).empty());
    }

    void aLoopIsFoundOnTheDiskTheSecondTime()
    {
        const Scene scene = tinyPreset("a").scene;
        QImage first;
        {
            LoopPlayer player(store());
            player.start(u"a"_q, scene, kEdge);
            QVERIFY(player.frame().isNull());
            QTRY_VERIFY_WITH_TIMEOUT(!player.frame().isNull(), kEndMs);
            QCOMPARE(player.rendered(), 1);
            first = store().findLoop(scene, kEdge, LoopPlayer::kFrames).front();
        }
        LoopPlayer player(store());
        player.start(u"a"_q, scene, kEdge);
        QTRY_VERIFY_WITH_TIMEOUT(!player.frame().isNull(), kEndMs);
        QCOMPARE(player.rendered(), 0);
        QVERIFY(store().findLoop(scene, kEdge, LoopPlayer::kFrames).front() == first);
        QVERIFY(store().find(scene, kEdge).isNull()); // it is not taken for the picture that stands still
        QVERIFY(store().findLoop(scene, kEdge, LoopPlayer::kFrames - 1).empty());
        QVERIFY(store().findLoop(scene, kEdge + 1, LoopPlayer::kFrames).empty());
    }

    void itPlaysUntilItIsStopped()
    {
        LoopPlayer player(store());
        QSignalSpy moved(&player, &LoopPlayer::moved);
        player.start(u"a"_q, tinyPreset("a").scene, kEdge);
        QTRY_VERIFY_WITH_TIMEOUT(moved.size() > 3, kEndMs);
        player.stop();
        QVERIFY(player.name().isEmpty() && player.frame().isNull());
        const qsizetype until = moved.size();
        QCOMPARE(moved[until - 1][0].toString(), u"a"_q); // which stands still from then on
        QTest::qWait(3 * LoopPlayer::kFrameMs);
        QCOMPARE(moved.size(), until);
    }

    void whatIsLeftBeforeItIsThereNeverComes()
    {
        LoopPlayer player;
        player.start(u"a"_q, tinyPreset("a").scene, kEdge);
        player.stop();
        player.start(u"b"_q, tinyPreset("b").scene, kEdge);
        QTRY_VERIFY_WITH_TIMEOUT(!player.frame().isNull(), kEndMs);
        QCOMPARE(player.name(), u"b"_q);
        QCOMPARE(player.rendered(), 1);
    }

    void aBrokenFileIsRenderedAnew()
    {
        const Scene scene = tinyPreset("a").scene;
        store().putLoop(
            scene, kEdge, std::vector<QImage>(LoopPlayer::kFrames, QImage(kEdge, kEdge, QImage::Format_RGB32)));
        const QFileInfoList files = QDir(m_folder.path()).entryInfoList(QDir::Files);
        QCOMPARE(files.size(), 1);
        QVERIFY(QFile::resize(files[0].filePath(), 40));
        LoopPlayer player(store());
        player.start(u"a"_q, scene, kEdge);
        QTRY_VERIFY_WITH_TIMEOUT(!player.frame().isNull(), kEndMs);
        QCOMPARE(player.rendered(), 1);
    }

    void thePresetUnderThePointerPlays()
    {
        PresetList list(kEdge);
        QListWidgetItem* item = shown(list);
        QVERIFY(item != nullptr);
        moveMouse(list, *item);
        QCOMPARE(list.player().name(), list.idOf(item));
        QTRY_VERIFY_WITH_TIMEOUT(!list.player().frame().isNull(), kEndMs);
        leave(list);
        QVERIFY(list.player().name().isEmpty());
    }

    void thePresetThatTheKeyboardIsOnPlays()
    {
        PresetList list(kEdge);
        QListWidgetItem* item = shown(list);
        QVERIFY(item != nullptr);
        list.activateWindow();
        list.setFocus();
        QVERIFY(QTest::qWaitForWindowActive(&list));
        list.setCurrentItem(list.item(1));
        list.setCurrentItem(item);
        QCOMPARE(list.player().name(), list.idOf(item));
    }

    void aListThatIsHiddenOrToldToRestPlaysNothing()
    {
        PresetList list(kEdge);
        QListWidgetItem* item = shown(list);
        QVERIFY(item != nullptr);
        moveMouse(list, *item);
        QVERIFY(!list.player().name().isEmpty());
        list.hide();
        QVERIFY(list.player().name().isEmpty());
        moveMouse(list, *item);
        QVERIFY(list.player().name().isEmpty());
        list.show();
        list.setPlays(false);
        moveMouse(list, *list.item(1));
        moveMouse(list, *item);
        QVERIFY(list.player().name().isEmpty());
    }

    void someComeFirst()
    {
        PresetList list(kEdge);
        list.setFirst({u"torch"_q, u"blast"_q, u"of nobody"_q});
        list.reload();
        QTRY_VERIFY(list.itemOfId(u"volcano"_q) != nullptr); // the last of all
        QCOMPARE(list.idOf(list.item(0)), u"torch"_q);
        QCOMPARE(list.idOf(list.item(1)), u"blast"_q);
        QVERIFY(!list.descriptionOf(list.item(0)).isEmpty());
    }

    void aCardPlaysByItselfWhileItIsSeen()
    {
        SceneCard card;
        QSignalSpy clicked(&card, &SceneCard::clicked);
        card.show();
        QVERIFY(!card.isEnabled() && card.preset() == nullptr);
        card.setPreset(tinyPreset("a"), u"Name"_q, u"Description"_q);
        QVERIFY(card.isEnabled());
        QCOMPARE(card.accessibleName(), u"Name"_q);
        QTRY_VERIFY_WITH_TIMEOUT(!card.player().frame().isNull(), kEndMs);
        card.hide();
        QVERIFY(card.player().name().isEmpty());
        card.setPlays(false);
        card.show();
        QVERIFY(card.player().name().isEmpty());
        QTest::mouseClick(&card, Qt::LeftButton);
        QCOMPARE(clicked.size(), 1);
    }

    void theCacheComesDownToASize()
    {
        const Scene scene = tinyPreset("a").scene;
        QImage noise(64, 64, QImage::Format_RGB32);
        noise.fill(Qt::red);
        for (int edge = 64; edge < 68; ++edge) {
            store().put(scene, edge, noise.scaled(edge, edge));
        }
        const qint64 all = store().size();
        QVERIFY(all > 0);
        store().prune(all);
        QCOMPARE(store().size(), all);
        store().prune(all - 1);
        QVERIFY(store().size() < all && store().size() > 0);
        store().clear();
        QCOMPARE(store().size(), 0);
    }

private:
    [[nodiscard]] ThumbnailStore store() const { return ThumbnailStore(QDir(m_folder.path())); }

    /// A list that is seen, with a tiny preset of the user's among the others.
    QListWidgetItem* shown(PresetList& list)
    {
        const std::filesystem::path file = userPresetFolder() / "tiny.json";
        QDir().mkpath(fromPath(userPresetFolder()));
        if (!writePresetFile(file, tinyPreset("Tiny"))) {
            return nullptr;
        }
        list.resize(400, 300);
        list.show();
        list.reload();
        const bool came = QTest::qWaitFor([&] { return list.itemOfId(u"volcano"_q) != nullptr; }, kEndMs);
        return came ? list.itemOfId(fromPath(file)) : nullptr;
    }

    QTemporaryDir m_folder;
};

FUMAGE_TEST_MAIN(ThumbnailLoopTest)
#include "thumbnail_loop_test.moc"
