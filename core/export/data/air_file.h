#pragma once

#include "core/export/export_task.h"
#include "core/export/sequence.h"
#include "core/flow/field.h"
#include "core/scene/scene.h"

#include <array>
#include <string>
#include <string_view>

namespace fumage {

/// Files of vector fields, which engines move their own particles by.
enum class AirFormat {
    Fga, ///< Unreal: text
    Vf, ///< Unity: Volume File
};

/// All of them, in their order.
inline constexpr std::array kAllAirFormats{AirFormat::Fga, AirFormat::Vf};

/// ".fga" or ".vf".
[[nodiscard]] std::string_view fileEnding(AirFormat format);

/// The air in the middle of each cell as the bytes of a file, x fastest.
///
/// FGA: cells along the three axes, the box's ends, then the velocities, all separated by commas; in cm and cm/s, z up
/// and left-handed: our (x, z, y). Volume File: "VF_V", the cells as 16-bit numbers, then the velocities as floats; in
/// m/s, y up and left-handed: our (x, y, -z). It has no box, which must be told otherwise.
/// @param timeScale seconds of the air in one of the film, in whose seconds the velocities are
[[nodiscard]] std::string encodeAir(const AirField& air, AirFormat format, float timeScale = 1.0F);

struct AirSequenceOptions {
    std::filesystem::path output; ///< ## becomes the frame number; see framePath()
    FrameRange frames;
    AirFormat format = AirFormat::Fga;
    std::filesystem::path source; ///< the preset's file, which is not to be overwritten; empty where it has none
    FrameSink written{}; ///< hears of each file that is in its place, if there is anybody
};

/// Writes the air of frames into numbered files, each whole or not at all.
/// @return the box that the air is in
/// @error  OutOfRange where no air carries the smoke; that of checkAir(); WouldOverwrite; that of the first frame that
/// fails: files before it stay
[[nodiscard]] Result<AirGrid> writeAir(
    const Scene& scene, const AirSequenceOptions& options, const ExportTask& task = {});

} // namespace fumage
