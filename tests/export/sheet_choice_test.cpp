// The choice between few large cells and many small ones: what fits, and what plays best.

#include "tests/helpers.h"

#include "core/export/sheets/sheet_optimizer.h"
#include "core/export/sheets/sheet_playback.h"

using namespace fumage;
using namespace fumage::tests;

namespace {

ExportPlan planOf(int frames)
{
    ExportPlan plan;
    plan.kind = ExportKind::Flipbook;
    plan.output = "a.png";
    plan.frames = {0, frames - 1, 1};
    return plan;
}

Output outputOf(int width, int height)
{
    Output output;
    output.width = width;
    output.height = height;
    return output;
}

/// Dense smoke that rises without changing.
Effect rising(float speed)
{
    Effect e = thesisEffect(2000);
    e.emitter.mode = EmissionMode::Burst;
    e.emitter.shape = EmitterShape::Sphere;
    e.emitter.speed = speed;
    e.life.fadeRate = 0.0001F;
    e.look.size = 0.4F;
    e.camera.target = {0.0F, 1.0F, 0.0F};
    e.camera.distance = 6.0F;
    e.timeline.loop = false;
    e.output.width = e.output.height = 64;
    return e;
}

} // namespace

class SheetChoiceTest : public QObject {
    Q_OBJECT

private slots:
    void sheetsFillTheBudgetAndNoMore()
    {
        ExportPlan plan = planOf(1000);
        plan.passes.add(Pass::Motion);
        plan.flipbook.packs.push_back(parsePack("m=alpha@1/3").value());
        constexpr std::int64_t kBudget = 1 << 20;
        const std::vector<SheetCandidate> all = sheetsWithin(kBudget, outputOf(480, 240), plan);
        QCOMPARE(all.size(), std::size_t{9});
        for (const SheetCandidate& each : all) {
            FlipbookOptions options = flipbookOf(plan);
            options.columns = each.columns;
            options.rows = each.rows;
            QCOMPARE(each.bytes, memoryOf(options, each.width, each.height).compressed);
            QVERIFY(each.bytes <= kBudget);
            QVERIFY(each.width <= 480 && each.height <= 240);
            QVERIFY(each.width % 12 == 0 && each.height % 12 == 0); // whole blocks, and thirds
            QVERIFY(std::abs(each.width - 2 * each.height) <= 24);
            // The next size would be too much, or larger than was asked for.
            QVERIFY(each.height == 240 || memoryOf(options, each.width + 36, each.height + 24).compressed > kBudget);
        }
    }

    /// Each layer has all pictures.
    void sheetsOfAllLayersFitIntoTheBudget()
    {
        ExportPlan plan = planOf(1000);
        plan.layers = LayerOutput::Stacked;
        constexpr std::int64_t kBudget = 1 << 20;
        for (const std::size_t layers : {1U, 3U, 8U}) {
            const auto of = static_cast<std::int64_t>(layers);
            const std::vector<SheetCandidate> all = sheetsWithin(kBudget, outputOf(480, 240), plan, layers);
            const std::vector<SheetCandidate> one = sheetsWithin(kBudget / of, outputOf(480, 240), plan);
            QCOMPARE(all.size(), one.size());
            for (std::size_t i = 0; i < all.size(); ++i) {
                QCOMPARE(all[i].width, one[i].width);
                QCOMPARE(all[i].bytes, one[i].bytes * of);
            }
        }
        // Together they are one sheet, however many they are; masks go four to a picture.
        FlipbookOptions options = flipbookOf(plan);
        options.layers.reset();
        const SheetMemory together = memoryOf(options, 64, 64, 5);
        QCOMPARE(together.compressed, memoryOf(options, 64, 64).compressed);
        options.passes.add(Pass::LayerMasks);
        QCOMPARE(memoryOf(options, 64, 64, 4).plain, 2 * together.plain);
        QCOMPARE(memoryOf(options, 64, 64, 5).plain, 3 * together.plain);
    }

    void wholeBlocksOfSmallPicturesCount()
    {
        // At 16 x 16 pixels the packed picture has 4 x 2: a block of 16 bytes, where its share of the largest sheet
        // would be 8.
        ExportPlan plan = planOf(8);
        plan.flipbook.packs.push_back(parsePack("m=alpha@1/16").value());
        QVERIFY(sheetsWithin(4 * 2 * 16 * 16 + 8, outputOf(64, 64), plan).empty());
        QCOMPARE(sheetsWithin(4 * 2 * 16 * 16 + 16, outputOf(64, 64), plan)[0].width, 16);
    }

