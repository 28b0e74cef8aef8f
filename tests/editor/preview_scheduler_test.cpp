// Which pictures are asked for, shown and kept while an effect is changed and played: no window, no widget.
#include "editor_helpers.h"
#include "picture_helpers.h"

#include "ui/preview/preview_scheduler.h"

#include <set>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr qint64 kRoomy = 64LL * 1024 * 1024;
constexpr QSize kSize(160, 120);
constexpr qint64 kBytes = 160LL * 120 * 4; ///< of a picture of that size

/// So many particles that a hasty picture can only show some of them.
Effect largeEffect()
{
    Effect effect = smallEffect();
    effect.emitter.count = 200000;
    return effect;
}

PicturePtr pictureOf(int frame, bool complete, bool thinned = false, QSize size = kSize)
{
    auto picture = std::make_shared<Picture>();
    picture->image = QImage(size, QImage::Format_RGB32);
    picture->frame = frame;
    picture->complete = complete;
    picture->thinned = thinned;
    return picture;
}

/// A feed that is seen, on an effect, with all that it has sent.
struct Watched {
    PreviewScheduler feed;
    QList<PicturePtr> pictures;
    QList<PicturePtr> others;
    QList<bool> waiting;

    explicit Watched(const Effect& effect, qint64 cacheBytes = kRoomy)
        : feed(std::make_shared<AirCache>(3), cacheBytes)
    {
        QObject::connect(
            &feed, &PreviewScheduler::ready, &feed, [this](const PicturePtr& picture) { pictures += picture; });
        QObject::connect(
            &feed, &PreviewScheduler::otherReady, &feed, [this](const PicturePtr& picture) { others += picture; });
        QObject::connect(&feed, &PreviewScheduler::waitingChanged, &feed, [this](bool now) { waiting += now; });
        feed.setScene(effect, 0, DirtyStage::Simulate);
        feed.setSize(kSize);
        feed.setSeen(true);
    }
    [[nodiscard]] bool settles()
    {
        constexpr int kPatienceMs = 20000;
        return QTest::qWaitFor([&] { return feed.isSettled(); }, kPatienceMs);
    }
};

/// A loop in air that takes a while to be baked.
Effect loopInAir()
{
    Effect effect = smallEffect();
    effect.air.enabled = true;
    effect.air.resolution = 44;
    effect.timeline.loop = true;
    effect.timeline.length = 40;
    return effect;
}

/// Plays as the player does: the next frame when the picture of this one has come.
class Playing {
public:
    explicit Playing(Watched& watched, int length)
    {
        QObject::connect(
            &watched.feed, &PreviewScheduler::waitingChanged, &m_clock, [this](bool waiting) { m_held = waiting; });
        QObject::connect(&m_clock, &QTimer::timeout, &m_clock, [this, &watched, length] {
            if (!m_held) {
                m_frame = (m_frame + 1) % length;
                watched.feed.setFrame(m_frame);
            }
        });
        watched.feed.setPlaying(true);
        m_clock.start(5);
    }

private:
    QTimer m_clock;
    int m_frame = 0;
    bool m_held = true;
};

QImage whole(const Effect& effect, int frame)
{
    return PreviewRenderer().make(requestFor(effect, frame), {})->image;
}

} // namespace

class PreviewSchedulerTest : public QObject {
    Q_OBJECT

private slots:
    // --- layers -----------------------------------------------------------------------------------------------------

    void aSoloIsShownAndForgottenWithItsScene()
    {
        Scene scene = smallEffect();
        scene.layers.push_back(scene.layers[0]);
        scene.layers[1].emitter.seed = 5;
        scene.layers[1].emitter.position.x = 1.0F;
        Watched watched{Effect()};
        watched.feed.setScene(scene, 0, DirtyStage::Air);
        QVERIFY(watched.settles());
        const QImage both = watched.feed.picture()->image;
        watched.feed.setSolo({1});
        QVERIFY(!watched.feed.isSettled() && watched.feed.cachedFrames().isEmpty());
        QVERIFY(watched.settles());
        QVERIFY(watched.feed.picture()->image != both);
        for (const PicturePtr& picture : watched.pictures.mid(watched.pictures.size() - 1)) {
            QCOMPARE(picture->layers[0].particleSteps + picture->layers[1].particleSteps, 0.0);
        }
        watched.feed.setSolo({1}); // what is so already is no change
        QVERIFY(watched.feed.isSettled());
        watched.feed.setLayer(1); // of which nothing is shown
        QVERIFY(watched.feed.isSettled());
        watched.feed.setScene(scene, 0, DirtyStage::Shade);
        QVERIFY(watched.settles());
        QCOMPARE(watched.feed.picture()->image, both);
    }

