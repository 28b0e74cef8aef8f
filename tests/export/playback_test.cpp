// A flipbook as engines play it.
#include "tests/helpers.h"

#include "core/export/sheets/sheet_preview.h"
#include "core/rendering/view_transform.h"

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr int kEdge = 16; ///< of a cell, pixels

/// Four cells side by side, each of one grey.
PassSheet greys()
{
    PassSheet sheet;
    sheet.grid = {4, 4, kEdge, kEdge};
    Image& colour = sheet.targets.targets[static_cast<std::size_t>(PassTarget::Colour)];
    colour.resize(4 * kEdge, kEdge);
    for (std::size_t i = 0; i < colour.pixels.size(); ++i) {
        colour.pixels[i] = 0.25F * static_cast<float>(i / 4 % (4 * kEdge) / kEdge);
    }
    return sheet;
}

/// Two cells, and in each a column of light: at 4 pixels from the left in the first, at 8 in the second.
PassSheet columnThatMoves()
{
    PassSheet sheet;
    sheet.grid = {2, 2, kEdge, kEdge};
    Image& colour = sheet.targets.targets[static_cast<std::size_t>(PassTarget::Colour)];
    colour.resize(2 * kEdge, kEdge);
    std::fill(colour.pixels.begin(), colour.pixels.end(), 0.0F);
    for (int y = 0; y < kEdge; ++y) {
        for (const int x : {4, kEdge + 8}) {
            std::fill_n(colour.row(y) + 4 * x, 4, 1.0F);
        }
    }
    return sheet;
}

/// What says that everything goes 4 pixels to the right from each cell to the next, in halves of a cell.
DataImage fourToTheRight()
{
    DataImage motion{2 * kEdge, kEdge, 3, true, RawArray<float>(std::size_t{2} * kEdge * kEdge * 3, 0.0F)};
    for (std::size_t i = 0; i < motion.values.size(); i += 3) {
        motion.values[i] = 4.0F / kEdge / 0.5F;
    }
    return motion;
}

ExportPlan planFor(int columns, int rows)
{
    ExportPlan plan;
    plan.kind = ExportKind::Flipbook;
    plan.output = "unwritten.png";
    plan.flipbook.columns = columns;
    plan.flipbook.rows = rows;
    plan.frames = {10, 10 + 2 * (columns * rows - 1), 2};
    return plan;
}

} // namespace

class PlaybackTest : public QObject {
    Q_OBJECT

private slots:
    void cellsAreMixedByTheTimeBetweenThem_data()
    {
        QTest::addColumn<double>("cell");
        QTest::addColumn<bool>("loops");
        QTest::addColumn<int>("blending");
        QTest::addColumn<float>("grey");
        QTest::newRow("the first") << 0.0 << false << 1 << 0.0F;
        QTest::newRow("between") << 1.5 << false << 1 << 0.375F;
        QTest::newRow("a quarter on") << 2.25 << false << 1 << 0.5625F;
        QTest::newRow("not blended") << 2.9 << false << 0 << 0.5F;
        QTest::newRow("from the last to the first") << 3.5 << true << 1 << 0.375F;
        QTest::newRow("the second round") << 5.0 << true << 1 << 0.25F;
        QTest::newRow("the last stays") << 3.5 << false << 1 << 0.75F;
        QTest::newRow("and stays") << 99.0 << false << 1 << 0.75F;
        QTest::newRow("without vectors a cross-fade") << 1.5 << false << 2 << 0.375F;
    }
    void cellsAreMixedByTheTimeBetweenThem()
    {
        QFETCH(double, cell);
        QFETCH(bool, loops);
        QFETCH(int, blending);
        QFETCH(float, grey);
        const PassSheet sheet = greys();
        Image picture;
        SheetPlayback(sheet).picture(cell, loops, static_cast<CellBlending>(blending), picture);
        QCOMPARE(picture.width, kEdge);
        QCOMPARE(picture.height, kEdge);
        for (const float value : picture.pixels) {
            QVERIFY(near(value, grey, 1e-6F));
        }
    }

    void vectorsMoveWhatACrossFadeShowsTwice()
    {
        const PassSheet sheet = columnThatMoves();
        const SheetPlayback playback(sheet, fourToTheRight(), 0.5F);
        Image picture;
        playback.picture(0.5, false, CellBlending::CrossFade, picture);
        QVERIFY(near(picture.at(4, 3).a, 0.5F, 1e-6F));
        QVERIFY(near(picture.at(8, 3).a, 0.5F, 1e-6F));
        playback.picture(0.5, false, CellBlending::Motion, picture);
        QVERIFY(near(picture.at(6, 3).a, 1.0F, 1e-6F));
        QVERIFY(near(picture.at(4, 3).a, 0.0F, 1e-6F));
        QVERIFY(near(picture.at(8, 3).a, 0.0F, 1e-6F));
    }

