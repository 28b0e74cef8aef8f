// After a fit the borders of every picture are clear, and the smoke fills what is between them.
#include "tests/helpers.h"

#include "core/base/parallel.h"
#include "core/export/fit_camera.h"
#include "core/export/plan.h"
#include "core/rendering/framing.h"
#include "core/rendering/renderer.h"
#include "core/simulation/simulator.h"

#include <limits>

#include <QTemporaryDir>

#include <glm/geometric.hpp>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr int kFrames = 40;

/// A few puffs that rise out of the picture.
Effect risingSmoke()
{
    Effect effect;
    effect.emitter.count = 1500;
    effect.timeline.length = kFrames;
    effect.output.width = 96;
    effect.output.height = 64;
    return effect;
}

/// Largest alpha on the border of any frame, and the most of the picture's width or height that smoke takes.
struct Fill {
    float border = 0.0F;
    float share = 0.0F;
};

Fill fillOf(const Effect& effect)
{
    const SampledEffect smoke = sampled(effect);
    Simulator simulator(smoke);
    Renderer renderer;
    Image image;
    Fill fill;
    const int width = effect.output.width;
    const int height = effect.output.height;
    int left = width;
    int right = 0;
    int top = height;
    int bottom = 0;
    for (int number = 0; number < kFrames; ++number) {
        if (!renderer.render(*simulator.frame(number).value(), smoke, width, height, image)) {
            qFatal("frame %d", number);
        }
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const float alpha = image.at(x, y).a;
                if (x == 0 || y == 0 || x == width - 1 || y == height - 1) {
                    fill.border = std::max(fill.border, alpha);
                }
                if (alpha >= 1.0F / 255.0F) {
                    left = std::min(left, x);
                    right = std::max(right, x + 1);
                    top = std::min(top, y);
                    bottom = std::max(bottom, y + 1);
                }
            }
        }
    }
    fill.share = std::max(static_cast<float>(right - left) / static_cast<float>(width),
        static_cast<float>(bottom - top) / static_cast<float>(height));
    return fill;
}

/// A ball of smoke that stays where it is.
Scene ball()
{
    Effect effect = risingSmoke();
    effect.air.enabled = false;
    effect.wind.strength = 0.0F;
    effect.motion.buoyancy = 0.0F;
    effect.emitter.shape = EmitterShape::Sphere;
    effect.emitter.radius = 0.3F;
    effect.emitter.speed = 0.05F;
    return effect;
}

/// The same, and sparks that weigh next to nothing beside it.
Scene ballAndSparks(const std::vector<glm::vec3>& places)
{
    Scene scene = ball();
    for (const glm::vec3& place : places) {
        Layer spark = scene.layers.front();
        spark.name = "spark " + std::to_string(scene.layers.size());
        spark.emitter.position = place;
        spark.emitter.count = 12;
        spark.emitter.radius = 0.005F;
        spark.emitter.speed = 0.0F;
        spark.look.size = 0.02F;
        scene.layers.push_back(spark);
    }
    return scene;
}

constexpr FrameRange kAllFrames{0, kFrames - 1, 1};

Camera cameraFor(const Scene& scene, float outliers = 0.0F)
{
    const Result<Camera> camera = fitCamera(scene, kAllFrames, outliers);
    if (!camera) {
        qFatal("%s", camera.error().text().c_str());
    }
    return camera.value();
}

constexpr glm::vec3 kAside{8.0F, 0.0F, 0.0F};

} // namespace

class FitCameraTest : public QObject {
    Q_OBJECT

private slots:
    void allSmokeIsInThePictureAndFillsIt_data()
    {
        QTest::addColumn<int>("mode");
        QTest::addColumn<float>("turntable");
        QTest::newRow("orbit") << static_cast<int>(CameraMode::Orbit) << 0.0F;
        QTest::newRow("fixed") << static_cast<int>(CameraMode::Fixed) << 0.0F;
        QTest::newRow("turntable") << static_cast<int>(CameraMode::Orbit) << 120.0F;
    }
    void allSmokeIsInThePictureAndFillsIt()
    {
        QFETCH(int, mode);
        QFETCH(float, turntable);
        Effect effect = risingSmoke();
        effect.camera.mode = static_cast<CameraMode>(mode);
        effect.camera.turntable = turntable;
        effect.camera.distance = 2.0F;
        effect.camera.position = {0.0F, 1.0F, 2.5F};
        QVERIFY2(fillOf(effect).border > 0.05F, "nothing to mend");
        const Result<Camera> camera = fitCamera(effect, {0, kFrames - 1, 1});
        QVERIFY(camera.ok());
        effect.camera = camera.value();
        const Fill fill = fillOf(effect);
        QVERIFY2(fill.border < 1.0F / 255.0F, qPrintable(QString::number(fill.border)));
        QVERIFY2(fill.share > 0.8F, qPrintable(QString::number(fill.share)));
    }

