#include "app/cli/command.h"
#include "app/cli/file_choice.h"
#include "app/cli/picture_options.h"
#include "app/cli/export_arguments.h"
#include "app/cli/progress.h"

#include "core/system/file.h"
#include "core/base/memory.h"
#include "core/system/path.h"
#include "core/export/sheets/flipbook_files.h"
#include "core/export/video/video.h"
#include "core/preset/preset_file.h"

#include <memory>
#include <span>

namespace fumage::cli {

namespace {

struct JoinOptions {
    EffectOptions effect;
    std::string input;
    std::string frames;
    std::string output;
    std::string grid;
    ExportArguments playing;
};

/// What is written may be neither the preset nor one of the frames.
Status refuseInputs(const JoinOptions& options, const NamedPreset& named, const FrameRange& frames,
    std::span<const std::filesystem::path> files)
{
    for (const std::filesystem::path& file : files) {
        if (isSameFile(file, named.file)) {
            return wouldOverwrite(named.file);
        }
        if (isFileOfAFrame(file, pathFrom(options.input), frames, fileEnding(ImageFormat::ExrHalf))) {
            return Error{ErrorCode::WouldOverwrite,
                makeMessage("this would overwrite one of the frames that are joined"), file.string(),
                makeMessage("Choose another name")};
        }
    }
    return Done{};
}

Status joinToVideo(
    const JoinOptions& options, const NamedPreset& named, const FrameRange& frames, const FrameSource& source)
{
    const Result<FileChoice<VideoFormat>> choice = chooseFile(options.output, {}, named.name, kAllVideoFormats);
    if (!choice) {
        return choice.error();
    }
    if (Status status = refuseInputs(options, named, frames, std::span(&choice.value().file, 1)); !status) {
        return status;
    }
    ExportPlan plan;
    plan.kind = ExportKind::Video;
    plan.output = choice.value().file;
    plan.video.format = choice.value().format;
    plan.frames = frames;
    if (Status status = options.playing.applyTo(plan); !status) {
        return status;
    }
    warnOf(named.preset.scene, plan);
    ProgressBar bar("Joining");
    if (Status status = withinMemory([&] { return joinVideo(named.preset.scene, videoOf(plan), source, bar.task()); });
        !status) {
        return status;
    }
    tellWritten(1, plan.output, plan.output);
    return Done{};
}

Status joinToFlipbook(
    const JoinOptions& options, const NamedPreset& named, const FrameRange& frames, const FrameSource& source)
{
    ExportPlan plan;
    plan.kind = ExportKind::Flipbook;
    plan.frames = frames;
    if (Status status = parseGrid(options.grid, plan.flipbook.columns, plan.flipbook.rows); !status) {
        return status;
    }
    if (Status status = chooseOutput(options.output, {}, named.name, plan); !status) {
        return status;
    }
    FlipbookOptions flipbook = flipbookOf(plan);
    if (Status status = refuseInputs(options, named, frames, filesOf(named.preset.scene, flipbook)); !status) {
        return status;
    }
    warnOf(named.preset.scene, plan);
    ProgressBar bar("Joining");
    flipbook.preset = formatCarried(named.preset);
    const Result<Flipbook> done =
        withinMemory([&] { return joinFlipbook(named.preset.scene, flipbook, source, bar.task()); });
    if (!done) {
        return done.error();
    }
    tellWritten(done.value().files, done.value().picture, done.value().description);
    return Done{};
}

/// Whether a view transform would make another colour of a background that frames have in their light.
bool changesBackground(const Output& output)
{
    return output.background == Background::Colour
        && (output.viewTransform != ViewTransform::Standard || output.exposure != 0.0F);
}

bool isOpaque(const Image& image)
{
    for (std::size_t i = 3; i < image.pixels.size(); i += 4) {
        if (image.pixels[i] < 1.0F) {
            return false;
        }
    }
    return true;
}

/// The frames of files, which must be without the background.
FrameSource withoutBackground(const FrameSource& frames)
{
    return [frames](int frame, Image& image) -> Status {
        if (Status status = frames(frame, image); !status) {
            return status;
        }
        if (isOpaque(image)) {
            return Error{ErrorCode::OutOfRange,
                makeMessage(
                    "the frames have their background in them, of which the view transform would make another colour"),
                {},
                makeMessage(
                    "Render them with --set output.background=transparent: join puts the colour behind the smoke")};
        }
        return Done{};
    };
}

Status joinOne(const JoinOptions& options, const NamedPreset& named)
{
    const Result<FrameRange> frames = parseFrameRange(options.frames);
    if (!frames) {
        return frames.error();
    }
    const Output& output = named.preset.scene.output;
    const FrameSource source = framesOfFiles(pathFrom(options.input), frames.value(), output.width, output.height);
    const FrameSource smoke = changesBackground(output) ? withoutBackground(source) : source;
    return options.grid.empty() ? joinToVideo(options, named, frames.value(), smoke)
                                : joinToFlipbook(options, named, frames.value(), smoke);
}

} // namespace

void addJoin(CLI::App& program, Action& action)
{
    auto options = std::make_shared<JoinOptions>();
    CLI::App* command =
        program.add_subcommand("join", "Join frames that have been rendered to EXR into a video or a flipbook");
    options->effect.addTo(*command);
    command
        ->add_option("-i,--input", options->input, "The frames, as --output of render named them: out/smoke_####.exr")
        ->required()
        ->type_name("FILE");
    command->add_option("-f,--frames", options->frames, "Frames: 0-119 or 0-119:2")->required()->type_name("RANGE");
    command
        ->add_option("--grid", options->grid, "Make a flipbook with these columns and rows: 8 or 8x4. Default: a video")
        ->type_name("GRID");
    command->add_option("-o,--output", options->output, "File to write. In a folder, and by default, the preset's name")
        ->type_name("FILE");
    options->playing.addTo(*command, "frame_rate");
    options->playing.addTo(*command, "repeat");
    command->footer("The preset is the one that the frames were rendered of: it has their size and rate, the exposure, "
                    "the view and the background.\n"
                    "What comes out is what video and flipbook render, but for the rounding of half floats. Farms join "
                    "frames this way when all of them are there.\n"
                    "Examples:\n"
                    "  fumage-cli join chimney --input out/smoke_####.exr --frames 0-119 --output smoke.mp4\n"
                    "  fumage-cli join chimney --input out/smoke_####.exr --frames 0-119 --grid 8 --output smoke.png");
    command->callback([options, &action] {
        action = [options] {
            return options->effect.forEach(
                options->output, [&](const NamedPreset& named) { return joinOne(*options, named); });
        };
    });
}

} // namespace fumage::cli
