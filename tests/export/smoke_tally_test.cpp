// What is cut off is what needs the most room for the least smoke, and never more than may be.
#include "tests/helpers.h"

#include "core/export/smoke_tally.h"

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr int kWidth = 64;
constexpr int kHeight = 48;
constexpr float kAlpha = 0.01F;
constexpr double kMaxShare = 0.05;

Image clearImage()
{
    Image image;
    image.resize(kWidth, kHeight);
    std::fill(image.pixels.begin(), image.pixels.end(), 0.0F);
    return image;
}

void fill(Image& image, const PictureReach& box, float alpha)
{
    for (int y = box.top; y < box.bottom; ++y) {
        for (int x = box.left; x < box.right; ++x) {
            image.row(y)[4 * x + 3] = alpha;
        }
    }
}

constexpr PictureReach kBody{.left = 10, .right = 30, .top = 15, .bottom = 35}; // of 400 pixels
constexpr PictureReach kSpark{.left = 62, .right = 64, .top = 0, .bottom = 1}; // of 2, in a corner
constexpr PictureReach kBoth{.left = 10, .right = 64, .top = 0, .bottom = 35};

SmokeTally bodyAndSpark()
{
    SmokeTally tally(kWidth, kHeight, kAlpha);
    Image body = clearImage();
    fill(body, kBody, 1.0F);
    Image spark = clearImage();
    fill(spark, kSpark, 1.0F);
    tally.add(body);
    tally.add(spark);
    return tally;
}

int areaOf(const PictureReach& reach)
{
    return (reach.right - reach.left) * (reach.bottom - reach.top);
}

/// Smoke that thins out towards all sides, and specks around it.
SmokeTally softSmoke()
{
    SmokeTally tally(kWidth, kHeight, kAlpha);
    Image image = clearImage();
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const float dx = (static_cast<float>(x) - 30.0F) / 9.0F;
            const float dy = (static_cast<float>(y) - 20.0F) / 6.0F;
            const float speck = (7 * x + 13 * y) % 101 == 0 ? 0.2F : 0.0F;
            image.row(y)[4 * x + 3] = std::max(std::exp(-dx * dx - dy * dy), speck);
        }
    }
    tally.add(image);
    return tally;
}

} // namespace

class SmokeTallyTest : public QObject {
    Q_OBJECT

private slots:
    void withoutAShareTheCutIsTheBoxOfWhatIsSeen()
    {
        const SmokeTally tally = bodyAndSpark();
        const OutlierCut cut = cutOutliers(tally, tally.whole(), 0.0, kMaxShare);
        QCOMPARE(cut.reach, kBoth);
        QCOMPARE(cut.lost, 0.0);
    }

    void aSparkInACornerCostsWhatItWeighsOnce()
    {
        const SmokeTally tally = bodyAndSpark();
        constexpr double kCost = 2.0 / 402.0;
        const OutlierCut enough = cutOutliers(tally, tally.whole(), 1.01 * kCost, kMaxShare);
        QCOMPARE(enough.reach, kBody);
        QVERIFY(near(enough.lost, kCost, 1e-9));
        QCOMPARE(cutOutliers(tally, tally.whole(), 0.99 * kCost, kMaxShare).reach, kBoth);
    }

    void aLineOfTheBodyIsNoOutlier()
    {
        const SmokeTally tally = bodyAndSpark(); // a line weighs 1/20
        QCOMPARE(cutOutliers(tally, tally.whole(), kMaxShare, kMaxShare).reach, kBody);
    }

    void whatIsOutsideTheWindowDoesNotCount()
    {
        const SmokeTally tally = bodyAndSpark();
        const OutlierCut cut =
            cutOutliers(tally, {.left = 5, .right = 40, .top = 12, .bottom = kHeight}, 0.0, kMaxShare);
        QCOMPARE(cut.reach, kBody);
        QCOMPARE(cut.lost, 0.0);
        QVERIFY(
            cutOutliers(tally, {.left = 0, .right = 9, .top = 0, .bottom = 9}, kMaxShare, kMaxShare).reach.isEmpty());
    }

    void halvesAreNoOutliers()
    {
        SmokeTally tally(kWidth, kHeight, kAlpha);
        Image image = clearImage();
        fill(image, {.left = 0, .right = 1, .top = 4, .bottom = 5}, 0.5F);
        fill(image, {.left = 63, .right = 64, .top = 40, .bottom = 41}, 0.5F);
        tally.add(image);
        QCOMPARE(cutOutliers(tally, tally.whole(), kMaxShare, kMaxShare).reach,
            (PictureReach{.left = 0, .right = 64, .top = 4, .bottom = 41}));
    }

