#include "core/export/sheets/sheet_events.h"

#include "core/export/sheets/cell_frames.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <optional>
#include <set>

namespace fumage {

namespace {

/// From the frame of one cell to that of the next, or after the last to where the frames end.
struct Stretch {
    double from = 0.0;
    double to = 0.0;
};

std::vector<Stretch> stretchesOf(const FlipbookOptions& options)
{
    const std::vector<int> frames = framesOfCells(options);
    const double share = options.retime ? static_cast<double>(options.retime->at(1.0F)) : 1.0;
    const double end = options.frames.first + share * options.frames.count() * options.frames.step;
    std::vector<Stretch> stretches;
    for (std::size_t cell = 0; cell < frames.size(); ++cell) {
        const bool isLast = cell + 1 == frames.size();
        stretches.push_back({static_cast<double>(frames[cell]), isLast ? end : static_cast<double>(frames[cell + 1])});
    }
    return stretches;
}

/// A time in frames; those that are one but for rounding are whole.
double frameAt(double seconds, int frameRate)
{
    constexpr double kRounding = 1e-6;
    const double frame = seconds * frameRate;
    const double whole = std::round(frame);
    return std::abs(frame - whole) < kRounding ? whole : frame;
}

/// The first turn of a loop in which a stretch passes a frame. Its end belongs to the next one.
/// @param turn length of the loop, frames; 0: none
std::optional<std::int64_t> turnIn(const Stretch& stretch, double frame, int turn)
{
    const auto passes = [&](double at) {
        return at == stretch.from || (stretch.from < at && at < stretch.to) || (stretch.to < at && at < stretch.from);
    };
    std::int64_t turns = 0;
    if (turn > 0) {
        const double before = (stretch.from - frame) / turn;
        turns = static_cast<std::int64_t>(stretch.to < stretch.from ? std::floor(before) : std::ceil(before));
    }
    return turns >= 0 && passes(frame + static_cast<double>(turns) * turn) ? std::optional(turns) : std::nullopt;
}

/// What the cells of a sheet go through, and how fast.
struct Way {
    std::vector<Stretch> stretches; ///< one a cell
    double cellsPerSecond = 1.0;
    const Timeline& timeline;
};

Way wayOf(const Scene& scene, const FlipbookOptions& options)
{
    return {stretchesOf(options), cellsPerSecond(scene, options), scene.timeline};
}

std::vector<SheetEvent> eventsOf(const Marker& marker, const Way& way)
{
    std::vector<SheetEvent> events;
    const Timeline& timeline = way.timeline;
    const double frame = frameAt(marker.seconds, timeline.frameRate);
    if (timeline.loop && frame >= timeline.length) {
        return events; // never shown
    }
    std::set<std::int64_t> passed; // turns in which it was
    for (std::size_t cell = 0; cell < way.stretches.size(); ++cell) {
        const Stretch& stretch = way.stretches[cell];
        const std::optional<std::int64_t> turn = turnIn(stretch, frame, timeline.loop ? timeline.length : 0);
        if (!turn || !passed.insert(*turn).second) {
            continue;
        }
        const double gone = frame + static_cast<double>(*turn) * timeline.length - stretch.from;
        const double share = gone == 0.0 ? 0.0 : gone / (stretch.to - stretch.from);
        events.push_back(
            {marker.name, (static_cast<double>(cell) + share) / way.cellsPerSecond, static_cast<int>(cell)});
    }
    return events;
}

} // namespace

std::vector<SheetEvent> sheetEvents(const Scene& scene, const FlipbookOptions& options)
{
    std::vector<SheetEvent> events;
    if (scene.markers.empty()) {
        return events;
    }
    const Way way = wayOf(scene, options);
    for (const Marker& marker : scene.markers) {
        std::ranges::move(eventsOf(marker, way), std::back_inserter(events));
    }
    std::ranges::stable_sort(events, {}, &SheetEvent::seconds);
    return events;
}

std::vector<Marker> markersOutside(const Scene& scene, const FlipbookOptions& options)
{
    std::vector<Marker> outside;
    if (scene.markers.empty()) {
        return outside;
    }
    const Way way = wayOf(scene, options);
    std::ranges::copy_if(scene.markers, std::back_inserter(outside),
        [&](const Marker& marker) { return eventsOf(marker, way).empty(); });
    return outside;
}

} // namespace fumage