    void aFarCameraComesNearer()
    {
        Effect effect = risingSmoke();
        effect.camera.distance = 500.0F;
        effect.camera.target = {30.0F, 0.0F, 0.0F};
        effect.camera = fitCamera(effect, {0, kFrames - 1, 1}).value();
        const Fill fill = fillOf(effect);
        QVERIFY(fill.border < 1.0F / 255.0F);
        QVERIFY(fill.share > 0.8F);
    }

    void stretchedSmokeIsWholeToo()
    {
        Effect effect = risingSmoke();
        effect.emitter.speed = 6.0F;
        effect.look.stretch = 1.0F;
        effect.camera = fitCamera(effect, {0, kFrames - 1, 1}).value();
        QVERIFY(fillOf(effect).border < 1.0F / 255.0F);
    }

    void anExportThatFitsIsNotCutOff()
    {
        const QTemporaryDir folder;
        Effect effect = risingSmoke();
        effect.camera.distance = 2.0F;
        ExportPlan plan;
        plan.kind = ExportKind::Flipbook;
        plan.output = folder.path().toStdString() + "/book.png";
        plan.frames = {0, kFrames - 1, 1};
        plan.flipbook.columns = plan.flipbook.rows = 3;
        QVERIFY(runExport(effect, plan).value()->cutOff.has_value());
        plan.fitCamera = true;
        QVERIFY(!runExport(effect, plan).value()->cutOff);
    }

    /// Frames that no cell shows are not seen: a sheet of few cells may come nearer, and is quicker to fit.
    void aFlipbookIsFittedToTheFramesOfItsCells()
    {
        const Effect effect = risingSmoke();
        ExportPlan plan;
        plan.kind = ExportKind::Flipbook;
        plan.fitCamera = true;
        plan.frames = {0, kFrames - 1, 1};
        plan.flipbook.columns = 2;
        plan.flipbook.rows = 1;
        const std::array<int, 2> shown{0, kFrames / 2};
        const Camera ofCells = fitCamera(effect, shown, 0.0F).value();
        const Camera ofAll = fitCamera(effect, plan.frames).value();
        QVERIFY(ofCells != ofAll);
        QVERIFY(sceneSeenBy(effect, plan).value().camera == ofCells);

        // Backwards, and the same frame again: each counts once, in their order.
        plan.flipbook.columns = 4;
        plan.flipbook.retime = Curve{{{0.0F, 0.5F}, {0.25F, 0.0F}, {1.0F, 0.0F}}};
        QVERIFY(sceneSeenBy(effect, plan).value().camera == ofCells);

        // Which are left by trimming is not known before.
        plan.flipbook.retime.reset();
        plan.flipbook.trim = true;
        QVERIFY(sceneSeenBy(effect, plan).value().camera == ofAll);
    }

    void picturesAndVideosAreFittedToTheFramesThatTheyShow()
    {
        Effect effect = risingSmoke();
        for (const ExportKind kind :
            {ExportKind::Sequence, ExportKind::Video, ExportKind::Flipbook, ExportKind::Picture}) {
            ExportPlan plan;
            plan.kind = kind;
            plan.fitCamera = true;
            plan.frames = {8, 8, 1};
            const Effect seen = sceneSeenBy(effect, plan).value().effect();
            const Image image = render(seen, 8);
            const PictureReach reach = reachOf(image, 0.5F / 255.0F);
            const int width = image.width;
            QVERIFY(
                std::max(10 * (reach.right - reach.left) / width, 10 * (reach.bottom - reach.top) / image.height) >= 8);
            QVERIFY(std::abs(reach.left + reach.right - width) < width / 10); // in the middle
            QVERIFY(std::abs(reach.top + reach.bottom - image.height) < width / 10);
            QVERIFY(reach.left > 0 && reach.top > 0 && reach.right < width && reach.bottom < image.height);
        }
    }

