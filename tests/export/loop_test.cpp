// Loops: which frames are whole turns, what is said where they are not, and the seam where the last cell is followed by
// the first.

#include "core/export/loop.h"
#include "tests/helpers.h"

#include "core/export/sheets/cell_frames.h"
#include "core/export/plan.h"
#include "core/export/sheets/sheet.h"
#include "core/export/sheets/sheet_playback.h"
#include "core/preset/library.h"

#include <QRegularExpression>

#include <algorithm>
#include <cmath>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr int kEdge = 96; ///< of a cell, pixels

Timeline loopOf(int length)
{
    Timeline timeline;
    timeline.loop = true;
    timeline.length = length;
    return timeline;
}

/// A preset that loops, as little of it as still flows as it does.
Effect small(Effect effect, int length)
{
    effect.timeline.length = length;
    effect.timeline.stepsPerFrame = 1;
    effect.emitter.count = std::min(effect.emitter.count, 3000);
    effect.air.resolution = 16;
    effect.noise.slices = std::min(effect.noise.slices, 4);
    effect.noise.resolution = std::min(effect.noise.resolution, 32);
    effect.output.quality = Quality::Draft;
    effect.output.supersample = 1;
    effect.output.background = Background::Transparent;
    effect.output.width = effect.output.height = kEdge;
    return effect;
}

/// How far the smoke of each cell goes in a frame, as a share of the cell: mean of the vectors over the mean of the
/// frames before and after it.
std::vector<double> speeds(const PassSheet& sheet, const std::vector<int>& spans)
{
    std::vector<double> out;
    const Image& motion = sheet.targets.of(PassTarget::Motion);
    for (int cell = 0; cell < sheet.grid.cells; ++cell) {
        const SheetCell at = sheet.grid.cell(cell);
        double sum = 0.0;
        double weight = 0.0;
        for (int y = at.top; y < at.top + at.height; ++y) {
            for (int x = at.left; x < at.left + at.width; ++x) {
                const glm::dvec4 vector(motion.at(x, y)); // premultiplied
                sum += std::hypot(vector.x, vector.y);
                weight += vector.w;
            }
        }
        const std::size_t before = (static_cast<std::size_t>(cell) + spans.size() - 1) % spans.size();
        out.push_back(sum / weight / (0.5 * (spans[before] + spans[static_cast<std::size_t>(cell)])));
    }
    return out;
}

/// Frames from each cell to the one after it, of a loop.
std::vector<int> spansOf(const CellFrames& frames)
{
    std::vector<int> spans;
    for (std::size_t i = 0; i < frames.numbers.size(); ++i) {
        const bool isLast = i + 1 == frames.numbers.size();
        spans.push_back((isLast ? frames.numbers.front() + *frames.turn : frames.numbers[i + 1]) - frames.numbers[i]);
    }
    return spans;
}

/// How far the picture between two cells is from the frame that is there: root of the mean square.
double ghost(
    const SheetPlayback& playback, const SheetGrid& grid, int cell, float f, const Image& truth, CellBlending blending)
{
    double sum = 0.0;
    for (int y = 0; y < truth.height; ++y) {
        for (int x = 0; x < truth.width; ++x) {
            const glm::vec4 there = shown(truth.at(x, y));
            const glm::vec4 seen = playback.pixel(cell, (cell + 1) % grid.cells, f, x, y, blending);
            sum += static_cast<double>(glm::dot(there - seen, there - seen));
        }
    }
    return std::sqrt(sum / (truth.width * truth.height));
}

/// All that the files of a flipbook say in words: numbers and pictures left out.
QString wordsOf(const Effect& effect, const FlipbookOptions& options)
{
    QString words;
    const Result<std::vector<FlipbookFile>> files = encodeFlipbook(effect, options);
    for (const FlipbookFile& file : files.value()) {
        if (file.path.extension() != ".png") {
            words += QString::fromUtf8(
                reinterpret_cast<const char*>(file.bytes.data()), static_cast<qsizetype>(file.bytes.size()));
        }
    }
    words.remove(QRegularExpression(QStringLiteral("base64,[A-Za-z0-9+/=]+")));
    return words.remove(QRegularExpression(QStringLiteral("[0-9.]+(e-[0-9]+)?")));
}

} // namespace