    // --- the cache --------------------------------------------------------------------------------------------------

    void aCacheKeepsTheBestPictureOfAFrame()
    {
        PictureCache cache(10 * kBytes);
        const PicturePtr thinned = pictureOf(3, false, true);
        const PicturePtr coarse = pictureOf(3, false, false, kSize / 2);
        const PicturePtr finer = pictureOf(3, false, false);
        const PicturePtr complete = pictureOf(3, true);
        for (const PicturePtr& better : {thinned, coarse, finer, complete}) {
            cache.keep(better);
            QCOMPARE(cache.find(3), better);
        }
        for (const PicturePtr& worse : {thinned, coarse, finer}) {
            cache.keep(worse);
            QCOMPARE(cache.find(3), complete);
        }
        QVERIFY(cache.find(4) == nullptr);
    }

    void ofThinnedPicturesTheOneWithMoreParticlesIsBetter()
    {
        PictureCache cache(10 * kBytes);
        const auto thinned = [](int particles) {
            auto picture = std::make_shared<Picture>(*pictureOf(3, false, true));
            picture->particles = particles;
            return picture;
        };
        const PicturePtr many = thinned(5000);
        cache.keep(thinned(100));
        cache.keep(many);
        cache.keep(thinned(200));
        QCOMPARE(cache.find(3), many);
        QVERIFY(isBetter(*pictureOf(3, false), *many));
    }

    void aFullCacheKeepsWhatIsThere()
    {
        PictureCache cache(2 * kBytes);
        for (const int frame : {7, 5, 6}) {
            cache.keep(pictureOf(frame, true));
        }
        QCOMPARE(cache.frames(), QList<int>({5, 7}));
        cache.clear();
        QVERIFY(cache.frames().isEmpty());
        cache.keep(pictureOf(6, true));
        cache.keep(pictureOf(8, true));
        QCOMPARE(cache.frames(), QList<int>({6, 8}));
    }

    void aBetterPictureTakesThePlaceOfAWorseOneInAFullCache()
    {
        PictureCache cache(kBytes);
        cache.keep(pictureOf(1, false));
        const PicturePtr complete = pictureOf(1, true);
        cache.keep(complete);
        QCOMPARE(cache.find(1), complete);
    }

    // --- settling ---------------------------------------------------------------------------------------------------

    void aMovingHandGetsARoughPictureAndARestingOneTheWhole()
    {
        Watched watched(largeEffect());
        QTRY_VERIFY(!watched.pictures.isEmpty());
        QVERIFY(watched.pictures.first()->thinned && !watched.pictures.first()->complete);
        QVERIFY(!watched.feed.isSettled());
        QVERIFY(watched.settles());
        QCOMPARE(watched.pictures.last()->image, whole(largeEffect(), 0));
    }

    void somethingInBetweenComesBeforeAWholeThatTakesLong()
    {
        Effect effect = smallEffect();
        effect.emitter.count = kMaxParticles;
        Watched watched(effect);
        constexpr int kPatienceMs = 30000;
        QTRY_VERIFY_WITH_TIMEOUT(watched.pictures.size() >= 2, kPatienceMs);
        QVERIFY(watched.pictures[0]->thinned);
        QVERIFY(watched.pictures[1]->thinned);
        QVERIFY(watched.pictures[1]->particles > watched.pictures[0]->particles);
    }

    // --- playing ----------------------------------------------------------------------------------------------------

