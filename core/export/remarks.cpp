#include "core/export/remarks.h"

#include "core/base/joined.h"
#include "core/base/text.h"
#include "core/effect/sampling.h"
#include "core/export/engines/engine_remarks.h"
#include "core/export/loop.h"
#include "core/export/sheets/sheet_events.h"
#include "core/preset/preset_file.h"
#include "core/scene/key_faults.h"

#include <algorithm>
#include <iterator>

namespace fumage {

namespace {

void addLoop(const Timeline& timeline, const ExportPlan& plan, std::vector<Message>& remarks)
{
    const bool isFlipbook = plan.kind == ExportKind::Flipbook;
    const bool isVideo =
        plan.kind == ExportKind::Video && saysHowOften(plan.video.format) && plan.video.repeat == Repeat::Auto;
    if (!timeline.loop || !(isFlipbook || isVideo)) {
        return;
    }
    const std::string asked = textOf(plan.frames);
    if (const std::optional<FrameRange> whole =
            closedInstead(timeline, plan.frames, isFlipbook ? plan.flipbook.columns * plan.flipbook.rows : 1)) {
        remarks.push_back(makeMessage(
            "frames %1 are no whole turn of the loop of %2 frames, so they are played once: frames %3 close it", asked,
            timeline.length, textOf(*whole)));
    } else if (!turnOf(timeline, plan.frames)) {
        remarks.push_back(makeMessage(
            "frames %1 are no whole turn of the loop of %2 frames, so they are played once", asked, timeline.length));
    } else if (isFlipbook && !turnOf(timeline, flipbookOf(plan))) {
        remarks.push_back(makeMessage("the curve of the frames does not end where it begins, so they are played once"));
    }
}

void addVideo(const Scene& scene, const ExportPlan& plan, std::vector<Message>& remarks)
{
    const int left = framesOf(scene, videoOf(plan)).step / plan.frames.step;
    if (left > 1) {
        remarks.push_back(
            makeMessage("one frame of %1 is in the GIF: more than 50 pictures a second play slowly in browsers", left));
    }
    const auto [width, height] = sizeOf(scene.output, plan.video.format);
    if (width != scene.output.width || height != scene.output.height) {
        remarks.push_back(makeMessage(
            "H.264 has even edges: the video is %1 x %2 pixels, the last column or row twice", width, height));
    }
}

void addFault(KeyFault fault, std::string_view key, std::vector<Message>& remarks)
{
    switch (fault) {
    case KeyFault::OpenLoop:
        remarks.push_back(makeMessage("%1 does not end as it begins, so the loop jumps there", key));
        break;
    case KeyFault::AfterEnd:
        remarks.push_back(makeMessage("%1 has key frames after the end of the timeline", key));
        break;
    case KeyFault::RateJumps:
        remarks.push_back(
            makeMessage("%1 changes at once at a held key frame, so what it drives changes its pace with a jerk", key));
        break;
    }
}

/// What key frames do that nobody may want.
void addTracks(const Scene& scene, std::vector<Message>& remarks)
{
    const auto look = [&](const Tracks& tracks) {
        for (const Track& track : tracks.all()) {
            for (const KeyFault fault : keyFaults(track, scene.timeline)) {
                addFault(fault, track.parameter->key, remarks);
            }
        }
    };
    look(scene.tracks);
    for (const std::size_t layer : scene.visibleLayers()) {
        look(scene.layers[layer].tracks);
    }
}

/// Names of markers, of many the first few.
std::string listed(const std::vector<std::string>& names)
{
    constexpr std::size_t kListed = 5;
    const auto shown = static_cast<std::ptrdiff_t>(std::min(names.size(), kListed));
    return joined(std::vector<std::string>(names.begin(), names.begin() + shown))
        + (names.size() > kListed ? ", ..." : "");
}

/// Markers that no game hears of.
void addMarkers(const Scene& scene, const ExportPlan& plan, std::vector<Message>& remarks)
{
    const double length = lengthInSeconds(scene.timeline);
    const bool isFlipbook = plan.kind == ExportKind::Flipbook;
    std::vector<std::string> late;
    std::vector<std::string> outside;
    for (const Marker& marker : isFlipbook ? markersOutside(scene, flipbookOf(plan)) : scene.markers) {
        if (marker.seconds >= length) {
            late.push_back(inQuotes(marker.name));
        } else if (isFlipbook) {
            outside.push_back(inQuotes(marker.name));
        }
    }
    if (!late.empty()) {
        remarks.push_back(makeMessage("markers after the end of the timeline: %1", listed(late)));
    }
    if (!outside.empty()) {
        remarks.push_back(makeMessage("markers outside of the frames of the sheet: %1", listed(outside)));
    }
}

/// Presets are short but for their pictures.
void addCarried(const Scene& scene, const ExportPlan& plan, std::vector<Message>& remarks)
{
    const bool hasPicture = std::any_of(scene.layers.begin(), scene.layers.end(),
        [](const Layer& layer) { return !layer.emitter.picture.empty() || !layer.look.picture.empty(); });
    if (!plan.project || !hasPicture) {
        return;
    }
    Preset project = *plan.project;
    project.scene = scene;
    if (formatCarried(project).empty()) {
        remarks.push_back(makeMessage(
            "with its pictures the preset is longer than the %1 bytes that a file can carry: save it beside",
            kMaxNoteBytes));
    }
}

} // namespace

std::vector<Message> remarksOn(const Scene& scene, const ExportPlan& plan)
{
    std::vector<Message> remarks;
    addLoop(scene.timeline, plan, remarks);
    addTracks(scene, remarks);
    addMarkers(scene, plan, remarks);
    if (plan.kind == ExportKind::Video) {
        addVideo(scene, plan, remarks);
    }
    if (plan.kind == ExportKind::Flipbook) {
        std::ranges::move(engineRemarks(scene, flipbookOf(plan)), std::back_inserter(remarks));
    }
    addCarried(scene, plan, remarks);
    return remarks;
}

} // namespace fumage
