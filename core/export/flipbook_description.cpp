#include "core/export/flipbook_description.h"

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
    case Pass::Normal: return {"right", "up", "to the viewer"};
    case Pass::Alpha:
    case Pass::Depth:
    case Pass::Temperature:
    case Pass::Shadow: return {std::string(passName(pass))};
    case Pass::Colour:
    case Pass::Emission:
    case Pass::Albedo: break;
    }
    return {"red", "green", "blue", "alpha"};
}

/// How numbers become what they mean: value = number * scale + offset.
void describeScale(Pass pass, const PassScales& scales, const PassStyle& style, Json& json)
{
    switch (pass) {
    case Pass::SixWayA:
    case Pass::SixWayB:
        json["layout"] = std::string(nameOf(style.layout));
        json["scale"] = scales.light;
        break;
    case Pass::Motion:
        json["signs"] = std::string(nameOf(style.vectors));
        json["scale"] = scales.motion;
        json["unit"] = "share of a cell, from one cell to the next";
        break;
    case Pass::Emission: json["scale"] = scales.emission; break;
    case Pass::Depth:
        json["scale"] = scales.farthest - scales.nearest;
        json["offset"] = scales.nearest;
        json["unit"] = "m";
        break;
    default: break;
    }
}

Json describePicture(Pass pass, const std::string& file, const FlipbookOptions& options, const PassScales& scales)
{
    const bool shown = !holdsFloats(options.format);
    Json json;
    json["pass"] = std::string(passName(pass));
    json["file"] = file;
    json["colour"] = pass == Pass::Colour && shown ? "sRGB" : "linear";
    json["channels"] = channelsOfPass(pass, options.style);
    const bool hasAlpha = pass == Pass::SixWayA || pass == Pass::SixWayB || pass == Pass::Emission || pass == Pass::Albedo;
    if (pass == Pass::Colour) {
        json["alpha"] = shown ? "straight" : "premultiplied";
    } else if (hasAlpha) {
        json["alpha"] = options.style.premultiplied ? "premultiplied" : "straight";
    }
    if (shown && (pass == Pass::Motion || pass == Pass::Normal)) {
        json["centre"] = 0.5;
        json["encoding"] = "number = 2 * stored - 1";
    }
    describeScale(pass, scales, options.style, json);
    return json;
}

} // namespace

std::string describeFlipbook(const Effect& effect, const FlipbookOptions& options, const Flipbook& flipbook, const PassScales& scales)
{
    const bool shown = !holdsFloats(options.format);
    Json json;
    json["format"] = "fumage-flipbook";
    json["version"] = 1;
    json["picture"] = flipbook.picture.filename().string();
    json["columns"] = options.columns;
    json["rows"] = options.rows;
    json["cell_width"] = effect.output.width;
    json["cell_height"] = effect.output.height;
    json["order"] = "left to right, then top to bottom";
    json["cells_per_second"] = flipbook.cellsPerSecond;
    json["seconds"] = options.columns * options.rows / flipbook.cellsPerSecond;
    json["loop"] = effect.timeline.loop;
    json["for"] = std::string(nameOf(options.engine));
    const bool coloured = options.passes.has(Pass::Colour);
    json["alpha"] = (coloured ? shown : !options.style.premultiplied) ? "straight" : "premultiplied";
    json["colour"] = coloured && shown ? "sRGB" : "linear";
    json["pictures"] = Json::array();
    const std::vector<std::filesystem::path> files = picturesOf(options);
    std::size_t i = 0;
    for (const Pass pass : kAllPasses) {
        if (options.passes.has(pass)) {
            json["pictures"].push_back(describePicture(pass, files[i++].filename().string(), options, scales));
        }
    }
    return json.dump(2) + "\n";
}

} // namespace fumage