    void aLoopPlaysInCoarseAirWhileItsOwnIsBaked()
    {
        Watched watched(loopInAir());
        std::vector<double> shares;
        connect(&watched.feed, &PreviewScheduler::working, this, [&](Phase phase, double share) {
            if (phase == Phase::Air) {
                shares.push_back(share);
            }
        });
        const Playing playing(watched, 40);
        const auto isWhole = [](const PicturePtr& picture) { return !picture->coarseAir && !picture->thinned; };
        QTRY_VERIFY_WITH_TIMEOUT(std::any_of(watched.pictures.begin(), watched.pictures.end(), isWhole), 120000);
        std::set<int> moved;
        for (const PicturePtr& picture : watched.pictures) {
            if (picture->coarseAir) {
                moved.insert(picture->frame);
            }
        }
        QVERIFY2(moved.size() >= 5, std::to_string(moved.size()).c_str());
        QVERIFY(shares.size() > 5 && shares.front() < 0.5 && shares.back() > 0.9);
        const qsizetype before = watched.pictures.size();
        QTRY_VERIFY(watched.pictures.size() > before + 3); // and it goes on, in its own air
        QVERIFY(std::all_of(watched.pictures.begin() + before, watched.pictures.end(), isWhole));
        QVERIFY(!watched.feed.isStopped()); // nobody has stopped anything
    }

    void whatIsStoppedStaysAPreviewUntilItMayGoOn()
    {
        Effect effect = loopInAir();
        effect.air.resolution = 64;
        Watched watched(effect);
        const Playing playing(watched, 40);
        QTRY_VERIFY_WITH_TIMEOUT(
            !watched.pictures.isEmpty() && watched.pictures.last()->coarseAir, 60000); // which was baked for it
        QSignalSpy working(&watched.feed, &PreviewScheduler::working);
        QTRY_VERIFY_WITH_TIMEOUT(std::any_of(working.begin(), working.end(),
                                     [](const QList<QVariant>& each) { return each[0].value<Phase>() == Phase::Air; }),
            60000);
        watched.feed.stopWork();
        QVERIFY(watched.feed.isStopped());
        working.clear();
        const qsizetype before = watched.pictures.size();
        QTRY_VERIFY_WITH_TIMEOUT(watched.pictures.size() > before + 10, 60000); // it plays on
        QVERIFY(std::all_of(watched.pictures.begin() + before, watched.pictures.end(),
            [](const PicturePtr& picture) { return picture->coarseAir; }));
        QVERIFY(std::none_of(working.begin(), working.end(),
            [](const QList<QVariant>& each) { return each[0].value<Phase>() == Phase::Air; }));
        watched.feed.mayWork();
        QVERIFY(!watched.feed.isStopped());
        QTRY_VERIFY_WITH_TIMEOUT(!watched.pictures.last()->coarseAir, 120000);
    }

    void aStandingPictureThatIsStoppedIsAPreview()
    {
        Effect effect = loopInAir();
        effect.air.resolution = 64;
        Watched watched(effect);
        QSignalSpy working(&watched.feed, &PreviewScheduler::working);
        QTRY_VERIFY_WITH_TIMEOUT(std::any_of(working.begin(), working.end(),
                                     [](const QList<QVariant>& each) { return each[0].value<Phase>() == Phase::Air; }),
            60000);
        watched.feed.stopWork();
        QTRY_VERIFY(!watched.pictures.isEmpty());
        QVERIFY(watched.pictures.last()->coarseAir);
        Effect changed = effect;
        changed.wind.strength += 1.0F;
        watched.feed.setScene(changed, 0, DirtyStage::Simulate);
        QVERIFY(!watched.feed.isStopped()); // another question
    }

    void theNewestEffectIsTheOneThatIsShown()
    {
        Watched watched(smallEffect());
        Effect effect = smallEffect();
        constexpr int kChanges = 30;
        for (int i = 1; i <= kChanges; ++i) {
            effect.look.opacity = 0.1F * static_cast<float>(i);
            watched.feed.setScene(effect, 0, DirtyStage::Shade);
        }
        QVERIFY(watched.settles());
        QVERIFY(watched.pictures.size() < kChanges);
        QCOMPARE(watched.pictures.last()->image, whole(effect, 0));
    }

