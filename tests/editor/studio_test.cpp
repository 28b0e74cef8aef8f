// The studio that makes pictures, and the thread that it works on.
#include "editor_helpers.h"
#include "picture_helpers.h"

#include "ui/pictures/haste.h"
#include "ui/pictures/picture_worker.h"
#include "ui/pictures/tracks.h"

using namespace fumage;
using namespace fumage::tests;

class StudioTest : public QObject {
    Q_OBJECT

private slots:
    void theSameFrameIsTheSamePictureWhateverCameBefore()
    {
        Studio studio;
        const Effect effect = smallEffect();
        const QImage first = studio.make(requestFor(effect, 30), {})->image;
        QVERIFY(studio.make(requestFor(effect, 90), {}) != nullptr);
        QVERIFY(studio.make(requestFor(effect, 3), {}) != nullptr);
        QCOMPARE(studio.make(requestFor(effect, 30), {})->image, first);
        QCOMPARE(Studio().make(requestFor(effect, 30), {})->image, first);
    }

    void whatIsBehindTheSmokeIsTheChosenColourInEveryView()
    {
        const auto bytes = [](const glm::vec3& colour) {
            const auto byte = [](float linear) { return static_cast<int>(srgbFromLinear(linear) * 255.0F + 0.5F); };
            return QColor(byte(colour.r), byte(colour.g), byte(colour.b)).rgb();
        };
        constexpr glm::vec3 kColour(0.0F, 1.0F, 0.3F);
        for (const ViewTransform transform : {ViewTransform::Standard, ViewTransform::Filmic}) {
            for (const float exposure : {-2.0F, 0.0F, 1.5F}) {
                for (const Background background : {Background::Transparent, Background::Colour}) {
                    for (const Backdrop::Kind kind : {Backdrop::Kind::Colour, Backdrop::Kind::Checker}) {
                        Effect effect = smallEffect();
                        effect.output.viewTransform = transform;
                        effect.output.exposure = exposure;
                        effect.output.background = background;
                        effect.output.backgroundColour = kColour;
                        effect.look.opacity = 0.0F;
                        PictureRequest request = requestFor(effect, 3);
                        request.backdrop.colour = kColour;
                        request.backdrop.kind = kind;
                        const QImage image = Studio().make(request, {})->image;
                        const bool isChecker = kind == Backdrop::Kind::Checker && background == Background::Transparent;
                        QCOMPARE(image.pixel(0, 0), bytes(isChecker ? glm::vec3(0.10F) : kColour));
                        QCOMPARE(image.pixel(16, 0), bytes(isChecker ? glm::vec3(0.16F) : kColour));
                    }
                }
            }
        }
    }

    void effectsOfOneSimulationShareTheirParticles()
    {
        Studio studio;
        PictureRequest request = requestFor(smallEffect());
        request.simulation = 1;
        const QImage still = studio.make(request, {})->image;
        Effect windy = smallEffect();
        windy.motion.wind = 4.0F;
        request.effect = std::make_shared<const Effect>(windy);
        QCOMPARE(studio.make(request, {})->image, still); // the number is what counts
        request.simulation = 2;
        const QImage blown = studio.make(request, {})->image;
        QVERIFY(blown != still);
        QCOMPARE(blown, Studio().make(requestFor(windy), {})->image);
    }

    void hasteGivesUpPixelsAndParticlesButSaysSo()
    {
        Effect effect = smallEffect();
        effect.emitter.count = 400000;
        Studio studio;
        PictureRequest request = requestFor(effect, 10);
        request.haste = Haste::Dragging;
        const PicturePtr hasty = studio.make(request, {});
        QVERIFY(hasty->thinned && !hasty->complete && hasty->particles < 400000);
        request.haste = Haste::None;
        const PicturePtr whole = studio.make(request, {});
        QVERIFY(whole->complete && !whole->thinned);
        QCOMPARE(whole->particles, 400000);
        QCOMPARE(whole->image.size(), QSize(160, 120));
    }

    void coarserAirStandsInWhileTheHandMoves()
    {
        Effect effect = smallEffect();
        effect.air.enabled = true;
        effect.air.resolution = 40;
        Studio studio;
        PictureRequest request = requestFor(effect, 20);
        request.haste = Haste::Dragging;
        const PicturePtr hasty = studio.make(request, {});
        QVERIFY(hasty->coarseAir && hasty->thinned && !hasty->complete);
        request.haste = Haste::None;
        const PicturePtr whole = studio.make(request, {});
        QVERIFY(whole->complete && !whole->coarseAir);
        QVERIFY(whole->image != hasty->image);
        // The air is there now: a look that is dragged keeps it.
        effect.look.opacity *= 1.5F;
        request = requestFor(effect, 20);
        request.haste = Haste::Dragging;
        QVERIFY(!studio.make(request, {})->coarseAir);
        QCOMPARE(Studio().make(requestFor(effect, 20), {})->image, studio.make(requestFor(effect, 20), {})->image);
    }

