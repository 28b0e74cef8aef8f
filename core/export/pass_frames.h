#pragma once

#include "core/export/pass_picture.h"

namespace fumage {

/// All passes of one frame as targets of one EXR: the colour is the picture itself, the others are named as the files
/// of a flipbook are (sixway_a.R, motion.X, depth.Z), and their numbers are what they mean: light (right, top, back,
/// alpha; left, bottom, front, emissive) and emission unscaled, depth in m, motion in pixels from one picture to the
/// next, right and up; its third channel is 0. Light, emission and albedo are premultiplied or straight; motion,
/// normals and what is measured goes on beyond the smoke. Masks of layers have a target each, mask_flames.Y.
/// @param frame one cell, with the targets and the masks that the passes need
/// @error those of encodeImage()
[[nodiscard]] Result<std::vector<std::byte>> encodeTargets(const PassSheet& frame, PassSet passes, bool premultiplied,
    const Output& output, ImageFormat format, const ImageMetadata& notes, const std::stop_token& stop = {});

/// Whether frames of a scene can be written with such passes.
/// @error OutOfRange where the format cannot hold them; TooLarge
[[nodiscard]] Status checkTargets(const Scene& scene, PassSet passes, ImageFormat format);

} // namespace fumage
