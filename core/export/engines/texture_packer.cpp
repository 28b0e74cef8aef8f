#include "core/export/engines/texture_packer.h"

#include <nlohmann/json.hpp>

namespace fumage {

std::string texturePackerText(const EngineSheet& sheet)
{
    using Json = nlohmann::ordered_json;
    const std::filesystem::path& picture = sheet.pictures.front().file;
    const std::string stem = picture.stem().string();
    const int width = sheet.scene.output.width;
    const int height = sheet.scene.output.height;
    Json frames = Json::object();
    Json names = Json::array();
    for (int cell = 0; cell < sheet.columns * sheet.rows; ++cell) {
        std::string number = std::to_string(cell);
        number.insert(0, 4 - number.size(), '0'); // kMaxSheetCells squared has four digits
        const std::string name = stem + "_" + number;
        frames[name] = {
            {"frame",
                {{"x", cell % sheet.columns * width}, {"y", cell / sheet.columns * height}, {"w", width},
                    {"h", height}}},
            {"rotated", false},
            {"trimmed", false},
            {"spriteSourceSize", {{"x", 0}, {"y", 0}, {"w", width}, {"h", height}}},
            {"sourceSize", {{"w", width}, {"h", height}}},
        };
        names.push_back(name);
    }
    Json json;
    json["frames"] = std::move(frames);
    json["animations"] = {{stem, std::move(names)}};
    json["meta"] = {
        {"app", "Fumage"},
        {"version", "1.0"},
        {"image", picture.filename().string()},
        {"format", "RGBA8888"},
        {"size", {{"w", sheet.columns * width}, {"h", sheet.rows * height}}},
        {"scale", "1"},
        {"cellsPerSecond", sheet.cellsPerSecond},
        {"loop", sheet.loops},
    };
    // A file's name need not be UTF-8, JSON is.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace fumage
