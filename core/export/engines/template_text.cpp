#include "core/export/engines/template_text.h"

#include "core/base/embedded_file.h"
#include "core/base/text.h"
#include "core/rendering/camera.h"

#include <algorithm>
#include <cassert>
#include <cctype>
#include <iterator>

#include <glm/geometric.hpp>
#include <kainjow/mustache.hpp>

namespace fumage {

extern const EmbeddedFile kEngineTemplates[];
extern const std::size_t kEngineTemplatesCount;

namespace {

using kainjow::mustache::data;
using kainjow::mustache::mustache;

/// Between double quotes and in comments of one line.
std::string escapedForCode(const std::string& text)
{
    std::string out;
    for (const char c : text) {
        if (static_cast<unsigned char>(c) < ' ') {
            continue;
        }
        if (c == '"' || c == '\\') {
            out += '\\';
        }
        out += c;
    }
    return out;
}

/// A name that programs take for one: letters, digits and underscores, with a letter first.
std::string identifier(const std::string& text)
{
    std::string out;
    std::transform(text.begin(), text.end(), std::back_inserter(out), [](unsigned char c) { return c < 128 && std::isalnum(c) != 0 ? static_cast<char>(c) : '_'; });
    return out.empty() || std::isalpha(static_cast<unsigned char>(out[0])) == 0 ? "sheet_" + out : out;
}

std::string base64(std::span<const std::byte> bytes)
{
    static constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    out.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t three = 0;
        for (std::size_t j = 0; j < 3; ++j) {
            three = three << 8U | (j < count ? std::to_integer<std::uint32_t>(bytes[i + j]) : 0U);
        }
        for (std::size_t j = 0; j < 4; ++j) {
            out += j <= count ? kDigits[three >> (18U - 6U * j) & 63U] : '=';
        }
    }
    return out;
}

std::string number(double value)
{
    return formatFloat(static_cast<float>(value));
}

/// What a picture is to an engine that imports it.
data pictureFacts(const EnginePicture& picture)
{
    data facts;
    facts.set("file", picture.file.filename().string());
    facts.set("srgb", picture.isSrgb);
    facts.set("linear", !picture.isSrgb);
    facts.set("exact", picture.isExact);
    return facts;
}

/// "a.r": the channel that a direction's light lies in.
void addChannels(const PassStyle& style, data& facts)
{
    const auto maps = channelsOf(style.layout);
    for (std::size_t map = 0; map < maps.size(); ++map) {
        for (std::size_t i = 0; i < 4; ++i) {
            facts.set("channel_" + std::string(nameOf(maps[map][i])), std::string(map == 0 ? "a." : "b.") + "rgba"[i]);
        }
    }
}

/// How large a cell is in the world, m, and where its middle lies, seen from the emitter.
void addPlace(const Effect& effect, data& facts)
{
    const View view = makeView(effect.camera, 0.0F, effect.output.width, effect.output.height);
    const glm::vec3 looked = effect.camera.mode == CameraMode::Orbit ? effect.camera.target : effect.emitter.position;
    const float depth = std::max(kNear, glm::dot(looked - view.eye, view.forward));
    const glm::vec3 middle = view.eye + depth * view.forward - effect.emitter.position;
    const float width = static_cast<float>(view.width) / view.focal * depth;
    const float height = static_cast<float>(view.height) / view.focal * depth;
    facts.set("metres_wide", number(width));
    facts.set("metres_high", number(height));
    facts.set("half_metres", number(0.5F * std::max(width, height)));
    facts.set("metres", number(std::max(width, height)));
    facts.set("middle_x", number(middle.x));
    facts.set("middle_y", number(middle.y));
    facts.set("middle_z", number(middle.z));
}

void addPictures(const EngineSheet& sheet, data& facts)
{
    data list = data::type::list;
    int index = 2; // resources of a Godot scene: the shader is the first
    for (const EnginePicture& picture : sheet.pictures) {
        data each = pictureFacts(picture);
        each.set("index", std::to_string(index));
        // Megabytes, made only for the template that asks for them.
        each.set("bytes", data(kainjow::mustache::lambda([bytes = picture.bytes](const std::string&) { return base64(bytes); })));
        if (picture.pass) {
            const std::string key = fileNameOf(*picture.pass);
            each.set(key, true);
            facts.set("has_" + key, true);
            facts.set("index_" + key, std::to_string(index));
            facts.set("file_" + key, picture.file.filename().string());
        }
        list << each;
        ++index;
    }
    facts.set("pictures", list);
}

data factsOf(const EngineSheet& sheet)
{
    const std::string stem = sheet.pictures.front().file.stem().string();
    const Output& cell = sheet.effect.output;
    const int cells = sheet.columns * sheet.rows;
    data facts;
    facts.set("name", stem);
    facts.set("id", identifier(stem));
    facts.set("columns", std::to_string(sheet.columns));
    facts.set("rows", std::to_string(sheet.rows));
    facts.set("cells", std::to_string(cells));
    facts.set("last_cell", std::to_string(cells - 1));
    facts.set("cell_width", std::to_string(cell.width));
    facts.set("cell_height", std::to_string(cell.height));
    facts.set("largest_edge", std::to_string(std::max(cell.width * sheet.columns, cell.height * sheet.rows)));
    facts.set("cells_per_second", number(sheet.cellsPerSecond));
    facts.set("whole_cells_per_second", std::to_string(std::max(1, static_cast<int>(sheet.cellsPerSecond + 0.5)))); // Defold takes no other
    facts.set("seconds", number(cells / sheet.cellsPerSecond));
    // Effekseer counts in sixtieths of a second.
    const int sixtieths = std::max(1, static_cast<int>(60.0 / sheet.cellsPerSecond + 0.5));
    facts.set("sixtieths", std::to_string(sixtieths));
    facts.set("life_sixtieths", std::to_string(sixtieths * cells));
    facts.set("loop", sheet.loops);
    facts.set("once", !sheet.loops);
    facts.set("motion_scale", number(sheet.scales.motion));
    facts.set("motion_right", sheet.style.vectors == VectorSigns::Unity ? "1.0" : "-1.0");
    facts.set("signs", std::string(nameOf(sheet.style.vectors)));
    facts.set("layout", std::string(nameOf(sheet.style.layout)));
    facts.set("light_scale", number(sheet.scales.light));
    addPictures(sheet, facts);
    const bool lit = facts.get("has_sixway_a") != nullptr && facts.get("has_sixway_b") != nullptr;
    facts.set("six_way", lit);
    facts.set("unlit", !lit);
    facts.set("resources", std::to_string(sheet.pictures.size() + 5)); // shader, material, quad and process, and the scene itself
    addChannels(sheet.style, facts);
    addPlace(sheet.effect, facts);
    return facts;
}

std::string filled(std::string_view name, TextKind kind, const data& facts)
{
    const EmbeddedFile* const found = findEmbedded({kEngineTemplates, kEngineTemplatesCount}, name);
    assert(found != nullptr);
    mustache text{std::string(found->contents)};
    if (kind == TextKind::Code) {
        text.set_custom_escape(escapedForCode);
    }
    assert(text.is_valid());
    return text.render(facts);
}

} // namespace

std::string sheetText(std::string_view name, TextKind kind, const EngineSheet& sheet)
{
    return filled(name, kind, factsOf(sheet));
}

std::string importText(std::string_view name, const EnginePicture& picture)
{
    return filled(name, TextKind::Code, pictureFacts(picture));
}

} // namespace fumage
