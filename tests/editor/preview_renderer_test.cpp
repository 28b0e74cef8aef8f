// The previewRenderer that makes pictures, and the thread that it works on.
#include "editor_helpers.h"
#include "picture_helpers.h"

#include "ui/preview/cost_estimate.h"
#include "ui/preview/picture_worker.h"
#include "ui/preview/trails.h"

using namespace fumage;
using namespace fumage::tests;

namespace {

/// A layer that feeds the air, and one that only goes with it.
Scene smokeAndEmbers()
{
    Scene scene = smallEffect();
    Layer embers = scene.layers[0];
    embers.emitter.seed = 7;
    embers.emitter.count = 500;
    embers.motion.coupling = Coupling::Dragged;
    embers.source.feeds = false;
    embers.look.size *= 0.5F;
    scene.layers.push_back(embers);
    return scene;
}

RenderRequest requestFor(const Scene& scene, quint64 simulation)
{
    RenderRequest request = tests::requestFor(Effect());
    request.scene = std::make_shared<const Scene>(scene);
    request.simulation = simulation;
    return request;
}

/// That were taken for a picture, by layer.
std::vector<double> stepsOf(const Picture& picture)
{
    std::vector<double> steps;
    for (const LayerWork& layer : picture.layers) {
        steps.push_back(layer.particleSteps);
    }
    return steps;
}

/// Of any channel of any pixel.
int largestDifference(const QImage& one, const QImage& other)
{
    int largest = 0;
    for (int y = 0; y < one.height(); ++y) {
        for (int x = 0; x < one.width(); ++x) {
            const QRgb a = one.pixel(x, y);
            const QRgb b = other.pixel(x, y);
            largest = std::max(
                {largest, std::abs(qRed(a) - qRed(b)), std::abs(qGreen(a) - qGreen(b)), std::abs(qBlue(a) - qBlue(b))});
        }
    }
    return largest;
}

} // namespace

class PreviewRendererTest : public QObject {
    Q_OBJECT

private slots:
    void theSameFrameIsTheSamePictureWhateverCameBefore()
    {
        PreviewRenderer previewRenderer;
        const Effect effect = smallEffect();
        const QImage first = previewRenderer.make(requestFor(effect, 30), {})->image;
        QVERIFY(previewRenderer.make(requestFor(effect, 90), {}) != nullptr);
        QVERIFY(previewRenderer.make(requestFor(effect, 3), {}) != nullptr);
        QCOMPARE(previewRenderer.make(requestFor(effect, 30), {})->image, first);
        QCOMPARE(PreviewRenderer().make(requestFor(effect, 30), {})->image, first);
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
                        RenderRequest request = requestFor(effect, 3);
                        request.backdrop.colour = kColour;
                        request.backdrop.kind = kind;
                        const QImage image = PreviewRenderer().make(request, {})->image;
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
        PreviewRenderer previewRenderer;
        RenderRequest request = requestFor(smallEffect());
        request.simulation = 1;
        const QImage still = previewRenderer.make(request, {})->image;
        Effect windy = smallEffect();
        windy.wind.strength = 4.0F;
        request.scene = std::make_shared<const Scene>(windy);
        QCOMPARE(previewRenderer.make(request, {})->image, still); // the number is what counts
        request.simulation = 2;
        const QImage blown = previewRenderer.make(request, {})->image;
        QVERIFY(blown != still);
        QCOMPARE(blown, PreviewRenderer().make(requestFor(windy), {})->image);
    }

    void hasteGivesUpPixelsAndParticlesButSaysSo()
    {
        Effect effect = smallEffect();
        effect.emitter.count = 400000;
        PreviewRenderer previewRenderer;
        RenderRequest request = requestFor(effect, 10);
        request.previewQuality = PreviewQuality::Interactive;
        const PicturePtr hasty = previewRenderer.make(request, {});
        QVERIFY(hasty->thinned && !hasty->complete && hasty->particles < 400000);
        request.previewQuality = PreviewQuality::Full;
        const PicturePtr whole = previewRenderer.make(request, {});
        QVERIFY(whole->complete && !whole->thinned);
        QCOMPARE(whole->particles, 400000);
        QCOMPARE(whole->image.size(), QSize(160, 120));
    }

