#include "core/export/engines/engine_files.h"

#include "core/system/path.h"
#include "core/export/engines/texture_packer.h"
#include "core/export/engines/template_text.h"
#include "core/image_io/png_chunks.h"

#include <algorithm>

namespace fumage {

namespace {

std::filesystem::path beside(const std::filesystem::path& picture, std::string_view ending)
{
    return std::filesystem::path(picture).replace_extension(pathFrom(ending));
}

/// Engines that import textures themselves read TGA, too; what is shown or read by other programs is PNG.
bool takes(Engine engine, ImageFormat format)
{
    const bool importsTextures =
        engine == Engine::Unity || engine == Engine::Unreal || engine == Engine::Godot || engine == Engine::Godot3;
    return format == ImageFormat::Tga ? importsTextures : !holdsFloats(format);
}

std::filesystem::path importOf(const std::filesystem::path& picture)
{
    return picture.parent_path() / pathFrom(picture.filename().string() + ".import");
}

/// The page with its pictures. The preset that these may carry stays in their files: a page shows pictures, and is made
/// again from its manifest to the byte.
std::string webPage(EngineSheet sheet)
{
    std::vector<std::vector<std::byte>> shown;
    for (EnginePicture& picture : sheet.pictures) {
        shown.push_back(withoutNotes(picture.bytes));
        picture.bytes = shown.back(); // stays where it is when the list grows
    }
    return sheetText("web_page", sheet);
}

} // namespace

std::vector<std::filesystem::path> engineFilesOf(
    Engine engine, const std::filesystem::path& picture, std::span<const std::filesystem::path> pictures)
{
    const auto withImports = [&](std::vector<std::filesystem::path> files) {
        std::transform(pictures.begin(), pictures.end(), std::back_inserter(files), importOf);
        return files;
    };
    switch (engine) {
    case Engine::Generic: break;
    case Engine::Unity: return {picture.parent_path() / "Editor" / pathFrom(picture.stem().string() + ".cs")};
    case Engine::Unreal: return {picture.parent_path() / pathFrom(picture.stem().string() + "_unreal.py")};
    case Engine::Godot: return withImports({beside(picture, ".tscn"), beside(picture, ".gdshader")});
    case Engine::Godot3: return withImports({beside(picture, ".tscn"), beside(picture, ".shader")});
    case Engine::Effekseer: return {beside(picture, ".efkproj")};
    case Engine::Pixi: return {beside(picture, ".atlas.json")};
    case Engine::Defold: return {beside(picture, ".tilesource")};
    case Engine::Web: return {beside(picture, ".html")};
    }
    return {};
}

std::vector<std::string> makeEngineFiles(Engine engine, const EngineSheet& sheet)
{
    const auto withImports = [&](std::string_view importTemplate, std::vector<std::string> texts) {
        for (const EnginePicture& picture : sheet.pictures) {
            texts.push_back(importText(importTemplate, picture));
        }
        return texts;
    };
    switch (engine) {
    case Engine::Generic: break;
    case Engine::Unity: return {sheetText("unity_editor", sheet)};
    case Engine::Unreal: return {sheetText("unreal_import", sheet)};
    case Engine::Godot:
        return withImports("godot_import", {sheetText("godot_scene", sheet), sheetText("godot_shader", sheet)});
    case Engine::Godot3:
        return withImports("godot3_import", {sheetText("godot3_scene", sheet), sheetText("godot3_shader", sheet)});
    case Engine::Effekseer: return {sheetText("effekseer_project", sheet)};
    case Engine::Pixi: return {texturePackerText(sheet)};
    case Engine::Defold: return {sheetText("defold_tilesource", sheet)};
    case Engine::Web: return {webPage(sheet)};
    }
    return {};
}

bool stacksLayers(Engine engine)
{
    return engine == Engine::Unity || engine == Engine::Godot || engine == Engine::Effekseer || engine == Engine::Web;
}

Status checkEngine(Engine engine, PassSet passes, ImageFormat format)
{
    if (engine == Engine::Generic) {
        return Done{};
    }
    if (!passes.has(Pass::Colour)) {
        return Error{ErrorCode::OutOfRange,
            makeMessage("%1 plays the colour, which is not among the passes", titleOf(engine)), {},
            makeMessage("Add colour to the passes")};
    }
    if (!takes(engine, format)) {
        return Error{ErrorCode::OutOfRange, makeMessage("what is written for %1 reads PNG", titleOf(engine)), {},
            makeMessage("Choose PNG")};
    }
    return Done{};
}

} // namespace fumage
