#include "core/export/sheets/cell_frames.h"

#include "core/base/text.h"
#include "core/effect/value.h"
#include "core/export/loop.h"

#include <algorithm>

namespace fumage {

namespace {

/// What the curve of the frames is, as parameters are described.
Parameter sharesByShares()
{
    return {.kind = Kind::Curve, .hard = {0.0, 1.0}};
}

} // namespace

Result<Curve> parseRetime(std::string_view text)
{
    const Parameter shares = sharesByShares();
    const Result<Clamped> read = parseValue(shares, text);
    if (!read) {
        return read.error();
    }
    if (clampValue(shares, read.value().value).changed) {
        return Error{ErrorCode::OutOfRange,
            makeMessage("the points %1 do not lie between 0 and 1, from left to right", inQuotes(text)), {},
            makeMessage("Write [[0, 0], [0.3, 0.6], [1, 1]]")};
    }
    return std::get<Curve>(read.value().value);
}

std::string textOfRetime(const Curve& retime)
{
    return formatJson(sharesByShares(), retime);
}

int frameOfCell(const FlipbookOptions& options, int cell)
{
    const int cells = options.columns * options.rows;
    const int count = options.frames.count();
    if (!options.retime) {
        return options.frames.at(static_cast<int>(static_cast<std::int64_t>(cell) * count / cells));
    }
    constexpr double kRounding = 1e-4; // of the curve: a straight one gives what none gives
    const double share = static_cast<double>(options.retime->at(static_cast<float>(cell) / static_cast<float>(cells)));
    return options.frames.at(std::clamp(static_cast<int>(share * count + kRounding), 0, count - 1));
}

std::vector<int> framesOfCells(const FlipbookOptions& options)
{
    std::vector<int> frames;
    for (int cell = 0; cell < options.columns * options.rows; ++cell) {
        frames.push_back(frameOfCell(options, cell));
    }
    return frames;
}

CellFrames cellFramesOf(const Scene& scene, const FlipbookOptions& options)
{
    return {framesOfCells(options), turnOf(scene.timeline, options)};
}

double cellsPerSecond(const Scene& scene, const FlipbookOptions& options)
{
    const double frames = static_cast<double>(options.frames.count()) * options.frames.step;
    return options.columns * options.rows * static_cast<double>(scene.timeline.frameRate) / frames;
}

} // namespace fumage
