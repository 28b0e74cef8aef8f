// After a fit the borders of every picture are clear, and the smoke fills what is between them.
#include "tests/helpers.h"

#include "core/export/fit_camera.h"
#include "core/export/plan.h"
#include "core/rendering/framing.h"
#include "core/rendering/renderer.h"
#include "core/simulation/simulator.h"

#include <QTemporaryDir>

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

    void withoutSmokeThereIsNothingToFit()
    {
        Effect effect = risingSmoke();
        effect.look.opacity = 0.0F;
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
