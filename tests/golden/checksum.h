#pragma once

#include "core/effect/effect.h"
#include "core/rendering/image.h"

#include <string>

namespace fumage::tests {

// What golden.txt has a line of, for every built-in preset. No Qt: machines without it compute them, too.

inline constexpr int kGoldenFrame = 45;

/// A built-in preset as a small picture of few particles.
[[nodiscard]] Effect goldenEffect(const std::string& id);
/// Another effect, likewise.
[[nodiscard]] Effect goldenEffect(const Effect& preset);

/// "id checksum", of the picture's floats.
[[nodiscard]] std::string goldenLine(const std::string& id, const Image& image);

} // namespace fumage::tests
