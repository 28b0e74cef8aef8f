#include "app/cli/command.h"
#include "app/cli/picture_options.h"

#include "core/system/path.h"
#include "core/export/output_name.h"

#include <algorithm>
#include <memory>

namespace fumage::cli {

namespace {

std::vector<std::string> formatNames()
{
    std::vector<std::string> names;
    for (const VideoFormat format : kAllVideoFormats) {
        names.emplace_back(fileEnding(format).substr(1));
    }
    return names;
}

/// Fills in the file of a plan for a video, and what it is.
Status chooseVideo(const PictureOptions& options, const std::string& name, ExportPlan& plan)
{
    std::vector<std::string_view> endings;
    for (const VideoFormat format : kAllVideoFormats) {
        if (options.format.empty() || fileEnding(format).substr(1) == options.format) {
            endings.push_back(fileEnding(format));
        }
    }
    if (options.output == kStandardStream) {
        plan.output = pathFrom(options.output);
        return Done{};
    }
    const Result<std::filesystem::path> path = outputPath(options.output, {endings, name});
    if (!path) {
        return path.error();
    }
    const std::string ending = endingOf(path.value());
    const auto* const format = std::ranges::find(kAllVideoFormats,
        ending.empty() ? endings.front() : std::string_view(ending), [](VideoFormat each) { return fileEnding(each); });
    plan.video.format = *format;
    plan.output = withEnding(path.value(), fileEnding(plan.video.format));
    return Done{};
}

Status video(const PictureOptions& options)
{
    return options.effect.forEach(options.output, [&](const NamedPreset& named) -> Status {
        Result<PictureJob> job = options.jobWithoutOutput(named, ExportKind::Video);
        if (!job) {
            return job.error();
        }
        if (Status status = options.options.applyTo(job.value().plan); !status) {
            return status;
        }
        if (Status status = chooseVideo(options, named.name, job.value().plan); !status) {
            return status;
        }
        const Result<std::optional<Flipbook>> done = writePictures(job.value());
        return done ? Status(Done{}) : done.error();
    });
}

} // namespace

void addVideo(CLI::App& program, Action& action)
{
    auto options = std::make_shared<PictureOptions>();
    CLI::App* command = program.add_subcommand("video", "Render frames of a preset into a video, with ffmpeg");
    options->addTo(*command, "File to write. In a folder, and by default, the preset's name",
        "Picture size: 512 or 640x360. Default: the preset's");
    command
        ->add_option("--format", options->format,
            "mp4 (H.264), webm (VP9 with alpha), mov (ProRes 4444 with alpha), gif, apng (with alpha). Default: by the "
            "ending of the file")
        ->check(CLI::IsMember(formatNames()));
    options->options.addAllTo(*command, ExportKind::Video);
    command->footer("Needs ffmpeg on the search path; FUMAGE_FFMPEG names another program. mp4 and gif have no "
                    "transparency: the smoke is in front of output.background_colour.\n"
                    "gif has no more than 50 pictures a second: of more, one of two or three frames is in it. mp4 has "
                    "even edges: of odd ones, the last column or row is there twice.\n"
                    "Examples:\n"
                    "  fumage-cli video campfire --size 720 --output fire.mp4\n"
                    "  fumage-cli video explosion --set timeline.frame_rate=24 --rate 23.976 --output boom.mov\n"
                    "  fumage-cli video chimney --set timeline.loop=true --output smoke.webm");
    command->callback([options, &action] { action = [options] { return video(*options); }; });
}

} // namespace fumage::cli