    void theAirIsBakedOnceAndTellsHowFarItIs()
    {
        Effect effect = smallEffect();
        effect.air.enabled = true;
        effect.air.resolution = 24;
        std::vector<double> shares;
        Phase last = Phase::Paint;
        Studio studio(std::make_shared<AirShelf>(2), [&](Phase phase, double share) {
            last = phase;
            if (phase == Phase::Air) {
                shares.push_back(share);
            }
        });
        PictureRequest request = requestFor(effect, 20);
        request.air = true;
        request.tracks = true;
        const PicturePtr first = studio.make(request, {});
        QVERIFY(shares.size() > 2 && shares.front() < 0.5);
        QCOMPARE(shares.back(), 1.0);
        QCOMPARE(last, Phase::Idle);
        QVERIFY(std::is_sorted(shares.begin(), shares.end()));
        QVERIFY(first->bakeNs > 0 && !first->tracks.empty());
        // Above the source it is warm and goes up.
        QVERIFY(std::any_of(first->air.begin(), first->air.end(), [](const AirArrow& arrow) { return arrow.heat > 0.3F && arrow.velocity.y > 0.1F; }));
        shares.clear();
        effect.look.size *= 1.5F;
        request = requestFor(effect, 20);
        const PicturePtr second = studio.make(request, {});
        QVERIFY(shares.empty() && second->bakeNs == 0 && second->air.empty());
    }

    void whatCannotBeMadeSaysWhy()
    {
        Effect effect = smallEffect();
        effect.air.enabled = true;
        effect.air.ground = true;
        effect.air.groundHeight = 3.0F;
        PictureWorker worker(std::make_shared<AirShelf>(2));
        QSignalSpy failed(&worker, &PictureWorker::failed);
        worker.request(requestFor(effect));
        QTRY_COMPARE(failed.size(), 1);
        QVERIFY2(failed[0][0].value<Error>().text().find("under the ground") != std::string::npos, failed[0][0].value<Error>().text().c_str());
    }

    void aStoppedPictureIsNone()
    {
        Effect effect = smallEffect();
        effect.emitter.count = 1000000;
        std::stop_source source;
        source.request_stop();
        QVERIFY(Studio().make(requestFor(effect), source.get_token()) == nullptr);
    }

    void theNewestRequestIsTheOneThatCounts()
    {
        PictureWorker worker(std::make_shared<AirShelf>(2));
        QList<int> frames;
        connect(&worker, &PictureWorker::pictureReady, this, [&](const PicturePtr& picture) { frames += picture->frame; });
        for (int i = 0; i < 50; ++i) {
            worker.request(requestFor(smallEffect(), i));
        }
        QTRY_VERIFY(frames.contains(49));
        QVERIFY(frames.size() < 50);
        QCOMPARE(frames.last(), 49);
    }

    void tracksBeginAtTheEmitter()
    {
        Effect effect = smallEffect();
        effect.emitter.subframe = false;
        const std::vector<Track> tracks = findTracks(effect, 60);
        int whole = 0;
        for (const Track& track : tracks) {
            // Those that were born before the first frame that was looked at begin on their way.
            whole += track.size() > 5 && track.size() < 55 && glm::length(track.front()) <= effect.emitter.radius + 0.05F ? 1 : 0;
        }
        QVERIFY(whole > 5);
    }

    void costsAreLearned()
    {
        CostEstimate costs;
        for (int i = 0; i < 30; ++i) {
            costs.noteSprites(1000, 1'000'000); // 1 us each
            costs.noteSteps(1'000'000.0, 10'000'000); // 10 ns each
            costs.notePixels(1e6, 10'000'000);
        }
        const int affordable = costs.particlesWithin(20'000'000, 1.0);
        QVERIFY(qAbs(affordable - 20'000'000 / 1010) < 100);
        QCOMPARE(costs.scaleWithin(30'000'000, 1000, 1.0, 1e6), 1.0);
        QVERIFY(costs.scaleWithin(30'000'000, 28000, 1.0, 1e6) < 1.0);
    }

    void aSlowMachineSeesMoreThanABlur()
    {
        CostEstimate slow;
        for (int i = 0; i < 30; ++i) {
            slow.noteSteps(1'000'000.0, 1'000'000'000); // 1 us each
        }
        QCOMPARE(slow.particlesWithin(10'000'000, 100.0), CostEstimate::kFewestParticles);
        for (const int count : {300'000, 1'000'000, 100'000, 8000}) {
            const int left = CostEstimate::halvedInto(count, 4000);
            QVERIFY(left >= 4000 && left < 8000);
        }
        QCOMPARE(CostEstimate::halvedInto(7999, 4000), 7999);
        QCOMPARE(CostEstimate::halvedInto(100, 4000), 100);
        QCOMPARE(CostEstimate::halvedInto(300'000, 200'000), 150'000);
    }

    void finalQualityWaitsForAStillPicture()
    {
        Effect effect;
        effect.emitter.count = 500;
        effect.output.quality = Quality::Final;
        Studio studio;
        PictureRequest request = requestFor(effect, 10);
        request.haste = Haste::Playing;
        const PicturePtr moving = studio.make(request, {});
        QVERIFY(!moving->complete);
        request.haste = Haste::None;
        const PicturePtr still = studio.make(request, {});
        QVERIFY(still->complete);
        QVERIFY(still->particles > 4 * moving->particles);
    }
};

FUMAGE_TEST_MAIN(StudioTest)
#include "studio_test.moc"
