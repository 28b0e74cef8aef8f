#include "core/export/video/video.h"

#include "core/system/child_process.h"
#include "core/system/environment.h"
#include "core/system/file.h"
#include "core/system/file_draft.h"
#include "core/export/loop.h"
#include "core/rendering/scene_renderer.h"
#include "core/rendering/view_transform.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

namespace fumage {

namespace {

/// How ffmpeg makes a format.
struct Recipe {
    std::string_view ending;
    bool alpha;
    bool wide; ///< takes 16 bits
    bool even; ///< its edges must be
    std::vector<std::string> arguments;
};

/// What sRGB pictures say of themselves in a video of YUV.
std::vector<std::string> taggedAsSrgb(std::vector<std::string> arguments)
{
    arguments.insert(
        arguments.end(), {"-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "iec61966-2-1"});
    return arguments;
}

const Recipe& recipeOf(VideoFormat format)
{
    static const std::map<VideoFormat, Recipe> recipes{
        {VideoFormat::Mp4,
            {".mp4", false, false, true,
                taggedAsSrgb({"-vf", "scale=out_color_matrix=bt709", "-c:v", "libx264", "-crf", "16", "-pix_fmt",
                    "yuv420p", "-movflags", "+faststart", "-f", "mp4"})}},
        {VideoFormat::WebM,
            {".webm", true, false, false,
                taggedAsSrgb({"-vf", "scale=out_color_matrix=bt709", "-c:v", "libvpx-vp9", "-crf", "18", "-b:v", "0",
                    "-row-mt", "1", "-auto-alt-ref", "0", "-pix_fmt", "yuva420p", "-f", "webm"})}},
        // What reads ProRes looks at its frames before it looks at the container; they know no transfer of sRGB, and
        // BT.709's stands for it.
        {VideoFormat::QuickTime,
            {".mov", true, true, false,
                taggedAsSrgb({"-vf", "scale=out_color_matrix=bt709", "-c:v", "prores_ks", "-profile:v", "4444",
                    "-alpha_bits", "16", "-pix_fmt", "yuva444p10le", "-bsf:v",
                    "prores_metadata=color_primaries=bt709:color_trc=bt709:colorspace=bt709", "-f", "mov"})}},
        {VideoFormat::Gif,
            {".gif", false, false, false,
                {"-filter_complex", "split[a][b];[a]palettegen=stats_mode=diff[p];[b][p]paletteuse=dither=sierra2_4a",
                    "-f", "gif"}}},
        {VideoFormat::Apng, {".apng", true, false, false, {"-c:v", "apng", "-pix_fmt", "rgba", "-f", "apng"}}},
    };
    return recipes.at(format);
}

std::string programForVideos()
{
    const std::string named = environmentVariable("FUMAGE_FFMPEG");
    return named.empty() ? "ffmpeg" : named;
}

/// Frames of the timeline in a second of the video.
FrameRate rateOf(const Scene& scene, const VideoOptions& options)
{
    return options.rate.value_or(FrameRate{scene.timeline.frameRate, 1});
}

/// How a file says how often it is played.
std::vector<std::string> repeatsOf(const Scene& scene, const VideoOptions& options)
{
    const bool forever = options.repeat == Repeat::Auto ? turnOf(scene.timeline, options.frames).has_value()
                                                        : options.repeat == Repeat::Forever;
    switch (options.format) {
    case VideoFormat::Gif: return {"-loop", forever ? "0" : "-1"};
    case VideoFormat::Apng: return {"-plays", forever ? "0" : "1"};
    default: return {};
    }
}

std::vector<std::string> argumentsFor(
    const Scene& scene, const VideoOptions& options, const Recipe& recipe, const std::filesystem::path& file)
{
    const auto [width, height] = sizeOf(scene.output, options.format);
    const std::string size = std::to_string(width) + "x" + std::to_string(height);
    const FrameRate played = rateOf(scene, options);
    const std::string rate = std::to_string(played.frames) + "/"
        + std::to_string(static_cast<std::int64_t>(played.seconds) * framesOf(scene, options).step);
    const std::string_view wide = std::endian::native == std::endian::little ? "rgba64le" : "rgba64be";
    std::vector<std::string> arguments{"-hide_banner", "-loglevel", "error", "-f", "rawvideo", "-pix_fmt",
        std::string(recipe.wide ? wide : "rgba"), "-video_size", size, "-framerate", rate, "-i", "-"};
    arguments.insert(arguments.end(), recipe.arguments.begin(), recipe.arguments.end());
    const std::vector<std::string> repeats = repeatsOf(scene, options);
    arguments.insert(arguments.end(), repeats.begin(), repeats.end());
    arguments.insert(arguments.end(), {"-y", "file:" + file.string()});
    return arguments;
}

Result<ChildProcess> startFfmpeg(const std::vector<std::string>& arguments)
{
    Result<ChildProcess> program = ChildProcess::start(programForVideos(), arguments);
    if (!program) {
        Error error = program.error();
        if (error.code != ErrorCode::OutOfMemory) {
            error.remedy = makeMessage("Videos are made by ffmpeg: install it, or render pictures");
        }
        return error;
    }
    return program;
}

/// Makes a picture larger by its last column and row.
template <class Channel>
void widen(EncodedImage<Channel>& image, const std::array<int, 2>& size)
{
    const auto [width, height] = size;
    if (image.width == width && image.height == height) {
        return;
    }
    EncodedImage<Channel> wide{width, height, {}};
    wide.pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto from =
                (static_cast<std::size_t>(std::min(y, image.height - 1)) * static_cast<std::size_t>(image.width)
                    + static_cast<std::size_t>(std::min(x, image.width - 1)))
                * 4;
            std::copy_n(image.pixels.data() + from, 4,
                wide.pixels.data()
                    + (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x))
                        * 4);
        }
    }
    image = std::move(wide);
}

/// A program may end well without having done anything, as "true" does.
Status refuseEmpty(const std::filesystem::path& video)
{
    std::error_code unknown;
    const bool isEmpty = std::filesystem::file_size(video, unknown) == 0 && !unknown;
    return isEmpty ? Error{ErrorCode::NotAFile, makeMessage("the program has written no video"), programForVideos(),
               makeMessage("Let FUMAGE_FFMPEG name an ffmpeg, or leave it out")}
                   : Status(Done{});
}

/// Frames as ffmpeg takes them.
template <class Channel>
Status feed(const Scene& scene, const VideoOptions& options, bool alpha, const FrameSource& frames,
    ChildProcess& program, const Task& task)
{
    Image image;
    EncodedImage<Channel> encoded;
    const FrameRange numbers = framesOf(scene, options);
    const int total = numbers.count();
    for (int i = 0; i < total; ++i) {
        if (Status status = frames(numbers.at(i), image); !status) {
            return status;
        }
        Scene now = scene.atFrame(numbers.at(i));
        if (!alpha) {
            now.output.background = Background::Colour;
        }
        encode(image, now.output, encoded, coverOf(now));
        widen(encoded, sizeOf(scene.output, options.format));
        if (Status status = program.write(std::as_bytes(std::span(encoded.pixels)), task.stop); !status) {
            return status;
        }
        task.progress(ProgressPhase::Frames, i + 1, total);
    }
    return Done{};
}

} // namespace

