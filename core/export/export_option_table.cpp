#include "core/export/export_option_table.h"

#include "core/base/joined.h"
#include "core/system/path.h"
#include "core/export/fit_camera.h"
#include "core/export/option_kinds.h"
#include "core/export/sheets/cell_frames.h"
#include "core/noise/texture.h"

#include <algorithm>
#include <array>

namespace fumage {

namespace {

using Texts = std::vector<std::string>;
using Plan = const ExportPlan&;
using Text = std::optional<std::string>;

constexpr char kBetween = ';';

// --- who asks for what ---

bool isFlipbook(Plan plan)
{
    return plan.kind == ExportKind::Flipbook;
}
bool isVideo(Plan plan)
{
    return plan.kind == ExportKind::Video;
}
bool isVolume(Plan plan)
{
    return plan.kind == ExportKind::Volumes;
}
bool isNoise(Plan plan)
{
    return plan.kind == ExportKind::NoiseTexture;
}
/// Whether its files are frames as pictures.
bool isOfFrames(Plan plan)
{
    return plan.kind == ExportKind::Sequence || plan.kind == ExportKind::Picture;
}
/// Whether there may be others than the colour.
bool hasPasses(Plan plan)
{
    return isFlipbook(plan) || isOfFrames(plan);
}
bool showsSmoke(Plan plan)
{
    return isPicture(plan.kind);
}
bool hasAxes(Plan plan)
{
    return !isPicture(plan.kind);
}
bool hasManifest(Plan plan)
{
    return canBeRecorded(plan.kind);
}

// --- options that are like no other ---

Status readEngine(std::string_view text, ExportPlan& plan)
{
    const std::optional<Engine> engine = enumeratorNamed<Engine, kEngines>(text);
    if (!engine) {
        return unknownName(text, namesOf<Engine, kEngines>());
    }
    plan.flipbook.engine = *engine;
    plan.passes = passesFor(*engine);
    plan.style = styleFor(*engine, plan.format);
    return Done{};
}

/// Shares have the colour, unless somebody asks for alpha, too.
Status readLayers(std::string_view text, ExportPlan& plan)
{
    const std::optional<LayerOutput> layers = enumeratorNamed<LayerOutput, kLayerOutputs>(text);
    if (!layers) {
        return unknownName(text, namesOf<LayerOutput, kLayerOutputs>());
    }
    plan.layers = *layers;
    if (isShare(*layers)) {
        plan.passes = {Pass::Colour};
    }
    return Done{};
}

Texts alphaNames()
{
    return {"straight", "premultiplied"};
}

Status readAlpha(std::string_view text, ExportPlan& plan)
{
    const Texts names = alphaNames();
    if (std::ranges::find(names, text) == names.end()) {
        return unknownName(text, names);
    }
    plan.style.premultiplied = text == names.back();
    return Done{};
}

Text textOfPacks(Plan plan)
{
    Texts texts;
    for (const PackedPicture& pack : plan.flipbook.packs) {
        texts.push_back(textOf(pack));
    }
    return joined(texts, std::string_view(&kBetween, 1));
}

Status readPack(std::string_view text, ExportPlan& plan)
{
    Result<PackedPicture> pack = parsePack(text);
    if (!pack) {
        return pack.error();
    }
    plan.flipbook.packs.push_back(std::move(pack).value());
    return Done{};
}

constexpr float kNone = 0.0F;
constexpr float kAll = 1.0F;

constexpr auto kOptions = std::to_array<ExportOption>({
    parsedOption<parseFrameRate>(
        {.key = "frame_rate",
            .flag = "--rate",
            .type = "RATE",
            .help = "Frames a second at which a video plays, such as 23.976 or 30000/1001; the "
                    "frames stay the same. Default: the timeline's",
            .applies = isVideo},
        [](auto& plan) -> auto& { return plan.video.rate; }),
    choiceOption<Repeat, kRepeats>(
        {.key = "repeat",
            .help = "How often a gif or apng plays: once, forever, or auto: for ever where its "
                    "frames close a loop",
            .initial = "auto",
            .applies = isVideo},
        [](auto& plan) -> auto& { return plan.video.repeat; }),
    wholeOption<1, kMaxSheetCells>(
        {.key = "columns", .setting = "columns", .applies = isFlipbook},
        [](auto& plan) -> auto& { return plan.flipbook.columns; }),
    wholeOption<1, kMaxSheetCells>(
        {.key = "rows", .setting = "rows", .applies = isFlipbook},
        [](auto& plan) -> auto& { return plan.flipbook.rows; }),
    {.key = "engine",
        .flag = "--for",
        .setting = "for",
        .type = "ENGINE",
        .help = "What is to play it: generic, unity, unreal, godot (4), godot3, effekseer, pixi (Phaser, too), defold, "
                "web. Chooses passes and their signs, and writes the files that it needs",
        .initial = "generic",
        .choices = namesOf<Engine, kEngines>,
        .applies = isFlipbook,
        .text = [](Plan plan) -> Text { return std::string(nameOf(plan.flipbook.engine)); },
        .read = readEngine},
    {.key = "layers",
        .flag = "--layers-as",
        .setting = "layers",
        .unsaid = "",
        .help = "How layers are written: together (default); or a sheet each: alone (lit and moved with the others, "
                "but nothing hides it), contribution (the others hide what they hide; they add up to the picture), "
                "stacked (drawn over one another in their order, premultiplied, they make the picture). The last two "
                "have colour and alpha",
        .choices = namesOf<LayerOutput, kLayerOutputs>,
        .applies = isFlipbook,
        .text = [](Plan plan) -> Text { return plan.layers ? Text(nameOf(*plan.layers)) : std::nullopt; },
        .read = readLayers},
    choiceOption<BlendSpace, kBlendSpaces>(
        {.key = "blending",
            .setting = "blending",
            .unsaid = "",
            .help = "Of contribution and stacked in PNG and TGA: add up where colours are blended as they are stored "
                    "(encoded: browsers, 2D engines, Godot's Compatibility renderer) or as light (linear: Unity, "
                    "Unreal, Godot's Forward+). Default: as --for blends; encoded without",
            .applies = isFlipbook},
        [](auto& plan) -> auto& { return plan.blending; }),
    parsedOption<parsePasses>(
        {.key = "passes",
            .setting = "passes",
            .type = "LIST",
            .help = "Pictures to write, with commas between: colour, alpha, density, six-way (light "
                    "maps), motion (vectors), normal, depth, emission, albedo, temperature, shadow, "
                    "all; layer-masks (EXR: a channel a layer, which add up to alpha); none beside "
                    "--pack. Default: colour, or what --for makes use of",
            .applies = hasPasses},
        [](auto& plan) -> auto& { return plan.passes; }),
    choiceOption<SixWayLayout, kSixWayLayouts>(
        {.key = "layout",
            .setting = "layout",
            .help = "Channels of the light maps: unity (right top back alpha, left bottom front emissive; the "
                    "default), embergen (top left right, bottom back front; of unreal), rlt-bbf, tlrb-fb",
            .applies = isFlipbook},
        [](auto& plan) -> auto& { return plan.style.layout; }),
    choiceOption<VectorSigns, kVectorSigns>(
        {.key = "vectors",
            .setting = "vectors",
            .help = "Signs of motion vectors: unity (red right, green up; the default) "
                    "or unreal (red left, green up)",
            .applies = isFlipbook},
        [](auto& plan) -> auto& { return plan.style.vectors; }),
    choiceOption<NormalGreen, kNormalGreens>(
        {.key = "normals",
            .setting = "normals",
            .unsaid = "opengl", // manifests of before there was a choice
            .help = "Green of normals: opengl (up; the default) or directx (down; of unreal)",
            .applies = isFlipbook},
        [](auto& plan) -> auto& { return plan.style.normals; }),
    {.key = "alpha",
        .setting = "alpha",
        .unsaid = "straight",
        .help = "Light maps, emission and albedo: straight, or premultiplied. Default: straight in PNG, premultiplied "
                "in EXR, as the colour always is",
        .choices = alphaNames,
        .applies = hasPasses,
        .text = [](Plan plan) -> Text { return alphaNames()[plan.style.premultiplied ? 1 : 0]; },
        .read = readAlpha},
    {.key = "packs",
        .flag = "--pack",
        .setting = "packs",
        .unsaid = "",
        .form = OptionForm::List,
        .type = "NAME=CHANNELS[@SCALE]",
        .help = "A picture with channels of your choice: masks=shadow,temperature,alpha makes smoke_masks.png. One to "
                "four, each a pass of one number (alpha, density, depth, temperature, shadow), a channel of another "
                "(colour.r, six-way-a.g, motion.r, normal.b), 0 or 1; at the end @1/2 to @1/16 for fewer pixels. Up "
                "to five times",
        .applies = isFlipbook,
        .text = textOfPacks,
        .read = readPack},
    flagOption(
        {.key = "trim",
            .help = "Leave out frames without smoke at the beginning and the end; not of a loop, which would no "
                    "longer close",
            .applies = isFlipbook},
        [](auto& plan) -> auto& { return plan.flipbook.trim; }),
    {.key = "retime",
        .setting = "retime",
        .unsaid = "",
        .form = OptionForm::Points,
        .type = "CURVE",
        .help = "Which frames the cells show: points of a curve from the share of the cells to the share of the "
                "frames, such as [[0,0],[0.3,0.6],[1,1]] for a quick beginning. Level is still, falling is backwards; "
                "the whole takes the same time",
        .applies = isFlipbook,
        .text = [](Plan plan) -> Text {
            return plan.flipbook.retime ? Text(textOfRetime(*plan.flipbook.retime)) : std::nullopt;
        },
        .read = [](std::string_view text, ExportPlan& plan) -> Status {
            Result<Curve> curve = parseRetime(text);
            if (!curve) {
                return curve.error();
            }
            plan.flipbook.retime = std::move(curve).value();
            return Done{};
        }},
    flagOption(
        {.key = "power_of_two",
            .help = "Make each side of a cell the nearest power of two, so that those of the sheet are. For 1, 2, 4 "
                    "to 64 columns and rows",
            .applies = isFlipbook},
        [](auto& plan) -> auto& { return plan.flipbook.powerOfTwo; }),
    flagOption(
        {.key = "fit_camera",
            .flag = "--fit",
            .help = "Move the camera so that all smoke of the frames asked for is in the picture, and fills it",
            .applies = showsSmoke},
        [](auto& plan) -> auto& { return plan.fitCamera; }),
    numberOption<kNone, kMaxOutlierPercent>(
        {.key = "ignore_outliers",
            .help = "Percent of the smoke that --fit may leave outside, 0 to 5, for larger frames: stray sparks and "
                    "puffs; what is left out is cut off at the border",
            .initial = "0",
            .applies = showsSmoke},
        [](auto& plan) -> auto& { return plan.outlierPercent; }),
    {.key = "carries_preset",
        .form = OptionForm::Flag,
        .applies = showsSmoke,
        .text = [](Plan plan) -> Text { return plan.project ? "true" : "false"; },
        .read = [](std::string_view text, ExportPlan& plan) -> Status {
            plan.project = text == "true" ? std::optional(Preset()) : std::nullopt;
            return Done{};
        }},
    {.key = "manifest",
        .form = OptionForm::Path,
        .applies = hasManifest,
        .text = [](Plan plan) -> Text {
            return plan.recording.manifest.empty() ? std::nullopt : Text(plan.recording.manifest.string());
        },
        .read = [](std::string_view text, ExportPlan& plan) -> Status {
            plan.recording.manifest = pathFrom(text);
            return Done{};
        }},
    flagOption(
        {.key = "skip_existing",
            .help = "Leave frames alone whose file is there as a whole, in this size, and made of this preset as far "
                    "as it says so",
            .applies = isOfFrames},
        [](auto& plan) -> auto& { return plan.recording.skipExisting; }),
    wholeOption<kMinVolumeCells, kMaxVolumeCells>(
        {.key = "cells",
            .help = "Voxels along the longest edge of the smoke of the whole timeline. Default: 128",
            .initial = "128",
            .applies = isVolume},
        [](auto& plan) -> auto& { return plan.volume.cells; }),
    numberOption<kMinVoxel, kMaxVoxel>(
        {.key = "voxel",
            .help = "Edge of a voxel in metres, in place of --cells; the timeline is not looked at then",
            .applies = isVolume},
        [](auto& plan) -> auto& { return plan.volume.voxel; }),
    choiceOption<DensityGrids, kDensityGrids>(
        {.key = "density",
            .help = "Grids of density: together (density, of all layers), or layers (one a layer in its place, such as "
                    "density_flames, which add up to it)",
            .initial = "together",
            .applies = isVolume},
        [](auto& plan) -> auto& { return plan.volume.density; }),
    choiceOption<UpAxis, kAllUpAxes.size()>(
        {.key = "up", .help = "Axis that points up: y or z", .applies = hasAxes},
        [](auto& plan) -> auto& { return plan.up; }),
    wholeOption<0, kMaxTextureSize>(
        {.key = "noise_size", .applies = isNoise}, [](auto& plan) -> auto& { return plan.noise.size; }),
    numberOption<kNone, kAll>(
        {.key = "noise_depth",
            .flag = "--depth",
            .help = "Where to cut the third axis, 0 to 1",
            .initial = "0",
            .applies = isNoise},
        [](auto& plan) -> auto& { return plan.noise.depth; }),
});

} // namespace

std::span<const ExportOption> exportOptions()
{
    return kOptions;
}

const ExportOption& exportOption(std::string_view key)
{
    return *std::ranges::find(kOptions, key, &ExportOption::key);
}

std::string flagOf(const ExportOption& option)
{
    std::string flag = option.flag.empty() ? "--" + std::string(option.key) : std::string(option.flag);
    std::ranges::replace(flag, '_', '-');
    return flag;
}

std::vector<std::string> splitList(std::string_view text)
{
    std::vector<std::string> parts;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(kBetween), text.size());
        parts.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return parts;
}

} // namespace fumage
