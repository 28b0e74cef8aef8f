#include "app/cli/check_layers.h"
#include "app/cli/command.h"
#include "app/cli/json_answer.h"
#include "app/cli/number_options.h"
#include "app/cli/picture_options.h"
#include "app/cli/progress.h"

#include "core/base/text.h"
#include "core/export/manifest/manifest_parts.h"
#include "core/export/sheets/sheet_metrics.h"
#include "core/system/path.h"

#include <iomanip>
#include <memory>
#include <sstream>

namespace fumage::cli {

namespace {

constexpr int kNameWidth = 18;
constexpr int kMaxLit = 64;
constexpr double kPercent = 100.0;

struct CheckArguments {
    PictureOptions picture;
    std::string grid;
    int lit = 2;
    bool asJson = false;
};

/// A number with some digits after the point, right in a column.
std::string column(double number, int digits, int width)
{
    std::ostringstream text;
    text << std::fixed << std::setprecision(digits) << std::setw(width) << number;
    return text.str();
}

std::string line(const std::string& name, const SheetScore& score)
{
    std::ostringstream text;
    text << std::left << std::setw(kNameWidth) << name << column(score.sixWay.decibels, 1, 8)
         << column(score.sixWay.worst, 1, 7) << column(score.sixWay.scale, 2, 7)
         << column(score.motion.crossFaded, 1, 12) << column(score.motion.rebuilt, 1, 9)
         << column(score.motion.scale, 4, 8) << column(score.edgeAlpha, 4, 12) << column(kPercent * score.clipped, 1, 9)
         << column(score.empty, 0, 7) << "\n";
    return text.str();
}

std::string headline()
{
    std::ostringstream text;
    text << std::left << std::setw(kNameWidth) << "preset"
         << "six-way  worst  scale   cross-fade  vectors   scale  edge alpha  clipped  empty\n"
         << std::setw(kNameWidth) << ""
         << "     dB     dB                  dB       dB                           %  cells\n";
    return text.str();
}

nlohmann::ordered_json jsonOf(const std::string& name, const SheetScore& score)
{
    return {{"preset", name},
        {"six_way",
            {{"decibels", score.sixWay.decibels}, {"worst_decibels", score.sixWay.worst},
                {"scale", score.sixWay.scale}}},
        {"motion",
            {{"cross_fade_decibels", score.motion.crossFaded}, {"decibels", score.motion.rebuilt},
                {"scale", score.motion.scale}, {"pictures", score.motion.between}}},
        {"edge_alpha", score.edgeAlpha}, {"clipped", score.clipped}, {"empty_cells", score.empty}};
}

Result<SheetScore> scoreOf(const CheckArguments& arguments, const NamedPreset& named)
{
    const Result<PictureJob> job = arguments.picture.jobFor(named, ExportKind::Flipbook);
    if (!job) {
        return job.error();
    }
    FlipbookOptions options;
    options.frames = job.value().plan.frames;
    if (Status status = gridFor(arguments.grid, "4x4", named, options.columns, options.rows); !status) {
        return status.error();
    }
    options.format = job.value().plan.format;
    ProgressBar bar("Measuring");
    return scoreSheet(job.value().scene, options, arguments.lit, bar.task());
}

/// Whether somebody asks for something that only presets have.
bool isOfPresets(const CheckArguments& arguments)
{
    const PictureOptions& picture = arguments.picture;
    const EffectOptions& effect = picture.effect;
    return !arguments.grid.empty() || !picture.frames.empty() || !picture.size.empty() || !picture.format.empty()
        || !effect.assignments.empty() || !effect.animations.empty() || !effect.markers.empty() || effect.layers
        || effect.muted;
}

/// Checks what is named by a manifest or a sheet of a layer, and leaves the presets.
Status checkLayered(CheckArguments& arguments, nlohmann::ordered_json& answer)
{
    std::vector<std::string> presets;
    for (const std::string& name : arguments.picture.effect.presets) {
        const bool isOfAPreset = isOfPresets(arguments) && !isManifest(pathFrom(name));
        const Result<std::optional<LayeredSheets>> layered =
            isOfAPreset ? std::optional<LayeredSheets>() : layeredSheetsNamed(name);
        if (!layered) {
            return layered.error();
        }
        if (!layered.value()) {
            presets.push_back(name);
            continue;
        }
        if (isOfPresets(arguments)) {
            return Error{ErrorCode::OutOfRange, makeMessage("the sheets of a manifest are checked as they are"), name,
                makeMessage("Leave out --grid, --frames, --size, --format, --set, --animate, --marker, --layers and "
                            "--mute, or name the preset")};
        }
        if (Status status = checkLayers(name, *layered.value(), arguments.asJson ? &answer : nullptr); !status) {
            return status;
        }
    }
    arguments.picture.effect.presets = presets;
    return Done{};
}

Status check(CheckArguments arguments)
{
    nlohmann::ordered_json answer = nlohmann::ordered_json::array();
    if (Status status = checkLayered(arguments, answer); !status) {
        return status;
    }
    bool first = true;
    const Status status = arguments.picture.effect.forEach([&](const NamedPreset& named) -> Status {
        const Result<SheetScore> score = scoreOf(arguments, named);
        if (!score) {
            return score.error();
        }
        if (arguments.asJson) {
            answer.push_back(jsonOf(named.name, score.value()));
            return Done{};
        }
        Status printed = print((first ? headline() : std::string()) + line(named.name, score.value()));
        first = false;
        return printed;
    });
    return status && arguments.asJson ? printJson(answer) : status;
}

} // namespace

void addCheckSheet(CLI::App& program, Action& action)
{
    auto arguments = std::make_shared<CheckArguments>();
    CLI::App* command =
        program.add_subcommand("check-sheet", "Measure how well a flipbook's light maps and motion vectors do");
    PictureOptions& picture = arguments->picture;
    picture.effect.addTo(*command);
    command
        ->add_option("-f,--frames", picture.frames,
            "Frames: 0-119 or 0-119:2. Default: the whole timeline, or those of the sheet that carries the preset")
        ->type_name("RANGE");
    command->add_option("--size", picture.size, "Size of a cell: 256 or 320x180. Default: the preset's")
        ->type_name("SIZE");
    command
        ->add_option(
            "--format", picture.format, "Of the pictures that are measured: png (8 bit), png16, exr. Default: png")
        ->check(CLI::IsMember({"png", "png16", "exr"}));
    command
        ->add_option("--grid", arguments->grid,
            "Columns and rows: 8 or 8x4. Default: 4x4, or of a sheet that carries its preset its own")
        ->type_name("GRID");
    addWhole(*command, "--lit", arguments->lit, 1, kMaxLit,
        "Cells in which light is measured, each under 20 lights. Default: 2");
    addJson(*command, arguments->asJson);
    command->footer("six-way: pictures that an engine makes of the two light maps, against the smoke under that light, "
                    "premultiplied, of 20 directions together and of the worst of\n"
                    "them; against a peak of 1, which is what a white surface gives back: maps go up to their scale. "
                    "vectors: the frame in the middle between two cells, rebuilt from\n"
                    "them, beside what a cross-fade makes of it; there must be frames between the cells.\n"
                    "Of sheets of layers, named by their manifest or by one of them, the files are read: how much of "
                    "each layer is seen, and how near all of them,\n"
                    "added up or drawn over one another, are to the sheet of all.\n"
                    "Examples:\n"
                    "  fumage-cli check-sheet campfire chimney --grid 4x4 --frames 0-31:2 --size 128\n"
                    "  fumage-cli check-sheet out/fire.manifest.json");
    command->callback([arguments, &action] { action = [arguments] { return check(*arguments); }; });
}

} // namespace fumage::cli