class LoopTest : public QObject {
    Q_OBJECT

private slots:
    void onlyWholeTurnsClose_data()
    {
        QTest::addColumn<int>("first");
        QTest::addColumn<int>("last");
        QTest::addColumn<int>("step");
        QTest::addColumn<int>("turn"); // 0: none
        QTest::newRow("one turn") << 0 << 89 << 1 << 90;
        QTest::newRow("from elsewhere") << 7 << 96 << 1 << 90;
        QTest::newRow("every second frame") << 0 << 88 << 2 << 90;
        QTest::newRow("every second, as they are written") << 0 << 89 << 2 << 90;
        QTest::newRow("two turns") << 0 << 179 << 1 << 180;
        QTest::newRow("two turns in steps that divide but them") << 0 << 176 << 4 << 180;
        QTest::newRow("too few") << 0 << 63 << 1 << 0;
        QTest::newRow("the first again") << 0 << 90 << 1 << 0;
        QTest::newRow("steps that divide nothing") << 0 << 89 << 7 << 0;
        QTest::newRow("one frame") << 5 << 5 << 1 << 0;
    }
    void onlyWholeTurnsClose()
    {
        QFETCH(int, first);
        QFETCH(int, last);
        QFETCH(int, step);
        QFETCH(int, turn);
        const FrameRange frames{first, last, step};
        QCOMPARE(turnOf(loopOf(90), frames).value_or(0), turn);
        Timeline once = loopOf(90);
        once.loop = false;
        QVERIFY(!turnOf(once, frames));
        QVERIFY(!closedInstead(once, frames));
        QCOMPARE(closedInstead(loopOf(90), frames).has_value(), turn == 0);
    }

    void whatIsOfferedClosesAndIsEnough()
    {
        for (const int length : {1, 2, 7, 48, 89, 90, 96, 150}) {
            for (const int step : {1, 2, 3, 7, 40, 200}) {
                for (const int count : {1, 5, 36, 64, 91}) {
                    for (const int fewest : {1, 16, 64}) {
                        const FrameRange asked{3, 3 + (count - 1) * step, step};
                        const std::optional<FrameRange> offered = closedInstead(loopOf(length), asked, fewest);
                        if (!offered) {
                            QVERIFY(turnOf(loopOf(length), asked));
                            continue;
                        }
                        QVERIFY(turnOf(loopOf(length), *offered));
                        QVERIFY(offered->count() >= fewest);
                        QCOMPARE(offered->first, asked.first);
                    }
                }
            }
        }
    }

    void theNearestRangeIsOffered()
    {
        const auto offered = [](const FrameRange& frames, int fewest) {
            return textOf(closedInstead(loopOf(90), frames, fewest).value());
        };
        QCOMPARE(offered({0, 63, 1}, 9), std::string("0-89"));
        QCOMPARE(offered({0, 90, 1}, 64), std::string("0-89"));
        QCOMPARE(offered({0, 89, 7}, 9), std::string("0-84:6"));
        QCOMPARE(offered({10, 190, 1}, 64), std::string("10-189"));
    }

    void aCurveClosesWhereItEndsAsItBegins()
    {
        FlipbookOptions options;
        options.frames = {0, 89, 1};
        const auto turn = [&](std::initializer_list<CurvePoint> points) {
            options.retime = Curve(points);
            return turnOf(loopOf(90), options);
        };
        QCOMPARE(turn({{0.0F, 0.0F}, {0.3F, 0.6F}, {1.0F, 1.0F}}), std::optional(90));
        QCOMPARE(turn({{0.0F, 1.0F}, {1.0F, 0.0F}}), std::optional(-90));
        QCOMPARE(turn({{0.0F, 0.0F}, {0.5F, 1.0F}, {1.0F, 0.0F}}), std::optional(0));
        QCOMPARE(turn({{0.0F, 0.0F}, {1.0F, 0.5F}}), std::optional<int>());
    }

    void vectorsAtTheSeamAreThoseOfOtherCells_data()
    {
        QTest::addColumn<int>("preset");
        QTest::addColumn<int>("length");
        const std::vector<LibraryEntry> presets = builtinPresets();
        for (std::size_t i = 0; i < presets.size(); ++i) {
            if (loadPreset(presets[i]).value().preset.scene.timeline.loop) {
                // Steps of 2 and 3 frames, of which the last is 2 and that at the seam 3; and steps of 2.
                QTest::newRow((presets[i].id + ", uneven").c_str()) << static_cast<int>(i) << 150;
                QTest::newRow((presets[i].id + ", even").c_str()) << static_cast<int>(i) << 128;
            }
        }
    }
    void vectorsAtTheSeamAreThoseOfOtherCells()
    {
        QFETCH(int, preset);
        QFETCH(int, length);
        const Effect effect =
            small(loadPreset(builtinPresets()[static_cast<std::size_t>(preset)]).value().preset.scene.effect(), length);
        FlipbookOptions options;
        options.columns = options.rows = 8;
        options.frames = {0, length - 1, 1};
        const CellFrames frames = cellFramesOf(effect, options);
        QCOMPARE(frames.turn, std::optional(length));
        const std::vector<int> spans = spansOf(frames);
        PassSheet sheet;
        const auto shelf = std::make_shared<AirCache>();
        QVERIFY(
            renderSheet(effect, frames, options.columns, {Pass::Colour, Pass::Motion}, sheet, {}, {{}, shelf}).ok());
        const std::vector<double> all = speeds(sheet, spans);
        constexpr std::ptrdiff_t kNeighbourhood = 5;
        std::vector<double> near(all.begin() + 1, all.begin() + 1 + kNeighbourhood);
        near.insert(near.end(), all.end() - 1 - kNeighbourhood, all.end() - 1);
        const auto [least, most] = std::minmax_element(near.begin(), near.end());
        for (const double seam : {all.front(), all.back()}) {
            QVERIFY2(seam >= 0.9 * *least && seam <= 1.1 * *most,
                qPrintable(QStringLiteral("%1 is not from %2 to %3").arg(seam).arg(*least).arg(*most)));
        }
        compareGhosts(effect, frames, spans, sheet, shelf);
    }

