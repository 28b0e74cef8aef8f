#pragma once

#include "core/export/pass_picture.h"

namespace fumage {

/// All passes of one frame as targets of one EXR: the colour is the picture itself, the others are named as the files
/// of a flipbook are (sixway_a.R, motion.X, depth.Z), and their numbers are what they mean: light (right, top, back,
/// alpha; left, bottom, front, emissive) and emission unscaled, depth in m, motion in pixels from one picture to the
/// next, right and up; its third channel is 0. Light, emission and albedo are premultiplied or straight; motion,
/// normals and what is measured goes on beyond the smoke.
/// @param frame one cell, with the targets that the passes need
/// @error those of encodeImage()
[[nodiscard]] Result<std::vector<std::byte>> encodeTargets(const PassSheet& frame, PassSet passes, bool premultiplied,
    const Output& output, ImageFormat format, const ImageMetadata& notes, const std::stop_token& stop = {});

} // namespace fumage
