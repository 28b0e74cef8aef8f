#include "core/export/engines/engine_remarks.h"

#include "core/base/text.h"
#include "core/export/sheets/cell_frames.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace fumage {

namespace {

constexpr double kSixtieths = 60.0; ///< Effekseer's clock, 1/s
constexpr double kSeenSpeed = 0.02; ///< share of a speed that nobody misses

bool isKept(Engine engine, double rate)
{
    return std::abs(playedRate(engine, rate) / rate - 1.0) <= kSeenSpeed;
}

/// The rates next to one that an engine keeps.
std::array<double, 2> keptRates(Engine engine, double rate)
{
    if (engine == Engine::Effekseer) {
        const double cell = std::floor(kSixtieths / rate);
        return {kSixtieths / std::max(1.0, cell), kSixtieths / (cell + 1.0)};
    }
    return {std::max(1.0, std::floor(rate)), std::floor(rate) + 1.0};
}

/// How many frames, one after the other, the same cells may show so that the engine keeps their speed; the nearest
/// number to those that are there.
std::optional<int> framesThatFit(const Scene& scene, const FlipbookOptions& options)
{
    const int cells = options.columns * options.rows;
    const double rate = cellsPerSecond(scene, options);
    const double there = static_cast<double>(options.frames.count()) * options.frames.step;
    std::optional<int> best;
    for (const double kept : keptRates(options.engine, rate)) {
        const int frames = static_cast<int>(std::lround(cells * static_cast<double>(scene.timeline.frameRate) / kept));
        const double speed = cells * static_cast<double>(scene.timeline.frameRate) / std::max(1, frames);
        if (frames >= cells && isKept(options.engine, speed)
            && (!best || std::abs(frames - there) < std::abs(*best - there))) {
            best = frames;
        }
    }
    return best;
}

/// The rate of the timeline's frames at which those that are there fit.
double frameRateThatFits(const Scene& scene, const FlipbookOptions& options)
{
    const double rate = cellsPerSecond(scene, options);
    const std::array<double, 2> kept = keptRates(options.engine, rate);
    const double nearest = std::abs(kept[0] - rate) <= std::abs(kept[1] - rate) ? kept[0] : kept[1];
    return static_cast<double>(scene.timeline.frameRate) * nearest / rate;
}

std::string shown(double value)
{
    constexpr double kHundredths = 100.0;
    return formatFloat(static_cast<float>(std::round(value * kHundredths) / kHundredths));
}

Message speedRemark(const Scene& scene, const FlipbookOptions& options)
{
    const double rate = cellsPerSecond(scene, options);
    const int cells = options.columns * options.rows;
    const std::string played = shown(cells / playedRate(options.engine, rate));
    const std::string meant = shown(cells / rate);
    const std::string engine(titleOf(options.engine));
    const std::string fps = shown(frameRateThatFits(scene, options));
    if (const std::optional<int> frames = framesThatFit(scene, options)) {
        return makeMessage("%1 plays this sheet in %2 s instead of %3 s, for it counts time in whole steps: %4 frames "
                           "in its cells, or %5 frames a second, would keep the speed",
            engine, played, meant, *frames, fps);
    }
    return makeMessage("%1 plays this sheet in %2 s instead of %3 s, for it counts time in whole steps: %4 frames a "
                       "second would keep the speed",
        engine, played, meant, fps);
}

} // namespace

double playedRate(Engine engine, double cellsPerSecond)
{
    switch (engine) {
    case Engine::Effekseer: return kSixtieths / std::max(1.0, std::floor(kSixtieths / cellsPerSecond + 0.5));
    case Engine::Defold: return std::max(1.0, std::floor(cellsPerSecond + 0.5));
    case Engine::Generic:
    case Engine::Unity:
    case Engine::Unreal:
    case Engine::Godot:
    case Engine::Godot3:
    case Engine::Pixi:
    case Engine::Web: break;
    }
    return cellsPerSecond;
}

std::vector<Message> engineRemarks(const Scene& scene, const FlipbookOptions& options)
{
    std::vector<Message> remarks;
    if (!isKept(options.engine, cellsPerSecond(scene, options))) {
        remarks.push_back(speedRemark(scene, options));
    }
    // The material function takes floor(i / rows) for the row of cell i. Source: its graph in SideFX Labs' texture
    // sheets.
    if (options.engine == Engine::Unreal && renderedPasses(options).has(Pass::Motion)
        && options.columns != options.rows) {
        remarks.push_back(makeMessage("Unreal's FlipBook_MotionVectors finds its cells only where there are as many "
                                      "columns as rows: use %1 x %1 cells, or a material of your own",
            std::min(options.columns, options.rows)));
    }
    return remarks;
}

} // namespace fumage
