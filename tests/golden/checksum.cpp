#include "tests/golden/checksum.h"

#include "core/base/sha256.h"
#include "core/preset/library.h"

#include <algorithm>
#include <span>

namespace fumage::tests {

Effect goldenEffect(const std::string& id)
{
    return goldenEffect(loadPreset(LibraryEntry{id, {}}).value().preset.scene.effect());
}

Effect goldenEffect(const Effect& preset)
{
    constexpr int kEdge = 96;
    constexpr int kGoldenParticles = 20000;
    Effect effect = preset;
    effect.emitter.count = std::min(effect.emitter.count, kGoldenParticles);
    effect.output.width = kEdge;
    effect.output.height = kEdge;
    return effect;
}

std::string goldenLine(const std::string& id, const Image& image)
{
    constexpr std::size_t kDigits = 24;
    return id + " " + sha256Of(std::as_bytes(std::span(image.pixels))).substr(0, kDigits);
}

} // namespace fumage::tests
