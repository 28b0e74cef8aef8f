#pragma once

#include "core/export/export_task.h"
#include "core/export/video/frame_rate.h"
#include "core/export/frame_source.h"
#include "core/scene/scene.h"

#include <array>
#include <optional>

namespace fumage {

/// What a video is written as.
enum class VideoFormat {
    Mp4, ///< H.264, which has no transparency
    WebM, ///< VP9 with alpha
    QuickTime, ///< ProRes 4444 with alpha
    Gif, ///< 256 colours, which has no soft transparency
    Apng, ///< a PNG that moves, with alpha
};

inline constexpr std::array kAllVideoFormats{
    VideoFormat::Mp4, VideoFormat::WebM, VideoFormat::QuickTime, VideoFormat::Gif, VideoFormat::Apng};

/// ".mp4", ".webm", ".mov", ".gif" or ".apng".
[[nodiscard]] std::string_view fileEnding(VideoFormat format);

/// Whether it holds smoke on a transparent background. Others have the effect's colour of the background behind it.
[[nodiscard]] bool hasAlpha(VideoFormat format);

/// Whether its files say how often they are played.
[[nodiscard]] bool saysHowOften(VideoFormat format);

/// How often a GIF or an APNG is played.
enum class Repeat {
    Auto, ///< for ever where its frames close a loop, else once
    Once,
    Forever,
};
inline constexpr std::size_t kRepeats = 3;
/// "auto", "once" or "forever".
[[nodiscard]] std::string_view nameOf(Repeat repeat);

struct VideoOptions {
    std::filesystem::path output; ///< with its ending
    FrameRange frames;
    VideoFormat format = VideoFormat::Mp4;
    Repeat repeat = Repeat::Auto;
    std::optional<FrameRate> rate{}; ///< at which frames of the timeline are played; none: the timeline's
};

/// The frames that a video has: of a GIF every second, third, ... where it would have more than 50 a second, which
/// browsers play at 10. Of several steps that do, one that divides the frames is taken, so that a loop stays one.
[[nodiscard]] FrameRange framesOf(const Scene& scene, const VideoOptions& options);

/// Width and height of the video, pixels: even where its format asks for that.
[[nodiscard]] std::array<int, 2> sizeOf(const Output& output, VideoFormat format);

/// Renders frames into a video, by the program ffmpeg, which must be on the search path; the environment variable
/// FUMAGE_FFMPEG names another. Colours are those of PNG: sRGB after exposure and view transform. Where the format has
/// even edges alone, the last column and row are there twice. The file is written whole or not at all. One frame is
/// encoded while the next is made.
/// @param task as renderSequence()
/// @error FileNotFound without ffmpeg, WriteFailed with what it said, Cancelled, those of writeFileAtomically()
[[nodiscard]] Status renderVideo(const Scene& scene, const VideoOptions& options, const ExportTask& task = {});

/// The same of frames that are there already.
/// @error those of renderVideo() and of the frames
[[nodiscard]] Status joinVideo(
    const Scene& scene, const VideoOptions& options, const FrameSource& frames, const Task& task = {});

} // namespace fumage
