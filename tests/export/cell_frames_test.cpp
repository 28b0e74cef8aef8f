// Which frames the cells of a flipbook show: empty ones left out, and retimed by a curve.

#include "core/export/sheets/cell_frames.h"
#include "tests/helpers.h"

#include "core/system/file.h"
#include "core/export/plan.h"
#include "core/export/sheets/sheet.h"
#include "core/export/sheets/sheet_preview.h"
#include "core/export/sheets/trim.h"
#include "core/rendering/view_transform.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

using namespace fumage;
using namespace fumage::tests;

namespace {

/// A cloud that comes into the picture from the left and leaves it on the right.
Effect passingBy()
{
    Effect e = thesisEffect(400);
    e.emitter.mode = EmissionMode::Burst;
    e.emitter.shape = EmitterShape::Sphere;
    e.emitter.position = {-9.0F, 0.0F, 0.0F};
    e.emitter.normal = {1.0F, 0.0F, 0.0F};
    e.emitter.speed = 10.0F;
    e.life.fadeRate = 0.001F;
    e.look.size = 0.4F;
    e.camera.target = glm::vec3(0.0F);
    e.camera.distance = 9.0F;
    e.camera.pitch = 0.0F;
    e.camera.yaw = 0.0F;
    e.timeline.loop = false;
    e.output.width = 32;
    e.output.height = 24;
    return e;
}

bool showsSmoke(const Effect& effect, int frame)
{
    const Image image = render(effect, frame);
    float most = 0.0F;
    for (std::size_t i = 3; i < image.pixels.size(); i += 4) {
        most = std::max(most, image.pixels[i]);
    }
    return most >= 1.0F / 255.0F;
}

FlipbookOptions retimed(std::initializer_list<CurvePoint> points, FrameRange frames, int columns, int rows = 1)
{
    FlipbookOptions options;
    options.columns = columns;
    options.rows = rows;
    options.frames = frames;
    options.retime = Curve(points);
    return options;
}

/// Mean of the horizontal vectors of one cell, as a share of it, where there is smoke.
double meanMotion(const Effect& effect, const std::vector<int>& frames, int cell)
{
    PassSheet sheet;
    const Status status =
        renderSheet(effect, {frames}, static_cast<int>(frames.size()), {Pass::Colour, Pass::Motion}, sheet, {});
    if (!status) {
        qFatal("%s", status.error().text().c_str());
    }
    const PassPictures pictures(sheet, {Pass::Motion}, {});
    const DataImage motion = pictures.picture(Pass::Motion);
    const SheetCell at = sheet.grid.cell(cell);
    double sum = 0.0;
    double weight = 0.0;
    for (int y = 0; y < at.height; ++y) {
        for (int x = 0; x < at.width; ++x) {
            const double alpha = sheet.targets.of(PassTarget::Colour).at(at.left + x, at.top + y).a;
            sum += alpha * motion.values[static_cast<std::size_t>(((at.top + y) * motion.width + at.left + x) * 3)]
                * pictures.scales().motion;
            weight += alpha;
        }
    }
    return sum / weight;
}

} // namespace

class CellFramesTest : public QObject {
    Q_OBJECT

private slots:
    void framesWithoutSmokeAreLeftOut()
    {
        const Effect effect = passingBy();
        for (const int step : {1, 3}) {
            const FrameRange asked{1, 60, step};
            const Result<FrameRange> left = trimmed(effect, asked);
            QVERIFY2(left.ok(), left.ok() ? "" : left.error().text().c_str());
            QCOMPARE(left.value().step, step);
            QVERIFY(left.value().first > asked.first && left.value().last < asked.at(asked.count() - 1));
            QCOMPARE((left.value().first - asked.first) % step, 0);
            QVERIFY(showsSmoke(effect, left.value().first) && !showsSmoke(effect, left.value().first - step));
            QVERIFY(showsSmoke(effect, left.value().last) && !showsSmoke(effect, left.value().last + step));
        }
    }

    void framesThatAllHaveSmokeStay()
    {
        const Result<FrameRange> left = trimmed(passingBy(), {26, 28, 1});
        QCOMPARE(left.value().first, 26);
        QCOMPARE(left.value().last, 28);
    }

    void whatCannotBeTrimmedIsSaid()
    {
        const Result<FrameRange> nothing = trimmed(passingBy(), {0, 4, 1});
        QVERIFY(!nothing.ok());
        QVERIFY(nothing.error().text().find("frames 0 to 4") != std::string::npos);
        Effect loop = passingBy();
        loop.timeline.loop = true;
        const Result<FrameRange> turned = trimmed(loop, {0, 60, 1});
        QVERIFY(!turned.ok());
        QVERIFY(turned.error().text().find("loop") != std::string::npos);
    }

    void clearFlamesAreNoEmptyFrames()
    {
        Effect effect = passingBy();
        effect.look.opacity = 0.001F;
        QVERIFY(!trimmed(effect, {26, 28, 1}).ok());
        effect.glow.emission = 1000.0F;
        effect.glow.flameOpacity = 0.0F;
        QVERIFY(coverOf(effect.glow) == Cover::Light);
        QVERIFY(trimmed(effect, {26, 28, 1}).ok());
    }

