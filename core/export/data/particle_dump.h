#pragma once

#include "core/export/export_task.h"
#include "core/export/sequence.h"
#include "core/export/data/up_axis.h"
#include "core/rendering/renderer.h"
#include "core/scene/scene.h"

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace fumage {

enum class ParticleFormat {
    Csv, ///< text, one particle a line
    Ply, ///< binary vertices
    Pcache, ///< Unity's point cache, binary
};

/// All of them, in their order.
inline constexpr std::array kAllParticleFormats{ParticleFormat::Csv, ParticleFormat::Ply, ParticleFormat::Pcache};

/// ".csv", ".ply" or ".pcache".
[[nodiscard]] std::string_view fileEnding(ParticleFormat format);

/// The living particles of a frame as text, one a line after a heading:
/// id (the number of its birth modulo 2^31, the same at every frame), x, y, z (m), vx, vy, vz (m/s of the film,
/// without turbulence), age (s of the film), life (0..1), alpha (0..1), radius (m), heat (of the air at the particle,
/// 1 at the source; 0 without air), red, green, blue (linear, before light). Shortest round-trip numbers.
/// Of several layers the first column is the layer's number from 1. Alpha, radius and colour follow their looks.
/// @param numbers of the layers in their scene, from 0, where muted ones lie between them; empty: as they come
[[nodiscard]] std::string dumpCsv(LayerFrames layers, UpAxis up = UpAxis::Y, std::span<const std::size_t> numbers = {});

/// The same of one layer.
[[nodiscard]] inline std::string dumpCsv(const Frame& frame, const SampledEffect& effect, UpAxis up = UpAxis::Y)
{
    const LayerFrame layer{&frame, &effect};
    return dumpCsv({&layer, 1}, up);
}

/// The same as a binary little-endian PLY of vertices; the colours are sRGB in 8 bits, as programs expect them there.
[[nodiscard]] std::string dumpPly(LayerFrames layers, UpAxis up = UpAxis::Y, std::span<const std::size_t> numbers = {});

/// The same for Unity's VFX Graph: position, velocity, age, lifetime (s), size (m, across), color (linear, and alpha),
/// heat. Unity's axes are left-handed with y up: our (x, y, -z).
[[nodiscard]] std::string dumpPcache(LayerFrames layers);

/// Simulates up to a frame and returns its particles as the bytes of a file.
/// @error those of SceneSimulator::frame()
[[nodiscard]] Result<std::string> dumpParticles(
    const Scene& scene, int frame, ParticleFormat format, UpAxis up = UpAxis::Y, const ExportTask& task = {});

struct ParticleSequenceOptions {
    std::filesystem::path output; ///< ## becomes the frame number; see framePath()
    FrameRange frames;
    ParticleFormat format = ParticleFormat::Csv;
    UpAxis up = UpAxis::Y;
    std::filesystem::path source; ///< the preset's file, which is not to be overwritten; empty where it has none
    FrameSink written{}; ///< hears of each file that is in its place, if there is anybody
};

/// Writes the particles of frames into numbered files, each whole or not at all.
/// @error WouldOverwrite; that of the first frame that fails: files before it stay
[[nodiscard]] Status dumpSequence(
    const Scene& scene, const ParticleSequenceOptions& options, const ExportTask& task = {});

} // namespace fumage