    void aGreaterShareLeavesWhatIsWithinThatOfALesserOne()
    {
        const SmokeTally tally = softSmoke();
        OutlierCut before = cutOutliers(tally, tally.whole(), 0.0, kMaxShare);
        const PictureReach all = before.reach;
        for (int step = 1; step <= 50; ++step) {
            const double share = 0.001 * step;
            const OutlierCut cut = cutOutliers(tally, tally.whole(), share, kMaxShare);
            QVERIFY(cut.lost <= share + 1e-12 && cut.lost >= before.lost);
            QVERIFY(cut.reach.left >= before.reach.left && cut.reach.right <= before.reach.right
                && cut.reach.top >= before.reach.top && cut.reach.bottom <= before.reach.bottom);
            before = cut;
        }
        QVERIFY2(2 * areaOf(before.reach) < areaOf(all), "specks need much room, and weigh little");
    }

    void whatIsLostIsWhatLiesOutside()
    {
        const SmokeTally tally = softSmoke();
        const OutlierCut cut = cutOutliers(tally, tally.whole(), 0.03, kMaxShare);
        double outside = 0.0;
        double all = 0.0;
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                const auto weight = static_cast<double>(tally.weights()[static_cast<std::size_t>(y * kWidth + x)]);
                const bool isIn =
                    x >= cut.reach.left && x < cut.reach.right && y >= cut.reach.top && y < cut.reach.bottom;
                outside += isIn ? 0.0 : weight;
                all += weight;
            }
        }
        QVERIFY(near(cut.lost, outside / all, 1e-12));
        QVERIFY(cut.lost > 0.0);
    }

    void thereIsNothingToCutWhereNothingIsSeen()
    {
        SmokeTally tally(kWidth, kHeight, kAlpha);
        Image image = clearImage();
        fill(image, kBody, 0.5F * kAlpha);
        tally.add(image);
        QVERIFY(cutOutliers(tally, tally.whole(), 0.01, kMaxShare).reach.isEmpty());
        QVERIFY(tally.reachIn(0, tally.whole()).isEmpty());
    }

    void addedLightWeighsMoreThanItsAlpha()
    {
        SmokeTally tally(kWidth, kHeight, kAlpha);
        Image image = clearImage();
        image.row(2)[4 * 3 + 3] = 0.25F;
        image.row(2)[4 * 4 + 3] = 0.25F;
        image.row(2)[4 * 4 + 1] = 0.5F;
        image.row(2)[4 * 5 + 3] = 0.25F;
        image.row(2)[4 * 5 + 0] = 40.0F;
        tally.add(image);
        const auto weightAt = [&](int x) { return tally.weights()[static_cast<std::size_t>(2 * kWidth + x)]; };
        QCOMPARE(weightAt(2), std::uint64_t{0});
        QCOMPARE(weightAt(3), std::uint64_t{16384});
        QCOMPARE(weightAt(4), std::uint64_t{32768});
        QCOMPARE(weightAt(5), std::uint64_t{65535});
    }

    void picturesKeepTheirReachesApart()
    {
        const SmokeTally tally = bodyAndSpark();
        QCOMPARE(tally.reachIn(0, tally.whole()), kBody);
        QCOMPARE(tally.reachIn(1, tally.whole()), kSpark);
        QVERIFY(tally.reachIn(1, kBody).isEmpty());
        QCOMPARE(tally.reachIn(0, {.left = 12, .right = 64, .top = 0, .bottom = 20}),
            (PictureReach{.left = 12, .right = 30, .top = 15, .bottom = 20}));
    }

    void reachesHaveGapsThatTheWindowFallsInto()
    {
        SmokeTally tally(kWidth, kHeight, kAlpha);
        Image image = clearImage();
        fill(image, {.left = 2, .right = 4, .top = 7, .bottom = 8}, 1.0F);
        fill(image, {.left = 50, .right = 64, .top = 7, .bottom = 8}, 1.0F);
        tally.add(image);
        QVERIFY(tally.reachIn(0, kBody).isEmpty());
        QVERIFY(tally.reachIn(0, {.left = 4, .right = 50, .top = 0, .bottom = kHeight}).isEmpty());
        QCOMPARE(tally.reachIn(0, {.left = 3, .right = 51, .top = 0, .bottom = kHeight}),
            (PictureReach{.left = 3, .right = 51, .top = 7, .bottom = 8}));
    }

    void depthsAreWithoutTheShareAtEitherEnd()
    {
        DepthTally along;
        along.add(0.5F, 1.0);
        along.add(8.0F, 49.0);
        along.add(10.0F, 49.0);
        along.add(300.0F, 1.0);
        const DepthRange all{0.5F, 300.0F, 9.0F};
        const DepthRange most = along.without(all, 0.005);
        QVERIFY(most.nearest <= 0.5F && most.farthest >= 300.0F && most.middle == 9.0F);
        const DepthRange kept = along.without(all, 0.011);
        QVERIFY(kept.nearest <= 8.0F && kept.nearest > 7.8F);
        QVERIFY(kept.farthest >= 10.0F && kept.farthest < 10.3F);
        QCOMPARE(kept.middle, 9.0F);
        QCOMPARE(along.without({0.5F, 0.5F, 0.5F}, 0.011).farthest, kept.nearest); // a moment of sparks alone
        QCOMPARE(DepthTally().without(all, 0.01).nearest, 0.5F);
    }
};

QTEST_GUILESS_MAIN(SmokeTallyTest)
#include "smoke_tally_test.moc"