    /// A drag of the look shows the smoke that was there, and not another one.
    void aDragThatSimulatesNothingDrawsWhatIsThere()
    {
        Effect effect = smallEffect();
        effect.emitter.count = 400000;
        PreviewRenderer previewRenderer;
        const RenderRequest still = requestFor(effect, 10);
        const PicturePtr whole = previewRenderer.make(still, {});
        for (int i = 0; i < 3; ++i) {
            effect.look.opacity *= 1.001F;
            RenderRequest request = requestFor(effect, 10);
            request.previewQuality = PreviewQuality::Interactive;
            const PicturePtr dragged = previewRenderer.make(request, {});
            QVERIFY(dragged->thinned && !dragged->complete && dragged->particles < 400000);
            QCOMPARE(dragged->layers.front().particles, 400000);
            QCOMPARE(dragged->layers.front().particleSteps, 0.0);
        }
        QCOMPARE(previewRenderer.make(still, {})->image, whole->image);
    }

    void coarserAirStandsInWhileTheHandMoves()
    {
        Effect effect = smallEffect();
        effect.air.enabled = true;
        effect.air.resolution = 40;
        PreviewRenderer previewRenderer;
        RenderRequest request = requestFor(effect, 20);
        request.previewQuality = PreviewQuality::Interactive;
        const PicturePtr hasty = previewRenderer.make(request, {});
        QVERIFY(hasty->coarseAir && hasty->thinned && !hasty->complete);
        request.previewQuality = PreviewQuality::Full;
        const PicturePtr whole = previewRenderer.make(request, {});
        QVERIFY(whole->complete && !whole->coarseAir);
        QVERIFY(whole->image != hasty->image);
        // The air is there now: a look that is dragged keeps it.
        effect.look.opacity *= 1.5F;
        request = requestFor(effect, 20);
        request.previewQuality = PreviewQuality::Interactive;
        QVERIFY(!previewRenderer.make(request, {})->coarseAir);
        QCOMPARE(PreviewRenderer().make(requestFor(effect, 20), {})->image,
            previewRenderer.make(requestFor(effect, 20), {})->image);
    }

    void theAirIsBakedOnceAndTellsHowFarItIs()
    {
        Effect effect = smallEffect();
        effect.air.enabled = true;
        effect.air.resolution = 24;
        std::vector<double> shares;
        Phase last = Phase::Paint;
        PreviewRenderer previewRenderer(std::make_shared<AirCache>(2), [&](Phase phase, double share) {
            last = phase;
            if (phase == Phase::Air) {
                shares.push_back(share);
            }
        });
        RenderRequest request = requestFor(effect, 20);
        request.air = true;
        request.trails = true;
        const PicturePtr first = previewRenderer.make(request, {});
        QVERIFY(shares.size() > 2 && shares.front() < 0.5);
        QCOMPARE(shares.back(), 1.0);
        QCOMPARE(last, Phase::Idle);
        QVERIFY(std::is_sorted(shares.begin(), shares.end()));
        QVERIFY(first->bakeNs > 0 && !first->trails.empty());
        // Above the source it is warm and goes up.
        QVERIFY(std::any_of(first->air.begin(), first->air.end(),
            [](const AirArrow& arrow) { return arrow.heat > 0.3F && arrow.velocity.y > 0.1F; }));
        shares.clear();
        effect.look.size *= 1.5F;
        request = requestFor(effect, 20);
        const PicturePtr second = previewRenderer.make(request, {});
        QVERIFY(shares.empty() && second->bakeNs == 0 && second->air.empty());
    }

    void whatCannotBeMadeSaysWhy()
    {
        Effect effect = smallEffect();
        effect.air.enabled = true;
        effect.air.ground = true;
        effect.air.groundHeight = 3.0F;
        PictureWorker worker(std::make_shared<AirCache>(2));
        QSignalSpy failed(&worker, &PictureWorker::failed);
        worker.request(requestFor(effect));
        QTRY_COMPARE(failed.size(), 1);
        QVERIFY2(failed[0][0].value<Error>().text().find("under the ground") != std::string::npos,
            failed[0][0].value<Error>().text().c_str());
    }

    void aStoppedPictureIsNone()
    {
        Effect effect = smallEffect();
        effect.emitter.count = 1000000;
        std::stop_source source;
        source.request_stop();
        QVERIFY(PreviewRenderer().make(requestFor(effect), source.get_token()) == nullptr);
    }