    void sparksMayBeOutside_data()
    {
        QTest::addColumn<bool>("towardsTheCamera");
        QTest::addColumn<float>("turntable");
        QTest::newRow("aside") << false << 0.0F;
        QTest::newRow("aside and towards the camera") << true << 0.0F;
        QTest::newRow("around which a turntable goes") << false << 120.0F;
    }
    /// The smoke is as large as it is alone.
    void sparksMayBeOutside()
    {
        QFETCH(bool, towardsTheCamera);
        QFETCH(float, turntable);
        Scene alone = ball();
        Scene both = towardsTheCamera ? ballAndSparks({kAside, {0.0F, 0.0F, 4.0F}}) : ballAndSparks({kAside});
        alone.camera.turntable = both.camera.turntable = turntable;
        const Camera all = cameraFor(alone);
        const float withSparks = cameraFor(both).distance;
        QVERIFY2(withSparks > 2.0F * all.distance, qPrintable(QString::number(withSparks / all.distance)));

        const Camera found = cameraFor(both, 2.0F);
        const auto seen = [&] { return QString::number(found.distance / all.distance); };
        QVERIFY2(found.distance < 1.1F * all.distance, qPrintable(seen()));
        QVERIFY2(found.distance > 0.9F * cameraFor(alone, 2.0F).distance, qPrintable(seen()));
        QVERIFY(glm::distance(found.target, all.target) < 0.1F * all.distance);
        QCOMPARE(found.yaw, both.camera.yaw);
        QCOMPARE(found.focalLength, both.camera.focalLength);
    }

    void aGreaterShareNeverMakesTheSmokeSmaller()
    {
        const Scene scene = ballAndSparks({kAside, {-3.0F, 1.0F, 0.0F}, {0.5F, -2.0F, -1.0F}});
        float before = cameraFor(scene).distance;
        const float all = before;
        for (const float outliers : {0.1F, 0.5F, 1.0F, 2.0F, 3.0F, 5.0F}) {
            const float distance = cameraFor(scene, outliers).distance;
            QVERIFY2(distance < 1.01F * before, qPrintable(QString::number(outliers))); // a pixel of 256 each way
            before = distance;
        }
        QVERIFY(before < 0.5F * all);
    }

    void shareOfNothingIsTheCameraThatSeesAll()
    {
        const Scene scene = ballAndSparks({kAside});
        const Camera all = fitCamera(scene, kAllFrames).value();
        for (const float outliers : {0.0F, -1.0F, std::numeric_limits<float>::quiet_NaN()}) {
            QVERIFY(cameraFor(scene, outliers) == all);
        }
        QVERIFY(cameraFor(scene, 80.0F) == cameraFor(scene, kMaxOutlierPercent));
    }

    void twoOfAKindAreNoOutliers()
    {
        Scene scene = ball();
        scene.layers.push_back(scene.layers.front());
        scene.layers.back().name = "other";
        scene.layers.back().emitter.position = kAside;
        QVERIFY(cameraFor(scene, kMaxOutlierPercent).distance > 0.8F * cameraFor(scene).distance);
    }

    void outliersAreTheSameOnAnyNumberOfThreads()
    {
        const Scene scene = ballAndSparks({kAside});
        const Camera many = cameraFor(scene, 1.0F);
        const ThreadLimit one(1);
        QVERIFY(cameraFor(scene, 1.0F) == many);
    }

    void exportsLeaveOutliersOutside()
    {
        const Scene scene = ballAndSparks({kAside});
        ExportPlan plan;
        plan.kind = ExportKind::Flipbook;
        plan.frames = kAllFrames;
        plan.outlierPercent = 2.0F;
        QVERIFY(sceneSeenBy(scene, plan).value().camera == scene.camera); // nobody has asked for a fit
        plan.fitCamera = true;
        QVERIFY(sceneSeenBy(scene, plan).value().camera == cameraFor(scene, 2.0F));
    }

    void progressReachesItsEndWithOutliersToo()
    {
        int told = 0;
        int all = 0;
        const auto listener = [&](int done, int total) {
            QVERIFY(done >= told && done <= total);
            told = done;
            all = total;
        };
        QVERIFY(fitCamera(ballAndSparks({kAside}), {0, 8, 1}, 1.0F, {listener, {}}).ok());
        QCOMPARE(told, all);
    }

    void withoutSmokeThereIsNothingToFit()
    {
        Effect effect = risingSmoke();
        effect.look.opacity = 0.0F;
        QCOMPARE(fitCamera(effect, {0, 3, 1}, 1.0F).error().code, ErrorCode::OutOfRange);
        const Result<Camera> camera = fitCamera(effect, {0, 3, 1});
        QVERIFY(!camera.ok());
        QCOMPARE(camera.error().code, ErrorCode::OutOfRange);
    }

    void itCanBeStoppedAndTellsHowFarItIs()
    {
        const Effect effect = risingSmoke();
        std::stop_source stop;
        int told = 0;
        const auto listener = [&](int done, int total) {
            QVERIFY(done <= total);
            QCOMPARE(done, told + 1);
            told = done;
            if (done == 15) {
                stop.request_stop();
            }
        };
        const Result<Camera> camera = fitCamera(effect, {0, kFrames - 1, 1}, {listener, stop.get_token()});
        QCOMPARE(camera.error().code, ErrorCode::Cancelled);
        QVERIFY(told <= 16);
    }
};

QTEST_GUILESS_MAIN(FitCameraTest)
#include "fit_camera_test.moc"
