#include "core/scene/layer_assignment.h"

#include "core/base/text.h"
#include "core/effect/assignment.h"

#include <algorithm>

namespace fumage {

namespace {

/// The one layer whose name it is, whether A to Z are small or not; none where nobody is called so.
/// @error UnknownName where several are
Result<std::optional<std::size_t>> layerLike(const Scene& scene, std::string_view name)
{
    const std::string small = inSmallLetters(name);
    std::optional<std::size_t> like;
    std::size_t count = 0;
    std::string names;
    for (std::size_t i = 0; i < scene.layers.size(); ++i) {
        if (const std::string& own = scene.layers[i].name; inSmallLetters(own) == small) {
            like = i;
            names += (count++ == 0 ? "" : ", ") + inQuotes(own) + " (" + std::to_string(i + 1) + ")";
        }
    }
    if (count > 1) {
        return Error{ErrorCode::UnknownName, makeMessage("there is no one layer %1, but %2", inQuotes(name), names), {},
            makeMessage("Write the name as it is, or where they share it the number")};
    }
    return like;
}

} // namespace

Result<std::size_t> layerNamed(const Scene& scene, std::string_view name)
{
    if (const std::optional<std::size_t> layer = findLayer(scene, name)) {
        return *layer;
    }
    const Result<std::optional<std::size_t>> like = layerLike(scene, name);
    if (!like) {
        return like.error();
    }
    if (like.value()) {
        return *like.value();
    }
    std::string names;
    for (const Layer& layer : scene.layers) {
        names += (names.empty() ? "" : ", ") + (layer.name.empty() ? std::string("?") : layer.name);
    }
    return Error{ErrorCode::UnknownName, makeMessage("there is no one layer %1", inQuotes(name)), {},
        makeMessage("Name one of %1, or give its number from 1 to %2", names, scene.layers.size())};
}

namespace {

/// Calls visit(layer) for the layers in a list of names.
template <class Visit>
Status forNamed(const Scene& scene, std::string_view names, const Visit& visit)
{
    if (trimmed(names).empty()) {
        return Error{ErrorCode::UnknownName, makeMessage("no layer is named"), {},
            makeMessage("Name layers, or leave the option out")};
    }
    while (true) {
        const std::size_t comma = names.find(',');
        const Result<std::size_t> layer = layerNamed(scene, trimmed(names.substr(0, comma)));
        if (!layer) {
            return layer.error();
        }
        visit(layer.value());
        if (comma == std::string_view::npos) {
            return Done{};
        }
        names.remove_prefix(comma + 1);
    }
}

/// The name of a layer as the scene has it; one that no layer has as it is.
/// @error UnknownName where several are called so but for their capital letters
Result<std::string> nameInScene(const Scene& scene, std::string_view name)
{
    const bool isThere = std::ranges::any_of(scene.layers, [&](const Layer& each) { return each.name == name; });
    if (name.empty() || isThere) {
        return std::string(name);
    }
    const Result<std::optional<std::size_t>> like = layerLike(scene, name);
    if (!like) {
        return like.error();
    }
    return like.value() ? scene.layers[*like.value()].name : std::string(name);
}

/// Lets a layer be born on another. Nothing is changed where that cannot be.
Result<bool> setParent(Scene& scene, std::size_t layer, std::string_view name)
{
    Result<std::string> parent = nameInScene(scene, trimmed(name));
    if (!parent) {
        return parent.error();
    }
    Scene changed = scene;
    changed.layers[layer].from = std::move(parent).value();
    if (Status status = checkParent(changed, layer); !status) {
        return status.error();
    }
    scene = std::move(changed);
    return false;
}

} // namespace

Result<LayerAssignment> layerAssignment(const Scene& scene, std::string_view text)
{
    const std::string_view target = text.substr(0, text.find('='));
    const std::size_t slash = target.rfind('/');
    if (slash == std::string_view::npos) {
        return LayerAssignment{0, text};
    }
    const Result<std::size_t> layer = layerNamed(scene, trimmed(target.substr(0, slash)));
    return layer ? Result<LayerAssignment>(LayerAssignment{layer.value(), text.substr(slash + 1)}) : layer.error();
}

Result<bool> applyToScene(Scene& scene, std::string_view text)
{
    const Result<LayerAssignment> part = layerAssignment(scene, text);
    if (!part) {
        return part.error();
    }
    constexpr std::string_view kFrom = "from=";
    if (part.value().assignment.substr(0, kFrom.size()) == kFrom) {
        return setParent(scene, part.value().layer, part.value().assignment.substr(kFrom.size()));
    }
    Effect effect = scene.effect(part.value().layer);
    Result<bool> clamped = applyAssignment(effect, part.value().assignment);
    if (clamped) {
        scene.assign(part.value().layer, effect);
    }
    return clamped;
}

Status showOnly(Scene& scene, std::string_view names)
{
    std::vector<bool> shown(scene.layers.size(), false);
    if (Status status = forNamed(scene, names, [&](std::size_t layer) { shown[layer] = true; }); !status) {
        return status;
    }
    for (std::size_t layer = 0; layer < shown.size(); ++layer) {
        scene.layers[layer].visible = shown[layer];
    }
    return Done{};
}

Status mute(Scene& scene, std::string_view names)
{
    std::vector<std::size_t> muted;
    if (Status status = forNamed(scene, names, [&](std::size_t layer) { muted.push_back(layer); }); !status) {
        return status;
    }
    for (const std::size_t layer : muted) {
        scene.layers[layer].visible = false;
    }
    return Done{};
}

} // namespace fumage
