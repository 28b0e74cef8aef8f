#include "core/export/sheets/flipbook_files.h"
#include "core/export/sheets/flipbook_description.h"

#include "core/base/text.h"
#include "core/export/layer_masks.h"
#include "core/export/sheets/cell_frames.h"
#include "core/export/sheets/sheet_events.h"

#include <nlohmann/json.hpp>

namespace fumage {

namespace {

using Json = nlohmann::ordered_json;

Json sixWayChannels(SixWayLayout layout, std::size_t map)
{
    Json names = Json::array();
    const auto maps = channelsOf(layout);
    for (const SixWayChannel channel : maps[map]) {
        names.push_back(std::string(nameOf(channel)));
    }
    return names;
}

/// What the channels of a pass are.
Json channelsOfPass(Pass pass, const PassStyle& style)
{
    switch (pass) {
    case Pass::SixWayA: return sixWayChannels(style.layout, 0);
    case Pass::SixWayB: return sixWayChannels(style.layout, 1);
    case Pass::Motion: return {style.vectors == VectorSigns::Unity ? "right" : "left", "up", "nothing"};
    case Pass::Normal: return {"right", style.normals == NormalGreen::OpenGl ? "up" : "down", "to the viewer"};
    case Pass::Alpha:
    case Pass::Density:
    case Pass::Depth:
    case Pass::Temperature:
    case Pass::Shadow: return {std::string(passName(pass))};
    case Pass::Colour:
    case Pass::LayerMasks: // which layer each is of, describeMasks() says
    case Pass::Emission:
    case Pass::Albedo: break;
    }
    return {"red", "green", "blue", "alpha"};
}

/// Whether numbers are multiplied by alpha, and how those that may be negative are stored.
/// @param isStraight the colour is
void describeEncoding(Pass pass, const PassStyle& style, bool shown, bool isStraight, Json& json)
{
    const bool hasAlpha =
        pass == Pass::SixWayA || pass == Pass::SixWayB || pass == Pass::Emission || pass == Pass::Albedo;
    if (pass == Pass::Colour) {
        json["alpha"] = isStraight ? "straight" : "premultiplied";
    } else if (hasAlpha) {
        json["alpha"] = style.premultiplied ? "premultiplied" : "straight";
    }
    if (shown && (pass == Pass::Motion || pass == Pass::Normal)) {
        json["centre"] = 0.5;
        json["encoding"] = "number = 2 * stored - 1";
    }
}

/// 0.3 and not 0.30000001192092896.
Json shortest(float number)
{
    return Json::parse(formatFloat(number));
}

/// How the number that says how much smoke glows becomes a colour.
Json describeGlow(const PassScales& scales)
{
    Json glow;
    glow["encoding"] = "linear colour = gradient(stored) * scale";
    glow["scale"] = shortest(scales.glow);
    glow["gradient"] = Json::array();
    for (int k = 0; k < kGlowKeys; ++k) {
        const glm::vec3& colour = scales.ramp.colours[static_cast<std::size_t>(k)];
        glow["gradient"].push_back({{"at", shortest(glowKeyPosition(k))},
            {"colour", {shortest(colour.r), shortest(colour.g), shortest(colour.b)}}});
    }
    return glow;
}

bool hasEmissive(const PassStyle& style)
{
    return channelsOf(style.layout)[1][3] == SixWayChannel::Emissive;
}

/// How numbers become what they mean: value = number * scale + offset.
void describeScale(Pass pass, const PassScales& scales, const PassStyle& style, Json& json)
{
    switch (pass) {
    case Pass::SixWayA:
    case Pass::SixWayB:
        json["layout"] = std::string(nameOf(style.layout));
        json["scale"] = scales.light;
        if (pass == Pass::SixWayB && hasEmissive(style)) {
            json["emissive"] = describeGlow(scales);
        }
        break;
    case Pass::Motion:
        json["signs"] = std::string(nameOf(style.vectors));
        json["scale"] = scales.motion;
        json["unit"] = "share of a cell, from one cell to the next";
        break;
    case Pass::Normal: json["green"] = std::string(nameOf(style.normals)); break;
    case Pass::Emission: json["scale"] = scales.emission; break;
    case Pass::Temperature:
        json["scale"] = scales.temperature;
        json["unit"] = "share of the heat at birth; 0 where nothing glows";
        break;
    case Pass::Density:
        json["scale"] = scales.density;
        json["unit"] = "optical depth: alpha = 1 - exp(-depth)";
        break;
    case Pass::Depth:
        json["scale"] = scales.farthest - scales.nearest;
        json["offset"] = scales.nearest;
        json["unit"] = "m";
        break;
    default: break;
    }
}

/// A picture that somebody has packed: where each channel is from, what it holds, and how it is read.
Json describePacked(const PackedPicture& pack, const std::string& file, const Scene& scene,
    const FlipbookOptions& options, const PassScales& scales)
{
    const bool shown = !holdsFloats(options.format);
    Json json;
    json["packed"] = pack.name;
    json["file"] = file;
    json["colour"] = isSrgb(pack, options.format) ? "sRGB" : "linear";
    json["cell_width"] = scene.output.width / pack.divisor;
    json["cell_height"] = scene.output.height / pack.divisor;
    json["channels"] = Json::array();
    for (const PackedChannel& channel : pack.channels) {
        Json each;
        each["from"] = textOf(channel);
        if (channel.pass) {
            const Json names = channelsOfPass(*channel.pass, options.style);
            each["holds"] = names[static_cast<std::size_t>(channel.channel)];
            each["linear"] = !shown || *channel.pass != Pass::Colour || channel.channel == 3;
            describeEncoding(*channel.pass, options.style, shown, shown && !isPremultiplied(options), each);
            if (each["holds"] == "emissive") {
                each["emissive"] = describeGlow(scales);
            } else {
                describeScale(*channel.pass, scales, options.style, each);
            }
        }
        json["channels"].push_back(each);
    }
    return json;
}

/// Which channel of an EXR has which layer.
Json describeMasks(const Scene& scene, const std::string& file)
{
    Json json;
    json["pass"] = std::string(passName(Pass::LayerMasks));
    json["file"] = file;
    json["colour"] = "linear";
    json["channels"] = Json::array();
    json["layers"] = Json::array();
    for (const LayerMask& mask : masksOf(scene)) {
        json["channels"].push_back(channelOf(mask));
        json["layers"].push_back(mask.layer);
    }
    json["unit"] = "share of alpha: all of them add up to it";
    return json;
}

Json describePicture(Pass pass, const std::string& file, const FlipbookOptions& options, const PassScales& scales)
{
    const bool shown = !holdsFloats(options.format);
    Json json;
    json["pass"] = std::string(passName(pass));
    json["file"] = file;
    json["colour"] = pass == Pass::Colour && shown ? "sRGB" : "linear";
    json["channels"] = channelsOfPass(pass, options.style);
    describeEncoding(pass, options.style, shown, shown && !isPremultiplied(options), json);
    describeScale(pass, scales, options.style, json);
    return json;
}

/// Which layer it is of, and how the sheets of all layers become one picture.
Json describeLayer(const FlipbookOptions& options)
{
    Json layer;
    layer["name"] = options.layer->name;
    layer["number"] = options.layer->number;
    layer["of"] = options.layer->count;
    layer["as"] = std::string(nameOf(*options.layers));
    if (isOfShares(options)) {
        layer["space"] = std::string(nameOf(blendSpaceOf(options)));
    }
    switch (*options.layers) {
    case LayerOutput::Together: break;
    case LayerOutput::Alone: layer["blending"] = "over what is behind; the layers do not hide one another"; break;
    case LayerOutput::Contribution:
        layer["blending"] = "add colours and alphas of all layers, then put the sum over what is behind: "
                            "colour + (1 - alpha) * behind";
        break;
    case LayerOutput::Stacked:
        layer["blending"] = std::string("one layer over the other in the order of their numbers: ")
            + (blendsStraight(options.engine) ? "alpha * colour" : "colour") + " + (1 - alpha) * behind";
        break;
    }
    return layer;
}

/// Where frames are left out, or cells go through them otherwise than in even steps.
void describeTime(const FlipbookOptions& options, Json& json)
{
    if (options.untrimmed) {
        json["trimmed"] = {{"first_frame", options.frames.first}, {"last_frame", options.frames.last},
            {"from", options.untrimmed->first}, {"to", options.untrimmed->last}};
    }
    if (options.retime) {
        json["retime"] = Json::array();
        for (const CurvePoint& point : options.retime->points()) {
            json["retime"].push_back({shortest(point.x), shortest(point.y)});
        }
        json["frames"] = framesOfCells(options);
    }
}

/// Moments with names that who plays it passes.
void describeEvents(const Scene& scene, const FlipbookOptions& options, Json& json)
{
    for (const SheetEvent& event : sheetEvents(scene, options)) {
        json["events"].push_back({{"name", event.name}, {"seconds", event.seconds}, {"cell", event.cell}});
    }
}

} // namespace

std::string describeFlipbook(
    const Scene& scene, const FlipbookOptions& options, const Flipbook& flipbook, const PassScales& scales)
{
    const bool shown = !holdsFloats(options.format);
    Json json;
    json["format"] = "fumage-flipbook";
    json["version"] = 1;
    json["picture"] = flipbook.picture.filename().string();
    json["columns"] = options.columns;
    json["rows"] = options.rows;
    json["cell_width"] = scene.output.width;
    json["cell_height"] = scene.output.height;
    json["order"] = "left to right, then top to bottom";
    json["cells_per_second"] = flipbook.cellsPerSecond;
    json["seconds"] = options.columns * options.rows / flipbook.cellsPerSecond;
    json["loop"] = flipbook.loops;
    describeTime(options, json);
    describeEvents(scene, options, json);
    if (options.layer) {
        json["layer"] = describeLayer(options);
    }
    json["for"] = std::string(nameOf(options.engine));
    const bool coloured = options.passes.has(Pass::Colour);
    const bool isStraight = coloured ? shown && !isPremultiplied(options) : !options.style.premultiplied;
    json["alpha"] = isStraight ? "straight" : "premultiplied";
    json["colour"] = coloured && shown ? "sRGB" : "linear";
    json["pictures"] = Json::array();
    const std::vector<std::filesystem::path> files = picturesOf(options);
    std::size_t i = 0;
    for (const Pass pass : kAllPasses) {
        if (!options.passes.has(pass)) {
            continue;
        }
        const std::string file = files[i++].filename().string();
        json["pictures"].push_back(
            pass == Pass::LayerMasks ? describeMasks(scene, file) : describePicture(pass, file, options, scales));
    }
    for (const PackedPicture& pack : options.packs) {
        json["pictures"].push_back(describePacked(pack, files[i++].filename().string(), scene, options, scales));
    }
    return json.dump(2) + "\n";
}

} // namespace fumage
