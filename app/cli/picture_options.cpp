#include "app/cli/picture_options.h"

#include "app/cli/progress.h"

#include "core/base/text.h"

#include <map>

namespace fumage::cli {

namespace {

const std::map<std::string, ImageFormat> kFormats{{"png", ImageFormat::Png8}, {"png16", ImageFormat::Png16}, {"exr", ImageFormat::ExrHalf}, {"exr32", ImageFormat::ExrFloat}};

} // namespace

bool parseTwo(const std::string& text, int most, int& first, int& second)
{
    const std::size_t cross = text.find('x');
    const std::optional<std::int64_t> before = parseInteger(text.substr(0, cross));
    const std::optional<std::int64_t> after = cross == std::string::npos ? before : parseInteger(text.substr(cross + 1));
    if (!before || !after || *before < 1 || *after < 1 || *before > most || *after > most) {
        return false;
    }
    first = static_cast<int>(*before);
    second = static_cast<int>(*after);
    return true;
}

void PictureOptions::addTo(CLI::App& command, const std::string& outputHelp, const std::string& sizeHelp)
{
    effect.addTo(command);
    command.add_option("-o,--output", output, outputHelp)->type_name("FILE");
    command.add_option("-f,--frames", frames, "Frames: 7, 0-119 or 0-119:2. Default: the whole timeline")->type_name("RANGE");
    command.add_option("--size", size, sizeHelp)->type_name("SIZE");
    command.add_option_function<std::string>(
        "--quality", [this](const std::string& name) { effect.assignments.push_back("output.quality=" + name); }, "draft, good or final: a quarter of the particles, all, or eight times as many. Default: the preset's");
    command.add_option("--supersample", supersample, "Render this many times larger and average")->check(CLI::Range(1, kMaxSupersample));
    command.add_flag("--fit", fit, "Move the camera so that all smoke of all frames is in the picture, and fills it");
    command.add_option("--format", format, "png (8 bit), png16, exr (half), exr32 (float). Default: by the ending of the file")->check(CLI::IsMember({"png", "png16", "exr", "exr32"}));
}

Result<PictureJob> PictureOptions::load() const
{
    Result<Effect> loaded = effect.load();
    if (!loaded) {
        return loaded.error();
    }
    PictureJob job;
    job.effect = loaded.value();
    if (!size.empty() && !parseTwo(size, kMaxOutputEdge, job.effect.output.width, job.effect.output.height)) {
        return Error{ErrorCode::OutOfRange, "the size " + inQuotes(size) + " is not understood", "--size", "Write 512 or 640x360, with edges from 1 to " + std::to_string(kMaxOutputEdge)};
    }
    if (supersample > 0) {
        job.effect.output.supersample = supersample;
    }
    job.plan.frames = {0, job.effect.timeline.length - 1, 1};
    if (!frames.empty()) {
        const Result<FrameRange> range = parseFrameRange(frames);
        if (!range) {
            return range.error();
        }
        job.plan.frames = range.value();
    }
    job.plan.fitCamera = fit;
    job.plan.format = format.empty() ? formatOf(output) : kFormats.at(format);
    job.plan.output = output.empty() ? std::filesystem::path(effect.preset).stem() : std::filesystem::path(output);
    return job;
}

Result<std::optional<Flipbook>> writePictures(const PictureJob& job)
{
    ProgressBar bar("Rendering");
    return runExport(
        job.effect, job.plan, [&](int done, int total) { bar.show(done, total); }, interruption());
}

} // namespace fumage::cli
