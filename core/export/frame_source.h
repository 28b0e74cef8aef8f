#pragma once

#include "core/export/sequence.h"
#include "core/rendering/image.h"

namespace fumage {

/// Gives the picture of a frame: linear, premultiplied, before exposure and view transform.
using FrameSource = std::function<Status(int frame, Image& image)>;

/// Frames that have been rendered to EXR: their colour, whatever targets there are beside it. Sheets and videos are
/// joined of them without rendering anything.
/// @param output as renderSequence() was given it; see framePath()
/// @param width,height that they have to have
/// The source's errors: those of readFile() and of broken pictures; WrongType where one is no EXR with R, G, B and A,
/// or of another size
[[nodiscard]] FrameSource framesOfFiles(
    const std::filesystem::path& output, const FrameRange& frames, int width, int height);

} // namespace fumage
