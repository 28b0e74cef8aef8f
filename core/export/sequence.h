#pragma once

#include "core/base/task.h"
#include "core/export/export_task.h"
#include "core/effect/effect.h"
#include "core/export/image_file.h"
#include "core/rendering/passes.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fumage {

/// Frames first, first + step, ... up to last.
struct FrameRange {
    int first = 0;
    int last = 0;
    int step = 1;

    /// How many frames there are, 1 or more.
    [[nodiscard]] int count() const { return (last - first) / step + 1; }
    /// The frame that stands at a place, 0 to count() - 1.
    [[nodiscard]] int at(int index) const { return first + index * step; }
    [[nodiscard]] bool has(int frame) const { return frame >= first && frame <= last && (frame - first) % step == 0; }
};

/// The numbers of all frames of a range. O(frames).
[[nodiscard]] std::vector<int> numbersOf(const FrameRange& frames);

/// Largest frame number that may be asked for.
inline constexpr int kMaxFrame = 1'000'000;

/// Reads "7", "0-119" or "0-119:2".
/// @error Syntax, OutOfRange
[[nodiscard]] Result<FrameRange> parseFrameRange(std::string_view text);
/// What parseFrameRange() reads.
[[nodiscard]] std::string textOf(const FrameRange& frames);

/// The file of a frame: what stands for the number, see numberPlaceIn(), is replaced by it with as many digits; a name
/// without gets _0000 before its ending when there are several frames.
/// @param ending with its dot; added where it is missing
[[nodiscard]] std::filesystem::path framePath(
    const std::filesystem::path& output, const FrameRange& frames, std::string_view ending, int frame);

/// Whether the file of one of the frames is one that is there already and must stay, be it through a link. O(frames).
/// @param file empty: none
[[nodiscard]] bool isFileOfAFrame(const std::filesystem::path& file, const std::filesystem::path& output,
    const FrameRange& frames, std::string_view ending);

/// Takes the bytes of a frame's file, one frame after the other, on a thread of its own.
using FrameSink = std::function<Status(int frame, std::span<const std::byte> bytes)>;

struct SequenceOptions {
    std::filesystem::path output; ///< ## in the file name becomes the frame number; see framePath()
    FrameRange frames;
    ImageFormat format = ImageFormat::Png8;
    PassSet passes{Pass::Colour}; ///< with others than the colour each file is an EXR of targets; see encodeTargets()
    bool premultiplied = true; ///< light, emission and albedo of the targets
    std::string preset{}; ///< that the pictures carry, as JSON; empty: none
    std::vector<int> leftOut{}; ///< frames of the range that are not rendered; they rise
    FrameSink written{}; ///< hears of each file that is in its place, if there is anybody
    bool isNumbered = true; ///< else one picture: its name is as it stands
};

[[nodiscard]] std::filesystem::path framePath(const SequenceOptions& options, int frame);
/// The frames that are rendered, in their order.
[[nodiscard]] std::vector<int> numbersOf(const SequenceOptions& options);

/// Files that are numbered by their frames.
struct NumberedFiles {
    std::filesystem::path output; ///< ## becomes the frame number; see framePath()
    FrameRange frames;
    std::string_view ending; ///< with its dot
    std::filesystem::path source; ///< the preset's file, which is not to be overwritten; empty where it has none
    FrameSink written{}; ///< hears of each file that is in its place, if there is anybody
};

/// Writes a file a frame, each whole or not at all, into a folder that is made if it is not there.
/// @param bytesOf what a frame's file holds; its error ends the work
/// @param task    hears of ProgressPhase::Frames after each
/// @error WouldOverwrite; that of the first frame that fails: files before it stay
[[nodiscard]] Status writeNumbered(
    const NumberedFiles& files, const std::function<Result<std::string>(int frame)>& bytesOf, const Task& task = {});

/// Renders one frame into the bytes of a file.
/// @param options what the file holds; its range and name mean nothing here
/// @error those of renderSequence()
[[nodiscard]] Result<std::vector<std::byte>> encodeFrame(
    const Scene& scene, int frame, const SequenceOptions& options, const ExportTask& task = {});

/// Renders the frames of a range into the bytes of their files. What a frame's file holds is the same whatever else is
/// in the range, as long as the step is. A file is encoded and taken while the next frame is simulated.
/// @param sink its error ends the work
/// @error those of renderSequence()
[[nodiscard]] Status encodeFrames(
    const Scene& scene, const SequenceOptions& options, const FrameSink& sink, const ExportTask& task = {});

/// Renders frames into numbered files. The folder is made if it is not there. Each file is written whole or not at all.
/// @param task hears of ProgressPhase::Frames after each, and of what leads to them
/// @error OutOfRange where passes are asked for that the format cannot hold; else that of the first frame that fails;
/// files before it stay
[[nodiscard]] Status renderSequence(const Scene& scene, const SequenceOptions& options, const ExportTask& task = {});

} // namespace fumage
