#include "core/export/video.h"

#include "core/base/child_process.h"
#include "core/base/environment.h"
#include "core/base/file_draft.h"
#include "core/rendering/renderer.h"
#include "core/rendering/view_transform.h"
#include "core/simulation/simulator.h"

#include <bit>
#include <map>

namespace fumage {

namespace {

/// How ffmpeg makes a format.
struct Recipe {
    std::string_view ending;
    bool alpha;
    bool wide; ///< takes 16 bits
    std::vector<std::string> arguments;
};

/// What sRGB pictures say of themselves in a video of YUV.
std::vector<std::string> taggedAsSrgb(std::vector<std::string> arguments)
{
    arguments.insert(arguments.end(), {"-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "iec61966-2-1"});
    return arguments;
}

const Recipe& recipeOf(VideoFormat format)
{
    static const std::map<VideoFormat, Recipe> recipes{
        {VideoFormat::Mp4,
            {".mp4", false, false,
                taggedAsSrgb({"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709", "-c:v", "libx264", "-crf", "16", "-pix_fmt", "yuv420p", "-movflags", "+faststart", "-f", "mp4"})}},
        {VideoFormat::WebM,
            {".webm", true, false,
                taggedAsSrgb({"-vf", "scale=out_color_matrix=bt709", "-c:v", "libvpx-vp9", "-crf", "18", "-b:v", "0", "-row-mt", "1", "-auto-alt-ref", "0", "-pix_fmt", "yuva420p", "-f", "webm"})}},
        {VideoFormat::QuickTime,
            {".mov", true, true,
                taggedAsSrgb({"-vf", "scale=out_color_matrix=bt709", "-c:v", "prores_ks", "-profile:v", "4444", "-alpha_bits", "16", "-pix_fmt", "yuva444p10le", "-f", "mov"})}},
        {VideoFormat::Gif, {".gif", false, false, {"-filter_complex", "split[a][b];[a]palettegen=stats_mode=diff[p];[b][p]paletteuse=dither=sierra2_4a", "-loop", "0", "-f", "gif"}}},
        {VideoFormat::Apng, {".apng", true, false, {"-c:v", "apng", "-pix_fmt", "rgba", "-plays", "0", "-f", "apng"}}},
    };
    return recipes.at(format);
}

std::string programForVideos()
{
    const std::string named = environmentVariable("FUMAGE_FFMPEG");
    return named.empty() ? "ffmpeg" : named;
}

std::vector<std::string> argumentsFor(const Effect& effect, const VideoOptions& options, const Recipe& recipe, const std::filesystem::path& file)
{
    const std::string size = std::to_string(effect.output.width) + "x" + std::to_string(effect.output.height);
    const std::string rate = std::to_string(effect.timeline.frameRate) + "/" + std::to_string(options.frames.step);
    const std::string_view wide = std::endian::native == std::endian::little ? "rgba64le" : "rgba64be";
    std::vector<std::string> arguments{"-hide_banner", "-loglevel", "error", "-f", "rawvideo", "-pix_fmt", std::string(recipe.wide ? wide : "rgba"), "-video_size", size, "-framerate", rate, "-i", "-"};
    arguments.insert(arguments.end(), recipe.arguments.begin(), recipe.arguments.end());
    arguments.insert(arguments.end(), {"-y", "file:" + file.string()});
    return arguments;
}

Result<ChildProcess> startFfmpeg(const std::vector<std::string>& arguments)
{
    Result<ChildProcess> program = ChildProcess::start(programForVideos(), arguments);
    if (!program) {
        Error error = program.error();
        error.remedy = said("Videos are made by ffmpeg: install it, or render pictures");
        return error;
    }
    return program;
}

/// Frames as ffmpeg takes them.
template <class Channel>
Status feed(const SampledEffect& smoke, const VideoOptions& options, bool alpha, const FrameSource& frames, ChildProcess& program, const Progress& progress, const std::stop_token& stop)
{
    Image image;
    EncodedImage<Channel> encoded;
    Output output = smoke->output;
    if (!alpha) {
        output.background = Background::Colour;
    }
    const int total = options.frames.count();
    for (int i = 0; i < total; ++i) {
        if (Status status = frames(options.frames.at(i), image); !status) {
            return status;
        }
        encode(image, output, encoded, coverOf(smoke->light));
        if (Status status = program.write(std::as_bytes(std::span(encoded.pixels)), stop); !status) {
            return status;
        }
        progress(Work::Frames, i + 1, total);
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

Status renderVideo(const Effect& effect, const VideoOptions& options, const Progress& progress, const std::stop_token& stop)
{
    const SampledEffect smoke = sampled(effect);
    Simulator simulator(smoke);
    Renderer renderer;
    const auto render = [&](int number, Image& image) -> Status {
        const Result<std::shared_ptr<const Frame>> frame = simulator.frame(number, stop, progress);
        return frame ? renderer.render(*frame.value(), smoke, smoke->output.width, smoke->output.height, image, stop) : Status(frame.error());
    };
    return joinVideo(effect, options, render, progress, stop);
}

Status joinVideo(const Effect& effect, const VideoOptions& options, const FrameSource& frames, const Progress& progress, const std::stop_token& stop)
{
    if (Status status = makeFolderOf(options.output); !status) {
        return status;
    }
    const SampledEffect smoke = sampled(effect);
    const Recipe& recipe = recipeOf(options.format);
    Result<FileDraft> draft = FileDraft::make(options.output, {}, FileAccess::Usual, FileDraft::Naming::Temporary);
    if (!draft) {
        return draft.error();
    }
    Result<ChildProcess> program = startFfmpeg(argumentsFor(smoke, options, recipe, draft.value().path()));
    if (!program) {
        return program.error();
    }
    Status fed = recipe.wide ? feed<std::uint16_t>(smoke, options, recipe.alpha, frames, program.value(), progress, stop)
                             : feed<std::uint8_t>(smoke, options, recipe.alpha, frames, program.value(), progress, stop);
    if (!fed) {
        return fed;
    }
    if (Status status = program.value().finish(stop); !status) {
        return status;
    }
    if (Status status = draft.value().flush(); !status) {
        return status;
    }
    return draft.value().publish();
}

} // namespace fumage