    void changesOfEveryStageAreSeen_data()
    {
        QTest::addColumn<QString>("key");
        for (const QString& key : {u"look.opacity"_q, u"noise.sharpness"_q, u"wind.strength"_q}) {
            QTest::newRow(qPrintable(key)) << key;
        }
    }
    void changesOfEveryStageAreSeen()
    {
        QFETCH(QString, key);
        Watched watched(smallEffect());
        watched.feed.setFrame(20);
        QVERIFY(watched.settles());
        const QImage before = watched.feed.picture()->image;
        Effect effect = smallEffect();
        const Parameter& parameter = *findParameter(key.toStdString());
        parameter.set(effect, 4.0F);
        watched.feed.setScene(effect, 0, parameter.dirties);
        QVERIFY(watched.settles());
        QVERIFY(watched.feed.picture()->image != before);
        QCOMPARE(watched.feed.picture()->image, whole(effect, 20));
    }

    void changesThatNobodySawAreNotForgotten()
    {
        // A change of the motion, then one of the look alone, before anything was made of the first.
        Watched watched(smallEffect());
        watched.feed.setFrame(20);
        QVERIFY(watched.settles());
        Effect effect = smallEffect();
        effect.wind.strength = 4.0F;
        watched.feed.setScene(effect, 0, DirtyStage::Simulate);
        effect.look.opacity = 0.5F;
        watched.feed.setScene(effect, 0, DirtyStage::Shade);
        QVERIFY(watched.settles());
        QCOMPARE(watched.feed.picture()->image, whole(effect, 20));
    }

    void sizeAndBackdropMakeNewPictures()
    {
        Watched watched(smallEffect());
        QVERIFY(watched.settles());
        watched.feed.setSize({80, 60});
        QVERIFY(!watched.feed.isSettled());
        QVERIFY(watched.settles());
        QCOMPARE(watched.feed.picture()->image.size(), QSize(80, 60));
        watched.feed.setBackdrop({Backdrop::Kind::Colour, {1.0F, 0.0F, 0.0F}});
        QVERIFY(watched.settles());
        QCOMPARE(watched.feed.picture()->image.pixelColor(0, 0), QColor(Qt::red));
    }

    void trailsAndSpritesComeWhereTheyAreWanted()
    {
        Watched watched(smallEffect());
        watched.feed.setFrame(20);
        QVERIFY(watched.settles());
        QVERIFY(watched.feed.picture()->trails.empty() && !watched.feed.picture()->sprites);
        watched.feed.setTrails(true);
        watched.feed.setSprites(true);
        QVERIFY(watched.settles());
        QVERIFY(!watched.feed.picture()->trails.empty() && watched.feed.picture()->sprites);
    }

    // --- playing ----------------------------------------------------------------------------------------------------

    void theClockWaitsForEachFrameThatIsNotThereYet()
    {
        Watched watched(smallEffect());
        QVERIFY(watched.settles());
        watched.feed.setPlaying(true);
        for (int frame = 1; frame <= 3; ++frame) {
            watched.waiting.clear();
            watched.feed.setFrame(frame);
            QCOMPARE(watched.waiting, QList<bool>{true});
            QTRY_COMPARE(watched.waiting, QList<bool>({true, false}));
            QCOMPARE(watched.feed.picture()->frame, frame);
        }
        QCOMPARE(watched.feed.cachedFrames(), QList<int>({0, 1, 2, 3}));
        // Again from the start: all of it is there at once.
        watched.waiting.clear();
        for (int frame = 0; frame <= 3; ++frame) {
            watched.feed.setFrame(frame);
            QCOMPARE(watched.feed.picture()->frame, frame);
        }
        QVERIFY(watched.waiting.isEmpty());
    }

    void aChangeEmptiesTheCache()
    {
        Watched watched(smallEffect());
        QVERIFY(watched.settles());
        QSignalSpy changes(&watched.feed, &PreviewScheduler::cacheChanged);
        watched.feed.setScene(largeEffect(), 0, DirtyStage::Simulate);
        QVERIFY(watched.feed.cachedFrames().isEmpty());
        QCOMPARE(changes.size(), 1);
        QTRY_COMPARE(watched.feed.cachedFrames(), QList<int>{0});
    }

    void playingShowsAllParticlesOnceTheHandRests()
    {
        Watched watched(largeEffect());
        watched.feed.setPlaying(true);
        QTRY_VERIFY(watched.feed.picture() && watched.feed.picture()->thinned);
        QTRY_VERIFY_WITH_TIMEOUT(!watched.feed.picture()->thinned, 20000);
    }

