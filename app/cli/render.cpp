#include "app/cli/command.h"
#include "app/cli/progress.h"

#include "core/base/text.h"
#include "core/effect/value.h"
#include "core/export/sequence.h"

#include <filesystem>
#include <iostream>
#include <map>
#include <memory>

namespace fumage::cli {

namespace {

const std::map<std::string, ImageFormat> kFormats{{"png", ImageFormat::Png8}, {"png16", ImageFormat::Png16}, {"exr", ImageFormat::ExrHalf}, {"exr32", ImageFormat::ExrFloat}};

struct RenderOptions {
    EffectOptions effect;
    std::string output;
    std::string frames;
    std::string size;
    int supersample = 0;
    std::string format;
};

/// "640x360" becomes output.width and output.height.
Status applySize(const std::string& size, Effect& effect)
{
    const std::size_t cross = size.find('x');
    const std::optional<std::int64_t> width = parseInteger(size.substr(0, cross));
    const std::optional<std::int64_t> height = cross == std::string::npos ? width : parseInteger(size.substr(cross + 1));
    constexpr std::int64_t kLargest = 8192;
    if (!width || !height || *width < 1 || *height < 1 || *width > kLargest || *height > kLargest) {
        return Error{ErrorCode::OutOfRange, "the size " + inQuotes(size) + " is not understood", "--size", "Write 512 or 640x360, with edges from 1 to " + std::to_string(kLargest)};
    }
    effect.output.width = static_cast<int>(*width);
    effect.output.height = static_cast<int>(*height);
    return Done{};
}

ImageFormat chooseFormat(const RenderOptions& options)
{
    if (!options.format.empty()) {
        return kFormats.at(options.format);
    }
    return std::filesystem::path(options.output).extension() == ".exr" ? ImageFormat::ExrHalf : ImageFormat::Png8;
}

Status render(const RenderOptions& options)
{
    Result<Effect> loaded = options.effect.load();
    if (!loaded) {
        return loaded.error();
    }
    Effect effect = loaded.value();
    if (!options.size.empty()) {
        if (Status status = applySize(options.size, effect); !status) {
            return status;
        }
    }
    if (options.supersample > 0) {
        effect.output.supersample = options.supersample;
    }
    SequenceOptions sequence;
    sequence.frames = {0, effect.timeline.length - 1, 1};
    if (!options.frames.empty()) {
        const Result<FrameRange> range = parseFrameRange(options.frames);
        if (!range) {
            return range.error();
        }
        sequence.frames = range.value();
    }
    sequence.format = chooseFormat(options);
    sequence.output = options.output.empty() ? std::filesystem::path(options.effect.preset).stem() : std::filesystem::path(options.output);

    ProgressBar bar("Rendering");
    return renderSequence(
        effect, sequence, [&](int done, int total) { bar.show(done, total); }, interruption());
}

} // namespace

void addRender(CLI::App& program, Action& action)
{
    auto options = std::make_shared<RenderOptions>();
    CLI::App* command = program.add_subcommand("render", "Render frames of a preset to numbered pictures");
    options->effect.addTo(*command);
    command->add_option("-o,--output", options->output, "File to write; #### stands for the frame number. Default: the preset's name")->type_name("FILE");
    command->add_option("-f,--frames", options->frames, "Frames: 7, 0-119 or 0-119:2. Default: the whole timeline")->type_name("RANGE");
    command->add_option("--size", options->size, "Picture size: 512 or 640x360. Default: the preset's")->type_name("SIZE");
    command->add_option_function<std::string>(
        "--quality", [options](const std::string& name) { options->effect.assignments.push_back("output.quality=" + name); }, "draft, good or final: a quarter of the particles, all, or eight times as many. Default: the preset's");
    command->add_option("--supersample", options->supersample, "Render this many times larger and average")->check(CLI::Range(1, 4));
    command->add_option("--format", options->format, "png (8 bit), png16, exr (half), exr32 (float). Default: by the ending of the file")->check(CLI::IsMember({"png", "png16", "exr", "exr32"}));
    command->footer("PNG is sRGB with straight alpha; EXR is linear with premultiplied alpha.\n"
                    "Examples:\n"
                    "  fumage-cli render chimney --frames 40 --output chimney.png\n"
                    "  fumage-cli render my.json --frames 0-63 --size 1024 --set look.opacity=8 --output out/smoke_####.exr");
    command->callback([options, &action] { action = [options] { return render(*options); }; });
}

} // namespace fumage::cli