    void aTrimmedFlipbookShowsWhatIsLeftAtItsSpeed()
    {
        const QTemporaryDir folder;
        ExportPlan plan;
        plan.kind = ExportKind::Flipbook;
        plan.output = folder.path().toStdString() + "/a.png";
        plan.frames = {0, 60, 1};
        plan.flipbook.columns = 4;
        plan.flipbook.rows = 2;
        plan.flipbook.trim = true;
        const Effect effect = passingBy();
        const FrameRange left = trimmed(effect, plan.frames).value();
        const auto done = runExport(effect, plan);
        QVERIFY2(done.ok(), done.ok() ? "" : done.error().text().c_str());
        const QJsonObject json =
            QJsonDocument::fromJson(QByteArray::fromStdString(readFile(done.value()->description, 10000).value()))
                .object();
        QCOMPARE(json["trimmed"].toObject()["first_frame"].toInt(), left.first);
        QCOMPARE(json["trimmed"].toObject()["last_frame"].toInt(), left.last);
        QCOMPARE(json["trimmed"].toObject()["to"].toInt(), 60);
        QCOMPARE(json["seconds"].toDouble(), left.count() / static_cast<double>(effect.timeline.frameRate));
        const auto preview = previewFlipbook(effect, plan, 64, 1 << 20);
        QVERIFY(near(preview.value()->cellsPerSecond, json["cells_per_second"].toDouble(), 1e-9));
        plan.flipbook.columns = plan.flipbook.rows = 7; // 49 of the 61 frames are asked for, and fewer are left
        QVERIFY(left.count() < 49);
        const auto tooMany = runExport(effect, plan);
        QVERIFY(!tooMany.ok());
        QVERIFY(tooMany.error().text().find("do not fill 49 cells") != std::string::npos);
    }

    void aStraightCurveChangesNothing()
    {
        for (const int cells : {1, 3, 7, 16, 49, 64}) {
            for (const int frames : {64, 65, 99, 120, 1000}) {
                const FlipbookOptions with = retimed({{0.0F, 0.0F}, {1.0F, 1.0F}}, {5, 4 + frames, 1}, cells);
                FlipbookOptions without = with;
                without.retime.reset();
                QVERIFY(framesOfCells(with) == framesOfCells(without));
            }
        }
    }

    void aCurveChoosesTheFrames()
    {
        QVERIFY(
            (framesOfCells(retimed({{0.0F, 0.5F}, {1.0F, 0.5F}}, {0, 99, 1}, 4)) == std::vector<int>{50, 50, 50, 50}));
        QVERIFY((framesOfCells(retimed({{0.0F, 1.0F}, {1.0F, 0.0F}}, {10, 109, 1}, 4))
            == std::vector<int>{109, 85, 60, 35}));
        QVERIFY((framesOfCells(retimed({{0.0F, 0.0F}, {0.5F, 1.0F}, {1.0F, 0.0F}}, {0, 99, 1}, 2))
            == std::vector<int>{0, 99}));
        QVERIFY((framesOfCells(retimed({{0.0F, 0.0F}, {1.0F, 0.5F}}, {0, 198, 2}, 5))
            == std::vector<int>{0, 20, 40, 60, 80}));
    }

    void curvesAreReadAsThoseOfParameters()
    {
        QVERIFY(
            parseRetime("[[0, 0], [0.3, 0.6], [1, 1]]").value() == (Curve{{0.0F, 0.0F}, {0.3F, 0.6F}, {1.0F, 1.0F}}));
        QCOMPARE(parseRetime("0.5").error().code, ErrorCode::WrongType);
        QCOMPARE(parseRetime("[[0, 0], [1]]").error().code, ErrorCode::WrongType);
        QCOMPARE(parseRetime("[[0, nan]]").error().code, ErrorCode::NotFinite);
        QCOMPARE(parseRetime("[[0, 0], [1, 1.5]]").error().code, ErrorCode::OutOfRange);
        QCOMPARE(parseRetime("[[1, 0], [0, 1]]").error().code, ErrorCode::OutOfRange);
    }

    void aSheetThatGoesBackHoldsItsFrames()
    {
        const Effect effect = everythingOn();
        const std::vector<int> frames =
            framesOfCells(retimed({{0.0F, 1.0F}, {0.5F, 0.0F}, {1.0F, 1.0F}}, {5, 40, 1}, 6));
        QVERIFY(!std::is_sorted(frames.begin(), frames.end()));
        PassSheet sheet;
        QVERIFY(renderSheet(effect, {frames}, 6, {Pass::Colour, Pass::Motion}, sheet, {}).ok());
        for (std::size_t cell = 0; cell < frames.size(); ++cell) {
            PassSheet alone;
            QVERIFY(renderSheet(effect, {{frames[cell]}}, 1, {Pass::Colour}, alone, {}).ok());
            const Image& expected = alone.targets.of(PassTarget::Colour);
            const SheetCell at = sheet.grid.cell(static_cast<int>(cell));
            for (int y = 0; y < at.height; ++y) {
                const float* row =
                    sheet.targets.of(PassTarget::Colour).row(y) + static_cast<std::ptrdiff_t>(at.left) * 4;
                QVERIFY(std::equal(row, row + static_cast<std::ptrdiff_t>(at.width) * 4, expected.row(y)));
            }
        }
    }

    void vectorsGoTheWayThatTheSheetIsPlayed()
    {
        Effect effect = passingBy();
        effect.emitter.count = 4000;
        effect.output.width = effect.output.height = 64;
        // 10 m/s at 9 m: focal length as a share of the picture, over the distance, a frame.
        const double share = 50.0 / static_cast<double>(kSensorMillimetres) * 10.0 / 9.0 / 30.0;
        const double forwards = meanMotion(effect, {25, 26, 27}, 1);
        QVERIFY(near(forwards, share, 0.1 * share));
        QVERIFY(near(meanMotion(effect, {27, 26, 25}, 1), -forwards, 0.05 * forwards));
        QVERIFY(near(meanMotion(effect, {26, 26, 26}, 1), 0.0, 1e-5));
        QVERIFY(near(meanMotion(effect, {27, 26, 25}, 2), -forwards, 0.1 * forwards)); // the last goes on as before
    }
};

QTEST_GUILESS_MAIN(CellFramesTest)
#include "cell_frames_test.moc"