    void theNewestRequestIsTheOneThatCounts()
    {
        PictureWorker worker(std::make_shared<AirCache>(2));
        QList<int> frames;
        connect(
            &worker, &PictureWorker::pictureReady, this, [&](const PicturePtr& picture) { frames += picture->frame; });
        for (int i = 0; i < 50; ++i) {
            worker.request(requestFor(smallEffect(), i));
        }
        QTRY_VERIFY(frames.contains(49));
        QVERIFY(frames.size() < 50);
        QCOMPARE(frames.last(), 49);
    }

    void trailsBeginAtTheEmitter()
    {
        Effect effect = smallEffect();
        effect.emitter.subframe = false;
        const std::vector<Trail> trails = findTrails(effect, 0, 60);
        int whole = 0;
        for (const Trail& trail : trails) {
            // Those that were born before the first frame that was looked at begin on their way.
            whole +=
                trail.size() > 5 && trail.size() < 55 && glm::length(trail.front()) <= effect.emitter.radius + 0.05F
                ? 1
                : 0;
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
        QCOMPARE(slow.particlesWithin(10'000'000, 100.0), CostEstimate::kMinParticles);
        for (const int count : {300'000, 1'000'000, 100'000, 8000}) {
            const int left = CostEstimate::halvedInto(count, 4000);
            QVERIFY(left >= 4000 && left < 8000);
        }
        QCOMPARE(CostEstimate::halvedInto(7999, 4000), 7999);
        QCOMPARE(CostEstimate::halvedInto(100, 4000), 100);
        QCOMPARE(CostEstimate::halvedInto(300'000, 200'000), 150'000);
    }

    // --- layers -----------------------------------------------------------------------------------------------------

    /// What a change leaves as it was is not simulated again, neither while the hand moves nor when it rests.
    void aChangeOfOneLayerSimulatesThatAlone_data()
    {
        QTest::addColumn<PreviewQuality>("quality");
        QTest::newRow("while the hand moves") << PreviewQuality::Interactive;
        QTest::newRow("playing") << PreviewQuality::Playback;
        QTest::newRow("at rest") << PreviewQuality::Full;
    }
    void aChangeOfOneLayerSimulatesThatAlone()
    {
        QFETCH(PreviewQuality, quality);
        Scene scene = smokeAndEmbers();
        PreviewRenderer previewRenderer;
        QVERIFY(stepsOf(*previewRenderer.make(requestFor(scene, 1), {}))[0] > 0.0);
        scene.layers[1].motion.gravity = 3.0F;
        RenderRequest request = requestFor(scene, 2);
        request.previewQuality = quality;
        const PicturePtr dragged = previewRenderer.make(request, {});
        QCOMPARE(stepsOf(*dragged)[0], 0.0);
        QVERIFY(stepsOf(*dragged)[1] > 0.0);
        QVERIFY(!dragged->thinned);
        request.previewQuality = PreviewQuality::Full;
        QCOMPARE(previewRenderer.make(request, {})->image, PreviewRenderer().make(requestFor(scene, 2), {})->image);
    }

    /// Nothing is simulated again but where the air changes.
    void theEyeOfALayerSimulatesNothing()
    {
        Scene scene = smokeAndEmbers();
        PreviewRenderer previewRenderer;
        const QImage both = previewRenderer.make(requestFor(scene, 1), {})->image;
        scene.layers[1].visible = false;
        RenderRequest request = requestFor(scene, 2);
        request.previewQuality = PreviewQuality::Interactive;
        const PicturePtr muted = previewRenderer.make(request, {});
        QCOMPARE(stepsOf(*muted), std::vector<double>{0.0});
        QVERIFY(!muted->thinned && muted->image != both);
        scene.layers[1].visible = true;
        request = requestFor(scene, 3);
        request.previewQuality = PreviewQuality::Interactive;
        QCOMPARE(stepsOf(*previewRenderer.make(request, {})), (std::vector<double>{0.0, 0.0}));
        request.previewQuality = PreviewQuality::Full;
        QCOMPARE(previewRenderer.make(request, {})->image, both);
        // A muted layer that has changed meanwhile is another.
        scene.layers[1].visible = false;
        QVERIFY(previewRenderer.make(requestFor(scene, 4), {}) != nullptr);
        scene.layers[1].visible = true;
        scene.layers[1].emitter.speed += 1.0F;
        const PicturePtr other = previewRenderer.make(requestFor(scene, 5), {});
        QVERIFY(stepsOf(*other)[0] == 0.0 && stepsOf(*other)[1] > 0.0);
        QCOMPARE(other->image, PreviewRenderer().make(requestFor(scene, 5), {})->image);
    }

    /// The others are neither drawn nor in the light; what moves stays as it is among all.
    void aSoloShowsItsLayersAloneInTheAirOfAll()
    {
        Scene scene = smokeAndEmbers();
        scene.air.enabled = true;
        scene.air.resolution = 20;
        PreviewRenderer previewRenderer;
        const PicturePtr all = previewRenderer.make(requestFor(scene, 1), {});
        RenderRequest request = requestFor(scene, 1);
        request.solo = {1};
        const PicturePtr embers = previewRenderer.make(request, {});
        QCOMPARE(stepsOf(*embers), (std::vector<double>{0.0, 0.0}));
        QVERIFY(embers->complete && embers->image != all->image);
        QCOMPARE(embers->particles, scene.layers[1].emitter.count);
        // As if the smoke could not be seen.
        Scene clear = scene;
        clear.layers[0].look.opacity = 0.0F;
        const QImage expected = previewRenderer.make(requestFor(clear, 1), {})->image;
        QVERIFY(largestDifference(embers->image, expected) <= 2);
        request.solo = {0, 1};
        QCOMPARE(previewRenderer.make(request, {})->image, all->image);
    }

    void whatIsSeenAtAPlaceIsFoundInTheSpritesThatAreThere()
    {
        Scene scene = smokeAndEmbers();
        scene.layers[0].emitter.position.x = -1.5F;
        scene.layers[1].emitter.position.x = 1.5F;
        scene.layers[1].look.size *= 4.0F;
        PreviewRenderer previewRenderer;
        RenderRequest request = requestFor(scene, 1);
        const PicturePtr before = previewRenderer.make(request, {});
        QCOMPARE(before->picked.number, quint64{0});
        const View view = windowView(scene, request.frame, request.width, request.height);
        const auto seenAt = [&](const glm::vec3& place) {
            const Projected at = project(view, place);
            request.pick = {request.pick.number + 1,
                {at.x / static_cast<float>(request.width), at.y / static_cast<float>(request.height)}};
            const PicturePtr picture = previewRenderer.make(request, {});
            return picture->picked.number == request.pick.number && picture->image == before->image
                ? picture->picked.layer
                : std::nullopt;
        };
        QCOMPARE(seenAt({-1.5F, 0.2F, 0.0F}), std::optional<std::size_t>(0));
        QCOMPARE(seenAt({1.5F, 0.2F, 0.0F}), std::optional<std::size_t>(1));
        // With a solo of the second it is the second still.
        request.solo = {1};
        request.revision = 2;
        request.pick = {9, {0.0F, 0.0F}};
        QCOMPARE(previewRenderer.make(request, {})->picked.layer, std::nullopt);
        const Projected at = project(view, {1.5F, 0.2F, 0.0F});
        request.pick = {10, {at.x / static_cast<float>(request.width), at.y / static_cast<float>(request.height)}};
        QCOMPARE(previewRenderer.make(request, {})->picked.layer, std::optional<std::size_t>(1));
    }

    /// Muting is of the file, and wins.
    void aSoloOfAMutedLayerShowsNothing()
    {
        Scene scene = smokeAndEmbers();
        scene.layers[1].visible = false;
        RenderRequest request = requestFor(scene, 1);
        request.solo = {1};
        const QImage image = PreviewRenderer().make(request, {})->image;
        QVERIFY(!image.isNull());
        QImage empty = image;
        empty.fill(image.pixel(0, 0));
        QCOMPARE(image, empty);
    }

    void finalQualityWaitsForAStillPicture()
    {
        Effect effect;
        effect.emitter.count = 500;
        effect.output.quality = Quality::Final;
        PreviewRenderer previewRenderer;
        RenderRequest request = requestFor(effect, 10);
        request.previewQuality = PreviewQuality::Playback;
        const PicturePtr moving = previewRenderer.make(request, {});
        QVERIFY(!moving->complete);
        request.previewQuality = PreviewQuality::Full;
        const PicturePtr still = previewRenderer.make(request, {});
        QVERIFY(still->complete);
        QVERIFY(still->particles > 4 * moving->particles);
    }
};

FUMAGE_TEST_MAIN(PreviewRendererTest)
#include "preview_renderer_test.moc"
