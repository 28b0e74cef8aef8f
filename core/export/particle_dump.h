#pragma once

#include "core/base/result.h"
#include "core/simulation/frame.h"

#include <stop_token>
#include <string>
#include <string_view>

namespace fumage {

enum class ParticleFormat {
    Csv, ///< text, one particle a line
    Ply, ///< binary vertices
};

/// ".csv" or ".ply".
[[nodiscard]] std::string_view fileEnding(ParticleFormat format);

/// The living particles of a frame as text, one a line after a heading:
/// id, x, y, z (m), vx, vy, vz (m/s, without turbulence), age (s), life (0..1), alpha (0..1), radius (m). Shortest round-trip numbers.
/// @param effect the look that alpha and radius follow
[[nodiscard]] std::string dumpCsv(const Frame& frame, const SampledEffect& effect);

/// The same as a binary little-endian PLY of vertices, with the same properties.
[[nodiscard]] std::string dumpPly(const Frame& frame, const SampledEffect& effect);

/// Simulates up to a frame and returns its particles as the bytes of a file.
/// @error those of Simulator::frame()
[[nodiscard]] Result<std::string> dumpParticles(const Effect& effect, int frame, ParticleFormat format, const std::stop_token& stop = {});

} // namespace fumage
