#include "core/export/loop.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace fumage {

namespace {

/// The number nearest to another among those that divide a third, and of two the smaller.
int nearestDivisor(int wanted, int of, int most)
{
    int best = 1;
    for (int each = 2; each <= std::min(of, most); ++each) {
        if (of % each == 0 && std::abs(each - wanted) < std::abs(best - wanted)) {
            best = each;
        }
    }
    return best;
}

} // namespace

std::optional<int> turnOf(const Timeline& timeline, const FrameRange& frames)
{
    const std::int64_t covered = static_cast<std::int64_t>(frames.count()) * frames.step;
    const bool closes = timeline.loop && covered % timeline.length == 0;
    return closes ? std::optional(static_cast<int>(covered)) : std::nullopt;
}

std::optional<int> turnOf(const Timeline& timeline, const FlipbookOptions& options)
{
    const std::optional<int> turn = turnOf(timeline, options.frames);
    if (!turn || !options.retime) {
        return turn;
    }
    constexpr float kSame = 1e-4F; // share of the frames
    const float way = options.retime->at(1.0F) - options.retime->at(0.0F);
    const float whole = std::round(way);
    return std::abs(way - whole) < kSame ? std::optional(static_cast<int>(whole) * *turn) : std::nullopt;
}

std::optional<FrameRange> closedInstead(const Timeline& timeline, const FrameRange& frames, int fewest)
{
    if (!timeline.loop || turnOf(timeline, frames)) {
        return std::nullopt;
    }
    const auto length = static_cast<std::int64_t>(timeline.length);
    const std::int64_t covered = static_cast<std::int64_t>(frames.count()) * frames.step;
    const std::int64_t turns = std::max<std::int64_t>(1, (covered + length / 2) / length);
    const std::int64_t most = std::max<std::int64_t>(1, turns * length / fewest); // of the step
    const int step =
        nearestDivisor(frames.step, timeline.length, static_cast<int>(std::min<std::int64_t>(most, length)));
    const std::int64_t needed = (static_cast<std::int64_t>(fewest) * step + length - 1) / length;
    const std::int64_t last = frames.first + std::max(turns, needed) * length - step;
    return last <= kMaxFrame ? std::optional(FrameRange{frames.first, static_cast<int>(last), step}) : std::nullopt;
}

} // namespace fumage
