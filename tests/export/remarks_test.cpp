// What is said of an export before it begins.

#include "core/export/remarks.h"
#include "tests/export/small_smoke.h"
#include "tests/pictures.h"

#include <QtTest/QtTest>

using namespace fumage;
using namespace fumage::tests;

namespace {

std::string saidOf(const Effect& effect, const ExportPlan& plan)
{
    std::string all;
    for (const Message& remark : remarksOn(effect, plan)) {
        all += remark.text() + "\n";
    }
    return all;
}

} // namespace

class RemarksTest : public QObject {
    Q_OBJECT

private slots:
    void presetsThatPicturesCannotCarryAreNamed()
    {
        ExportPlan plan;
        plan.kind = ExportKind::Picture;
        plan.project = Preset();
        Scene scene = smallSmoke();
        scene.layers[0].emitter.picture = ramp(9, 9);
        const auto said = [&] {
            std::string all;
            for (const Message& remark : remarksOn(scene, plan)) {
                all += remark.text();
            }
            return all;
        };
        QCOMPARE(said(), std::string());
        for (std::uint32_t i = 1; i < 7; ++i) {
            scene.layers.push_back(scene.layers[0]);
            scene.layers.back().look.picture = incompressible(250, i);
        }
        QVERIFY(said().find("save it beside") != std::string::npos);
        plan.project.reset();
        QCOMPARE(said(), std::string());
    }

    void framesThatDoNotCloseALoopAreNamedWithThoseThatWould_data()
    {
        QTest::addColumn<FrameRange>("frames");
        QTest::addColumn<QString>("whole");
        QTest::newRow("too few") << FrameRange{0, 63, 1} << "frames 0-89 ";
        QTest::newRow("one more") << FrameRange{0, 90, 1} << "frames 0-89 ";
        QTest::newRow("steps that do not divide it") << FrameRange{0, 89, 7} << "frames 0-84:6 ";
    }
    void framesThatDoNotCloseALoopAreNamedWithThoseThatWould()
    {
        QFETCH(FrameRange, frames);
        QFETCH(QString, whole);
        Effect effect = smallSmoke();
        effect.timeline.loop = true;
        effect.timeline.length = 90;
        for (std::size_t kind = 0; kind < kExportKinds; ++kind) {
            for (const VideoFormat video : kAllVideoFormats) {
                ExportPlan plan;
                plan.kind = static_cast<ExportKind>(kind);
                plan.video.format = video;
                plan.flipbook.columns = plan.flipbook.rows = 3;
                plan.frames = frames;
                const bool isPlayed =
                    plan.kind == ExportKind::Flipbook || (plan.kind == ExportKind::Video && saysHowOften(video));
                QCOMPARE(saidOf(effect, plan).find(whole.toStdString()) != std::string::npos, isPlayed);
                plan.frames = {0, 89, 1};
                QCOMPARE(saidOf(effect, plan), std::string());
                plan.frames = frames;
                plan.video.repeat = Repeat::Once;
                QCOMPARE(saidOf(effect, plan).empty(), plan.kind != ExportKind::Flipbook);
                Effect once = effect;
                once.timeline.loop = false;
                QCOMPARE(saidOf(once, plan), std::string());
            }
        }
    }

    void aCurveThatEndsElsewhereIsSaidToPlayOnce()
    {
        Effect effect = smallSmoke();
        effect.timeline.loop = true;
        effect.timeline.length = 90;
        ExportPlan plan;
        plan.kind = ExportKind::Flipbook;
        plan.frames = {0, 89, 1};
        plan.flipbook.retime = Curve({{0.0F, 0.0F}, {1.0F, 0.5F}});
        QVERIFY(saidOf(effect, plan).find("the curve of the frames") != std::string::npos);
        plan.flipbook.retime = Curve({{0.0F, 0.0F}, {0.5F, 1.0F}, {1.0F, 0.0F}});
        QCOMPARE(saidOf(effect, plan), std::string());
    }

    void whatIsLeftOutOfAGifIsSaid()
    {
        Effect effect = smallSmoke();
        ExportPlan plan;
        plan.kind = ExportKind::Video;
        plan.frames = {0, 23, 1};
        for (const int rate : {24, 25, 30, 50, 60, 120, 240}) {
            effect.timeline.frameRate = rate;
            for (const VideoFormat video : kAllVideoFormats) {
                plan.video.format = video;
                QCOMPARE(saidOf(effect, plan).find("is in the GIF") != std::string::npos,
                    video == VideoFormat::Gif && rate > 50);
            }
        }
    }

    void evenEdgesAreSaid()
    {
        Effect effect = smallSmoke();
        effect.output.width = 65;
        ExportPlan plan;
        plan.kind = ExportKind::Video;
        for (const VideoFormat video : kAllVideoFormats) {
            plan.video.format = video;
            QCOMPARE(saidOf(effect, plan).find("66 x 24") != std::string::npos, video == VideoFormat::Mp4);
        }
    }
};

QTEST_APPLESS_MAIN(RemarksTest)
#include "remarks_test.moc"