    void stoppingSharpensTheFrameThatIsSeen()
    {
        Effect effect = smallEffect();
        effect.output.quality = Quality::Final; // which a moving picture gives up
        Watched watched(effect);
        watched.feed.setPlaying(true);
        watched.feed.setFrame(5);
        QTRY_VERIFY(watched.feed.picture() && watched.feed.picture()->frame == 5);
        QVERIFY(!watched.feed.picture()->complete);
        watched.feed.setPlaying(false);
        QVERIFY(watched.settles());
        QCOMPARE(watched.feed.picture()->image, whole(effect, 5));
    }

    void anEarlierFrameThatComesLateDoesNotReplaceTheOneThatIsWanted()
    {
        Watched watched(largeEffect());
        QVERIFY(watched.settles());
        watched.feed.setPlaying(true); // nothing sharpens behind our back
        watched.feed.setFrame(60); // takes a while
        watched.feed.setFrame(0); // is kept
        QCOMPARE(watched.feed.picture()->frame, 0);
        QTRY_VERIFY_WITH_TIMEOUT(watched.feed.cachedFrames().contains(60), 20000);
        QCOMPARE(watched.feed.picture()->frame, 0);
    }

    // --- seen or not ------------------------------------------------------------------------------------------------

    void whatNobodySeesIsNotMade()
    {
        PreviewScheduler feed;
        QSignalSpy pictures(&feed, &PreviewScheduler::ready);
        QSignalSpy others(&feed, &PreviewScheduler::otherReady);
        QSignalSpy waiting(&feed, &PreviewScheduler::waitingChanged);
        feed.setScene(smallEffect(), 0, DirtyStage::Simulate);
        feed.setSize(kSize);
        feed.setOther(smallEffect());
        feed.setPlaying(true);
        feed.setFrame(3);
        feed.setPlaying(false);
        // Longer than a hand has to rest, and than a picture takes.
        QTimer timer;
        QSignalSpy turns(&timer, &QTimer::timeout);
        timer.start(5);
        QTRY_VERIFY(turns.size() > 100);
        QVERIFY(pictures.isEmpty() && others.isEmpty() && waiting.isEmpty());
        feed.setSeen(true);
        QTRY_VERIFY(feed.isSettled() && feed.otherPicture());
    }

    // --- the other effect -------------------------------------------------------------------------------------------

    void theOtherEffectIsSeenThroughTheSameCamera()
    {
        Watched watched(smallEffect());
        watched.feed.setFrame(20);
        Effect other = smallEffect();
        other.look.colour = {1.0F, 0.1F, 0.1F};
        watched.feed.setOther(other);
        QTRY_VERIFY(watched.feed.otherPicture() && watched.feed.otherPicture()->complete);
        Effect turned = smallEffect();
        turned.camera.yaw = 70.0F;
        watched.feed.setScene(turned, 0, DirtyStage::Shade);
        other.camera = turned.camera;
        const QImage expected = whole(other, 20);
        QTRY_COMPARE(watched.feed.otherPicture()->image, expected);
        QVERIFY(!watched.others.isEmpty());
    }

    void theOtherEffectFollowsFramesAndItsOwnChanges()
    {
        Watched watched(smallEffect());
        Effect other = smallEffect();
        watched.feed.setOther(other);
        watched.feed.setFrame(30);
        QTRY_VERIFY(watched.feed.otherPicture() && watched.feed.otherPicture()->frame == 30);
        other.wind.strength = 4.0F;
        watched.feed.setOther(other);
        const QImage expected = whole(other, 30);
        QTRY_COMPARE(watched.feed.otherPicture()->image, expected);
    }

    void noOtherEffectMeansNoPictureOfIt()
    {
        Watched watched(smallEffect());
        watched.feed.setOther(smallEffect());
        QTRY_VERIFY(watched.feed.otherPicture());
        watched.feed.setOther(std::nullopt);
        QVERIFY(!watched.feed.otherPicture());
        watched.others.clear();
        watched.feed.setFrame(10);
        QVERIFY(watched.settles());
        QVERIFY(watched.others.isEmpty());
    }
};

FUMAGE_TEST_MAIN(PreviewSchedulerTest)
#include "preview_scheduler_test.moc"
