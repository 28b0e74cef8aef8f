// Tables of key frames and what follows --animate and --marker are either refused with a message, or are tracks and
// markers that can be used, written and read again. The first byte chooses the parameter.

#include "tests/fuzz/tracks.h"

#include "core/effect/parameter_table.h"
#include "core/scene/key_assignment.h"
#include "core/scene/marker_assignment.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace {

using namespace fumage;
using namespace fumage::tests;

void readTable(const Parameter& parameter, std::string_view text)
{
    const Result<Track> track = parseKeyTable(parameter, text, 24);
    FUMAGE_EXPECT(track || !track.error().message.empty());
    if (track) {
        expectTrack(track.value(), {});
    }
}

void animate(const Parameter& parameter, std::string_view text)
{
    Scene scene;
    const Result<bool> animated = animateScene(scene, std::string(parameter.key) + "=" + std::string(text));
    FUMAGE_EXPECT(animated || !animated.error().message.empty());
    FUMAGE_EXPECT(animated || scene == Scene());
    if (const Track* track = scene.tracksOf(parameter, 0).find(parameter)) {
        expectTrack(*track, scene.timeline);
    }
    FUMAGE_EXPECT(withoutKeyFaults(scene).layers.size() == 1);
}

void mark(std::string_view text)
{
    Scene scene;
    const Result<bool> marked = markScene(scene, text);
    FUMAGE_EXPECT(marked || (!marked.error().message.empty() && scene == Scene()));
    FUMAGE_EXPECT(checkMarkers(scene.markers));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    mark(text);
    if (!text.empty()) {
        const auto table = parameterTable();
        const Parameter& parameter = table[data[0] % table.size()];
        readTable(parameter, text.substr(1));
        animate(parameter, text.substr(1));
    }
    return 0;
}