std::string_view fileEnding(VideoFormat format)
{
    return recipeOf(format).ending;
}

bool hasAlpha(VideoFormat format)
{
    return recipeOf(format).alpha;
}

bool saysHowOften(VideoFormat format)
{
    return format == VideoFormat::Gif || format == VideoFormat::Apng;
}

std::string_view nameOf(Repeat repeat)
{
    constexpr std::array<std::string_view, kRepeats> kNames{"auto", "once", "forever"};
    return kNames[static_cast<std::size_t>(repeat)];
}

FrameRange framesOf(const Scene& scene, const VideoOptions& options)
{
    constexpr double kMaxOfGif = 50.0; // a second: browsers take a delay of less than 20 ms for 100
    constexpr double kRounding = 1e-9;
    FrameRange frames = options.frames;
    const double rate = rateOf(scene, options).perSecond() / frames.step;
    if (options.format != VideoFormat::Gif || rate <= kMaxOfGif) {
        return frames;
    }
    const int least = static_cast<int>(std::ceil(rate / kMaxOfGif - kRounding));
    int every = least;
    while (every < 2 * least && frames.count() % every != 0) {
        ++every;
    }
    frames.step *= frames.count() % every == 0 ? every : least;
    return frames;
}

std::array<int, 2> sizeOf(const Output& output, VideoFormat format)
{
    const auto edge = [even = recipeOf(format).even](int pixels) { return even ? pixels + pixels % 2 : pixels; };
    return {edge(output.width), edge(output.height)};
}

Status renderVideo(const Scene& scene, const VideoOptions& options, const ExportTask& task)
{
    SceneRenderer renderer(scene, task.shelf);
    const auto render = [&](int number, Image& image) -> Status {
        return renderer.render(number, scene.output.width, scene.output.height, image, task);
    };
    return joinVideo(scene, options, render, task);
}

Status joinVideo(const Scene& scene, const VideoOptions& options, const FrameSource& frames, const Task& task)
{
    if (Status status = makeFolderOf(options.output); !status) {
        return status;
    }
    const Recipe& recipe = recipeOf(options.format);
    Result<FileDraft> draft = FileDraft::make(options.output, {}, FileAccess::Usual, FileDraft::Naming::Temporary);
    if (!draft) {
        return draft.error();
    }
    Result<ChildProcess> program = startFfmpeg(argumentsFor(scene, options, recipe, draft.value().path()));
    if (!program) {
        return program.error();
    }
    Status fed = recipe.wide ? feed<std::uint16_t>(scene, options, recipe.alpha, frames, program.value(), task)
                             : feed<std::uint8_t>(scene, options, recipe.alpha, frames, program.value(), task);
    if (!fed) {
        return fed;
    }
    if (Status status = program.value().finish(task.stop); !status) {
        return status;
    }
    if (Status status = refuseEmpty(draft.value().path()); !status) {
        return status;
    }
    if (Status status = draft.value().flush(); !status) {
        return status;
    }
    return draft.value().publish();
}

} // namespace fumage
