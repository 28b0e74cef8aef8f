// Any bytes are either refused with a message, or read, written and read again to the same preset.

#include "core/preset/preset_file.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace fumage;
    const Result<PresetReading> first = parsePreset({reinterpret_cast<const char*>(data), size});
    if (!first) {
        if (first.error().message.empty()) {
            std::abort();
        }
        return 0;
    }
    const std::string json = formatPreset(first.value().preset);
    const Result<PresetReading> second = parsePreset(json);
    if (!second || !(second.value().preset.scene.effect() == first.value().preset.scene.effect())
        || formatPreset(second.value().preset) != json) {
        std::abort();
    }
    return 0;
}
