// Any bytes are either refused with a message, or read, written and read again to the same preset, whose key frames and
// markers can be used.

#include "tests/fuzz/tracks.h"

#include "core/export/sheets/sheet_events.h"
#include "core/preset/preset_file.h"
#include "core/simulation/schedule.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace {

using namespace fumage;
using namespace fumage::tests;

void useTracks(const Scene& scene)
{
    for (std::size_t layer = 0; layer < scene.layers.size(); ++layer) {
        const Tracks tracks = scene.allTracks(layer);
        for (const Track& track : tracks.all()) {
            expectTrack(track, scene.timeline);
        }
        // A long timeline has a table of births that is as long.
        constexpr int kShort = 300;
        if (scene.timeline.length <= kShort && tracks.any(Animates::Rate)) {
            const Schedule schedule = makeSchedule(sampledLayer(scene, layer));
            const std::vector<std::int64_t> births = birthsOfFrames(schedule, scene.timeline.length);
            FUMAGE_EXPECT(std::all_of(births.begin(), births.end(), [](std::int64_t each) { return each >= 0; }));
        }
    }
    FUMAGE_EXPECT(scene.atFrame(3).layers.size() == scene.layers.size());
    Preset mended;
    mended.scene = withoutKeyFaults(scene);
    const Result<PresetReading> again = parsePreset(formatPreset(mended));
    FUMAGE_EXPECT(again && again.value().preset.scene == mended.scene);
}

void useMarkers(const Scene& scene)
{
    FUMAGE_EXPECT(checkMarkers(scene.markers));
    FlipbookOptions options;
    options.columns = 3;
    options.rows = 2;
    options.frames = {0, 23, 1};
    const std::vector<SheetEvent> events = sheetEvents(scene, options);
    for (const SheetEvent& event : events) {
        FUMAGE_EXPECT(event.cell >= 0 && event.cell < 6 && event.seconds >= 0.0);
        FUMAGE_EXPECT(std::any_of(scene.markers.begin(), scene.markers.end(),
            [&](const Marker& marker) { return marker.name == event.name; }));
    }
    FUMAGE_EXPECT(markersOutside(scene, options).size() <= scene.markers.size());
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const Result<PresetReading> first = parsePreset({reinterpret_cast<const char*>(data), size});
    if (!first) {
        FUMAGE_EXPECT(!first.error().message.empty());
        return 0;
    }
    const Scene& scene = first.value().preset.scene;
    const std::string json = formatPreset(first.value().preset);
    const Result<PresetReading> second = parsePreset(json);
    FUMAGE_EXPECT(second && second.value().preset.scene == scene);
    FUMAGE_EXPECT(formatPreset(second.value().preset) == json);
    useTracks(scene);
    useMarkers(scene);
    return 0;
}
