#include "ui/document/unknown_places.h"

#include "core/effect/parameter_table.h"
#include "core/preset/preset_keys.h"

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

void UnknownPlaces::reset(const Preset& preset)
{
    m_marks.clear();
    for (const UnknownMember& member : preset.unknown) {
        std::optional<Mark> mark;
        if (isOfLayer(member) && member.layer < preset.scene.layers.size()) {
            const Layer& layer = preset.scene.layers[member.layer];
            mark = Mark{layer.name, layer.emitter.seed, member.layer};
        }
        m_marks.push_back(std::move(mark));
    }
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