    void aLargeBudgetLeavesCellsAsTheyAre()
    {
        for (const SheetCandidate& each : sheetsWithin(std::int64_t{1} << 40, outputOf(50, 30), planOf(300))) {
            QCOMPARE(each.width, 50);
            QCOMPARE(each.height, 30);
        }
    }

    void gridsThatTheFramesDoNotFillAreLeftOut()
    {
        const std::vector<SheetCandidate> all = sheetsWithin(1 << 24, outputOf(64, 64), planOf(40));
        QCOMPARE(all.back().columns * all.back().rows, 36);
        QVERIFY(sheetsWithin(1 << 24, outputOf(64, 64), planOf(7)).empty());
        QVERIFY(sheetsWithin(100, outputOf(64, 64), planOf(100)).empty());
    }

    void powersOfTwoAreKept()
    {
        ExportPlan plan = planOf(300);
        plan.flipbook.powerOfTwo = true;
        const std::vector<SheetCandidate> all = sheetsWithin(1 << 19, outputOf(300, 200), plan);
        QVERIFY(!all.empty());
        for (const SheetCandidate& each : all) {
            for (const int number : {each.columns, each.rows, each.width, each.height}) {
                QVERIFY((number & (number - 1)) == 0);
            }
            Effect effect;
            effect.output = outputOf(each.width, each.height);
            plan.flipbook.columns = each.columns;
            plan.flipbook.rows = each.rows;
            QCOMPARE(outputFor(effect, plan).value().width, each.width); // as it will be made
        }
    }

    void aSheetThatHasEveryFrameWholePlaysItAsItIs()
    {
        ExportPlan plan = planOf(16);
        plan.frames = {10, 25, 1};
        const Result<std::vector<SheetCandidate>> rated = rateSheets(everythingOn(), plan, 1 << 26);
        QVERIFY2(rated.ok(), rated.ok() ? "" : rated.error().text().c_str());
        QCOMPARE(rated.value().size(), std::size_t{2});
        QCOMPARE(rated.value()[1].decibels, 99.0); // 4 x 4
        QVERIFY(rated.value()[0].decibels < 60.0); // 4 x 2
        QCOMPARE(bestOf(rated.value()).rows, 4);
    }

    void whatStandsStillNeedsLargeCellsAndWhatMovesManyOfThem()
    {
        ExportPlan plan = planOf(64);
        constexpr std::int64_t kBudget = 64 * 64 * 8; // eight cells of whole size
        ExportPlan later = plan; // when all of the burst is there
        later.frames = {20, 83, 1};
        const std::vector<SheetCandidate> still = rateSheets(rising(0.0F), later, kBudget).value();
        QCOMPARE(bestOf(still).columns * bestOf(still).rows, 8);
        const std::vector<SheetCandidate> moving = rateSheets(rising(2.0F), plan, kBudget).value();
        QVERIFY(bestOf(moving).columns * bestOf(moving).rows > 16);
        // Vectors make do with fewer cells of the same size.
        plan.passes.add(Pass::Motion);
        const std::vector<SheetCandidate> along = rateSheets(rising(2.0F), plan, 2 * kBudget).value();
        QCOMPARE(along[0].width, moving[0].width);
        QVERIFY(along[0].decibels > moving[0].decibels + 3.0);
    }

    void ofEqualsTheSmallerIsTaken()
    {
        const std::vector<SheetCandidate> candidates{
            {4, 4, 64, 64, 200, 40.0}, {8, 4, 64, 64, 100, 40.0}, {8, 8, 64, 64, 50, 39.0}};
        QCOMPARE(bestOf(candidates).bytes, std::int64_t{100});
    }

    void aBudgetThatIsTooSmallIsSaid()
    {
        const auto rated = rateSheets(rising(1.0F), planOf(64), 100);
        QVERIFY(!rated.ok());
        QVERIFY(rated.error().text().find("100 bytes") != std::string::npos);
    }
};

QTEST_GUILESS_MAIN(SheetChoiceTest)
#include "sheet_choice_test.moc"
