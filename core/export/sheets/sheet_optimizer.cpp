#include "core/export/sheets/sheet_optimizer.h"

#include "core/base/memory.h"
#include "core/base/parallel.h"
#include "core/export/sheets/cell_frames.h"
#include "core/export/difference.h"
#include "core/export/sheets/sheet.h"
#include "core/export/sheets/sheet_playback.h"
#include "core/rendering/scene_renderer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>

namespace fumage {

namespace {

constexpr std::array<std::array<int, 2>, 9> kGrids{
    {{4, 2}, {4, 4}, {8, 4}, {6, 6}, {8, 8}, {10, 10}, {16, 8}, {12, 12}, {16, 16}}};
constexpr int kMinEdge = 16;
constexpr int kMoments = 16;

bool isPowerOfTwo(int number)
{
    return std::has_single_bit(static_cast<unsigned>(number));
}

/// What edges of cells are multiples of: whole blocks of BC7, in packed pictures too.
int stepOf(const ExportPlan& plan)
{
    constexpr int kBlock = 4;
    int step = kBlock;
    for (const PackedPicture& pack : plan.flipbook.packs) {
        step = std::lcm(step, pack.divisor);
    }
    return step;
}

int fitted(int edge, double scale, const ExportPlan& plan)
{
    const int shrunk = static_cast<int>(edge * scale);
    if (plan.flipbook.powerOfTwo) {
        return static_cast<int>(std::bit_floor(static_cast<unsigned>(std::max(1, shrunk))));
    }
    return scale < 1.0 ? shrunk - shrunk % stepOf(plan) : edge;
}

/// A moment of the animation: what is to be seen.
struct Moment {
    double share = 0.0; ///< of the way through the cells
    Image truth;
};

Result<std::vector<Moment>> momentsOf(const Scene& scene, const FlipbookOptions& options, const ExportTask& task)
{
    FlipbookOptions halves = options;
    halves.columns = 2 * kMoments;
    halves.rows = 1;
    SceneRenderer renderer(scene, task.shelf);
    std::vector<Moment> moments(kMoments);
    for (int i = 0; i < kMoments; ++i) {
        const int number = frameOfCell(halves, 2 * i + 1);
        Moment& moment = moments[static_cast<std::size_t>(i)];
        const int place = (number - options.frames.first) / options.frames.step; // in the range
        const double ofFrame = static_cast<double>(place) / options.frames.count();
        moment.share = options.retime ? (2.0 * i + 1.0) / (2.0 * kMoments) : ofFrame;
        if (Status status = renderer.render(number, scene.output.width, scene.output.height, moment.truth, task);
            !status) {
            return status.error();
        }
    }
    return moments;
}

/// A picture against one that may be larger.
Difference differenceOf(const Image& small, const Image& truth)
{
    std::vector<Difference> rows(static_cast<std::size_t>(truth.height));
    const SheetCell whole{0, 0, small.width, small.height};
    const float across = static_cast<float>(small.width) / static_cast<float>(truth.width);
    const float down = static_cast<float>(small.height) / static_cast<float>(truth.height);
    parallelFor(rows.size(), [&](std::size_t y) {
        for (int x = 0; x < truth.width; ++x) {
            const glm::vec4 there = shown(truth.at(x, static_cast<int>(y)));
            const glm::vec4 here = shownBetween(small, whole, (static_cast<float>(x) + 0.5F) * across - 0.5F,
                (static_cast<float>(y) + 0.5F) * down - 0.5F);
            for (int channel = 0; channel < 4; ++channel) {
                rows[y].add(here[channel], there[channel]);
            }
        }
    });
    Difference all;
    for (const Difference& row : rows) {
        all.add(row);
    }
    return all;
}

Result<double> rate(const Scene& seen, FlipbookOptions options, const SheetCandidate& candidate,
    const std::vector<Moment>& moments, const ExportTask& task)
{
    Scene small = seen;
    small.output.width = candidate.width;
    small.output.height = candidate.height;
    options.columns = candidate.columns;
    options.rows = candidate.rows;
    const bool hasMotion = options.passes.has(Pass::Motion);
    PassSheet sheet;
    if (Status status = renderSheet(small, cellFramesOf(small, options), options.columns,
            hasMotion ? PassSet{Pass::Colour, Pass::Motion} : PassSet{Pass::Colour}, sheet, {}, task);
        !status) {
        return status.error();
    }
    std::optional<SheetPlayback> playback;
    if (hasMotion) {
        const PassPictures pictures(sheet, {Pass::Motion}, {});
        playback.emplace(sheet, stored(pictures.picture(Pass::Motion), options.format), pictures.scales().motion);
    } else {
        playback.emplace(sheet);
    }
    Difference all;
    Image shownThen;
    for (const Moment& moment : moments) {
        playback->picture(moment.share * sheet.grid.cells, sheet.grid.loops, CellBlending::Motion, shownThen);
        all.add(differenceOf(shownThen, moment.truth));
    }
    return all.decibels();
}

Result<std::vector<SheetCandidate>> rateAll(
    const Scene& seen, const FlipbookOptions& options, std::vector<SheetCandidate> candidates, const ExportTask& task)
{
    const Result<std::vector<Moment>> moments = momentsOf(seen, options, task);
    if (!moments) {
        return moments.error();
    }
    const int total = std::accumulate(candidates.begin(), candidates.end(), 0,
        [](int sum, const SheetCandidate& each) { return sum + each.columns * each.rows; });
    int before = 0;
    for (SheetCandidate& candidate : candidates) {
        const auto told = [&](ProgressPhase work, int done, int of) {
            work == ProgressPhase::Frames ? task.progress(work, before + done, total) : task.progress(work, done, of);
        };
        const Result<double> decibels =
            rate(seen, options, candidate, moments.value(), {{told, task.stop}, task.shelf});
        if (!decibels) {
            return decibels.error();
        }
        candidate.decibels = decibels.value();
        before += candidate.columns * candidate.rows;
    }
    return candidates;
}

} // namespace

std::vector<SheetCandidate> sheetsWithin(
    std::int64_t budget, const Output& largest, const ExportPlan& plan, std::size_t layers)
{
    std::vector<SheetCandidate> candidates;
    for (const auto& [columns, rows] : kGrids) {
        if (plan.frames.count() < columns * rows
            || (plan.flipbook.powerOfTwo && (!isPowerOfTwo(columns) || !isPowerOfTwo(rows)))) {
            continue;
        }
        FlipbookOptions options = flipbookOf(plan);
        options.columns = columns;
        options.rows = rows;
        const double whole = static_cast<double>(memoryOf(options, largest.width, largest.height, layers).compressed);
        const double edge =
            static_cast<double>(kMaxSheetEdge) / std::max(columns * largest.width, rows * largest.height);
        // Blocks are rounded up, so the last step down may be needed.
        for (double scale = std::min({1.0, edge, std::sqrt(static_cast<double>(budget) / whole)}); scale > 0.0;
             scale *= 0.98) {
            const SheetCandidate one{
                columns, rows, fitted(largest.width, scale, plan), fitted(largest.height, scale, plan)};
            if (std::min(one.width, one.height) < std::min({kMinEdge, largest.width, largest.height})) {
                break;
            }
            const std::int64_t bytes = memoryOf(options, one.width, one.height, layers).compressed;
            if (bytes <= budget) {
                candidates.push_back(one);
                candidates.back().bytes = bytes;
                break;
            }
        }
    }
    return candidates;
}

Result<std::vector<SheetCandidate>> rateSheets(
    const Scene& scene, const ExportPlan& plan, std::int64_t budget, const ExportTask& asked)
{
    return withinMemory([&]() -> Result<std::vector<SheetCandidate>> {
        const ExportTask task = withShelf(asked);
        ExportPlan allFrames = plan;
        allFrames.kind = ExportKind::Sequence; // as no grid leaves frames out, and none asks for powers of two
        Result<Scene> seen = sceneSeenBy(scene, allFrames, task);
        if (!seen) {
            return seen.error();
        }
        seen.value().output.background = Background::Transparent;
        const Result<FlipbookOptions> options = flipbookSeenBy(seen.value(), plan, task);
        if (!options) {
            return options.error();
        }
        ExportPlan anyGrid = plan;
        anyGrid.frames = options.value().frames;
        const std::vector<SheetCandidate> candidates =
            sheetsWithin(budget, seen.value().output, anyGrid, writtenLayers(seen.value()).size());
        if (candidates.empty()) {
            return Error{ErrorCode::OutOfRange,
                makeMessage("no sheet fits into %1 bytes, or the frames fill none", budget), {},
                makeMessage("Allow more memory, fewer passes or more frames")};
        }
        return rateAll(seen.value(), options.value(), candidates, task);
    });
}

const SheetCandidate& bestOf(const std::vector<SheetCandidate>& candidates)
{
    return *std::max_element(
        candidates.begin(), candidates.end(), [](const SheetCandidate& a, const SheetCandidate& b) {
            return std::pair(a.decibels, -a.bytes) < std::pair(b.decibels, -b.bytes);
        });
}

} // namespace fumage