    void framesOfALoopKnowTheOneBeforeTheFirst()
    {
        // What a farm renders of a turn is what follows it in the next one.
        const Effect effect = small(loadPreset("steam").value().preset.scene.effect(), 24);
        const auto vectors = [&](int frame) {
            SequenceOptions options;
            options.frames = {frame, frame, 1};
            options.format = ImageFormat::ExrFloat;
            options.passes = {Pass::Colour, Pass::Motion};
            return encodeFrame(effect, frame, options);
        };
        const auto first = vectors(0);
        const auto again = vectors(24);
        QVERIFY(first.ok() && again.ok());
        const auto pixelsOf = [](const std::vector<std::byte>& bytes) {
            return std::vector<std::byte>(bytes.end() - 4096, bytes.end());
        };
        QVERIFY(pixelsOf(first.value()) == pixelsOf(again.value()));
    }

    void everySheetSaysWhetherItLoops_data()
    {
        QTest::addColumn<int>("last");
        QTest::addColumn<bool>("loops");
        QTest::newRow("one turn") << 19 << true;
        QTest::newRow("less") << 15 << false;
        QTest::newRow("the first again") << 20 << false;
    }
    void everySheetSaysWhetherItLoops()
    {
        QFETCH(int, last);
        QFETCH(bool, loops);
        Effect effect = thesisEffect(200);
        effect.timeline = loopOf(20);
        effect.output.width = effect.output.height = 8;
        for (const Engine engine : kAllEngines) {
            ExportPlan plan;
            plan.kind = ExportKind::Flipbook;
            plan.output = "a.png";
            plan.frames = {0, last, 1};
            plan.flipbook.columns = plan.flipbook.rows = 2;
            plan.flipbook.engine = engine;
            plan.passes = passesFor(engine);
            // A sheet that does not loop says what one says of smoke that never does.
            Effect once = effect;
            once.timeline.loop = false;
            const QString said = wordsOf(effect, flipbookOf(plan));
            QCOMPARE(said.contains(QStringLiteral("\"loop\": true")), loops);
            QCOMPARE(said == wordsOf(once, flipbookOf(plan)), !loops);
        }
    }

private:
    /// Between the last cell and the first, vectors mend as much of a cross-fade's error as between others that lie as
    /// far apart. The error itself comes and goes with puffs.
    void compareGhosts(const Effect& effect, const CellFrames& frames, const std::vector<int>& spans,
        const PassSheet& sheet, const std::shared_ptr<AirCache>& shelf)
    {
        const PassPictures pictures(sheet, {Pass::Motion}, {});
        const SheetPlayback playback(sheet, pictures.picture(Pass::Motion), pictures.scales().motion);
        Simulator simulator(sampled(effect), Simulator::kDefaultCheckpointBytes, shelf);
        Renderer renderer;
        double worst = 0.0;
        double seam = 0.0;
        for (std::size_t cell = 0; cell < spans.size(); ++cell) {
            if (spans[cell] != spans.back()) {
                continue;
            }
            Image truth;
            const int half = spans[cell] / 2;
            const auto frame = simulator.frame(frames.numbers[cell] + half);
            QVERIFY(frame.ok() && renderer.render(*frame.value(), sampled(effect), kEdge, kEdge, truth).ok());
            const auto off = [&](CellBlending blending) {
                const float way = static_cast<float>(half) / static_cast<float>(spans[cell]);
                return ghost(playback, sheet.grid, static_cast<int>(cell), way, truth, blending);
            };
            const double seen = off(CellBlending::Motion) / off(CellBlending::CrossFade);
            double& to = cell + 1 == spans.size() ? seam : worst;
            to = std::max(to, seen);
        }
        QVERIFY(std::isfinite(worst));
        QVERIFY2(seam > 0.0 && seam <= 1.05 * worst,
            qPrintable(QStringLiteral("%1 at the seam, %2 elsewhere").arg(seam).arg(worst)));
    }
};

QTEST_GUILESS_MAIN(LoopTest)
#include "loop_test.moc"
