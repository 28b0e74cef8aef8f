#include "ui/document/unknown_places.h"

#include "core/effect/parameter_table.h"
#include "core/preset/preset_keys.h"

#include <algorithm>
#include <limits>

namespace fumage::ui {

namespace {

std::size_t distance(std::size_t one, std::size_t other)
{
    return one > other ? one - other : other - one;
}

/// The nearest layer of a name and seed.
std::optional<std::size_t> findLayer(
    const std::vector<Layer>& layers, const std::string& name, std::uint32_t seed, std::size_t from)
{
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const bool isIt = layers[i].name == name && layers[i].emitter.seed == seed;
        if (isIt && (!found || distance(i, from) < distance(*found, from))) {
            found = i;
        }
    }
    return found;
}

} // namespace

bool isOfLayer(const UnknownMember& member)
{
    return member.group == kLayer || (member.group == kAnimation && !member.isOfScene)
        || groupScope(member.group) == Scope::Layer;
}

std::vector<UnknownMember> unknownOf(const Preset& preset, const std::vector<std::size_t>& layers)
{
    std::vector<UnknownMember> said;
    for (const UnknownMember& member : preset.unknown) {
        const auto place = std::find(layers.begin(), layers.end(), member.layer);
        if (isOfLayer(member) && place != layers.end()) {
            said.push_back(member);
            said.back().layer = static_cast<std::size_t>(place - layers.begin());
        }
    }
    return said;
}

void UnknownPlaces::reset(const Preset& preset)
{
    m_marks.clear();
    for (const UnknownMember& member : preset.unknown) {
        addMark(preset, member);
    }
}

void UnknownPlaces::add(Preset& preset, const std::vector<UnknownMember>& more)
{
    for (const UnknownMember& member : more) {
        // A layer that was cut and comes back has found its own already; tracks have no key, and are what they say.
        const bool isSaid = std::any_of(preset.unknown.begin(), preset.unknown.end(), [&](const UnknownMember& said) {
            return said.group == member.group && said.key == member.key && said.layer == member.layer
                && said.isOfScene == member.isOfScene && (!said.key.empty() || said.json == member.json);
        });
        if (!isSaid) {
            preset.unknown.push_back(member);
            addMark(preset, member);
        }
    }
}

void UnknownPlaces::addMark(const Preset& preset, const UnknownMember& member)
{
    std::optional<Mark> mark;
    if (isOfLayer(member) && member.layer < preset.scene.layers.size()) {
        const Layer& layer = preset.scene.layers[member.layer];
        mark = Mark{layer.name, layer.emitter.seed, member.layer};
    }
    m_marks.push_back(std::move(mark));
}

void UnknownPlaces::follow(Preset& preset, std::size_t before)
{
    const std::vector<Layer>& layers = preset.scene.layers;
    for (std::size_t i = 0; i < m_marks.size() && i < preset.unknown.size(); ++i) {
        if (!m_marks[i]) {
            continue;
        }
        Mark& mark = *m_marks[i];
        std::optional<std::size_t> place = findLayer(layers, mark.name, mark.seed, mark.place);
        if (!place && mark.isThere && layers.size() == before) {
            place = mark.place; // it was renamed, or seeded anew
        }
        mark.isThere = place.has_value();
        preset.unknown[i].layer = place.value_or(std::numeric_limits<std::size_t>::max());
        if (place) {
            mark = {layers[*place].name, layers[*place].emitter.seed, *place};
        }
    }
}

} // namespace fumage::ui