    void memoryIsThatOfBlocksAndOfPixels()
    {
        const SheetMemory one = memoryOf(2048, 2048, 1, ImageFormat::Png8);
        QCOMPARE(one.compressed, std::int64_t{4} << 20U);
        QCOMPARE(one.plain, std::int64_t{16} << 20U);
        QCOMPARE(memoryOf(5, 5, 1, ImageFormat::Png8).compressed, 64);
        QCOMPARE(memoryOf(8, 8, 3, ImageFormat::ExrHalf).plain, 3 * 8 * 8 * 8);
        QCOMPARE(memoryOf(8, 8, 1, ImageFormat::ExrFloat).plain, 8 * 8 * 16);
    }

    void aPreviewHasThePicturesThatWillBeWritten()
    {
        Effect effect = everythingOn();
        effect.output.width = 40;
        effect.output.height = 24;
        effect.output.background = Background::Transparent;
        ExportPlan plan = planFor(2, 2);
        plan.format = ImageFormat::ExrHalf;
        const auto preview = previewFlipbook(effect, plan, 320, 1 << 20U);
        QVERIFY(preview.ok());
        QVERIFY(preview.value()->isWhole);
        QVERIFY(near(preview.value()->cellsPerSecond, effect.timeline.frameRate / 2.0, 1e-9));
        Image picture;
        for (int cell = 0; cell < 4; ++cell) {
            preview.value()->playback->picture(cell, false, CellBlending::None, picture);
            const Image truth = render(effect, 10 + 2 * cell);
            QCOMPARE(picture.pixels.size(), truth.pixels.size());
            for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
                QCOMPARE(picture.pixels[i], std::min(truth.pixels[i], 1.0F));
            }
        }
    }

    void whatAPngHoldsIsShownAgain()
    {
        Effect effect = everythingOn();
        effect.output.width = 40;
        effect.output.height = 40;
        effect.output.exposure = 1.0F;
        effect.output.viewTransform = ViewTransform::Filmic;
        effect.output.background = Background::Transparent;
        const auto preview = previewFlipbook(effect, planFor(2, 2), 320, 1 << 20U);
        Image picture;
        EncodedImage<std::uint8_t> shown;
        EncodedImage<std::uint8_t> written;
        for (int cell = 0; cell < 4; ++cell) {
            preview.value()->playback->picture(cell, false, CellBlending::None, picture);
            encode(picture, preview.value()->output, shown);
            encode(render(effect, 10 + 2 * cell), effect.output, written, coverOf(effect.glow));
            for (std::size_t i = 0; i < written.pixels.size(); i += 4) {
                QCOMPARE(shown.pixels[i + 3], written.pixels[i + 3]);
                for (std::size_t channel = 0; channel < 3 && written.pixels[i + 3] > 0; ++channel) {
                    QVERIFY(std::abs(int(shown.pixels[i + channel]) - int(written.pixels[i + channel])) <= 1);
                }
            }
        }
    }

    void largeCellsAreShownSmaller()
    {
        Effect effect = thesisEffect(100);
        effect.output.width = 200;
        effect.output.height = 100;
        ExportPlan plan = planFor(2, 2);
        plan.passes.add(Pass::Motion);
        const auto byEdge = previewFlipbook(effect, plan, 50, 1 << 20U);
        QVERIFY(byEdge.ok());
        QVERIFY(!byEdge.value()->isWhole);
        QCOMPARE(byEdge.value()->sheet.grid.cellWidth, 50);
        QCOMPARE(byEdge.value()->sheet.grid.cellHeight, 25);
        QVERIFY(byEdge.value()->playback->hasMotion());
        const auto byPixels = previewFlipbook(effect, plan, 1000, 4 * 20 * 10);
        QCOMPARE(byPixels.value()->sheet.grid.cellWidth, 20);
    }

    void aPreviewCanBeGivenUp()
    {
        std::stop_source stop;
        stop.request_stop();
        const auto preview = previewFlipbook(thesisEffect(100), planFor(2, 2), 100, 1 << 20U, stop.get_token());
        QVERIFY(!preview.ok());
        QCOMPARE(preview.error().code, ErrorCode::Cancelled);
    }
};

QTEST_APPLESS_MAIN(PlaybackTest)
#include "playback_test.moc"
