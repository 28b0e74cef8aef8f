#include "core/preset/migration.h"

#include "core/effect/parameter_table.h"
#include "core/preset/preset_keys.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <utility>

namespace fumage {

namespace {

/// An object that holds nothing yet and stands where another node does.
JsonNode emptyAt(const JsonNode& place, JsonNode::Type type = JsonNode::Type::Object)
{
    JsonNode node;
    node.type = type;
    node.begin = place.begin;
    node.end = place.end;
    return node;
}

/// Adds a member to an object that has none of its key.
void append(JsonNode& object, std::string_view key, JsonNode value)
{
    object.keys.emplace_back(key);
    object.items.push_back(std::move(value));
}

/// Adds a member to an object; where there is one of its key, that one stays.
void put(JsonNode& object, std::string_view key, JsonNode value)
{
    if (object.find(key) == nullptr) {
        append(object, key, std::move(value));
    }
}

/// The member of an object with a key, which is made where there is none.
JsonNode& memberOf(JsonNode& object, std::string_view key)
{
    put(object, key, emptyAt(object));
    const auto at = std::find(object.keys.begin(), object.keys.end(), key) - object.keys.begin();
    return object.items[static_cast<std::size_t>(at)];
}

/// A preset of version 2 while it is made of one of version 1.
struct Halves {
    JsonNode scene;
    JsonNode layer;

    JsonNode& groupOf(std::string_view group, Scope scope)
    {
        return memberOf(scope == Scope::Scene ? scene : layer, group);
    }
    void put(const Parameter& parameter, const JsonNode& value)
    {
        fumage::put(groupOf(parameter.group(), parameter.scope), parameter.name(), value);
    }
};

/// What version 2 has twice: once for air, once for what no air carries.
constexpr std::array kAlsoOfAir{
    std::pair{std::string_view("motion.buoyancy"), std::string_view("air.buoyancy")},
    std::pair{std::string_view("motion.cooling"), std::string_view("air.cooling")},
    std::pair{std::string_view("motion.drag"), std::string_view("air.drag")},
};

void moveMember(const std::string& group, Scope scope, const std::string& name, const JsonNode& value, Halves& to)
{
    const std::string key = group + "." + name;
    const Parameter* known = findParameter(key);
    const Parameter* parameter = known != nullptr ? known : findFormerParameter(key);
    if (parameter == nullptr) {
        append(to.groupOf(group, scope), name, value); // keys of one object differ
        return;
    }
    to.put(*parameter, value);
    for (const auto& [from, also] : kAlsoOfAir) {
        if (from == key) {
            to.put(*findParameter(also), value);
        }
    }
}

/// Version 1 has all groups side by side. Version 2 has those of the scene in "scene", and those of each layer in
/// "layers"; Light was split into Light and Glow, Air into Air and Source, Motion into Motion and Wind.
void fromVersion1(JsonNode& root)
{
    JsonNode rest = emptyAt(root);
    Halves halves{emptyAt(root), emptyAt(root)};
    for (std::size_t i = 0; i < root.items.size(); ++i) {
        const std::string& key = root.keys[i];
        const JsonNode& node = root.items[i];
        const std::optional<Scope> scope = groupScope(key);
        if (!scope && key != kScene && key != kLayers) {
            append(rest, key, node);
        } else if (!scope) {
            continue; // meant nothing in version 1
        } else if (node.type != JsonNode::Type::Object) {
            put(*scope == Scope::Scene ? halves.scene : halves.layer, key, node);
        } else {
            for (std::size_t member = 0; member < node.items.size(); ++member) {
                moveMember(key, *scope, node.keys[member], node.items[member], halves);
            }
        }
    }
    JsonNode layers = emptyAt(root, JsonNode::Type::Array);
    layers.items.push_back(std::move(halves.layer));
    JsonNode out = emptyAt(root);
    append(out, kScene, std::move(halves.scene));
    append(out, kLayers, std::move(layers));
    std::move(rest.keys.begin(), rest.keys.end(), std::back_inserter(out.keys));
    std::move(rest.items.begin(), rest.items.end(), std::back_inserter(out.items));
    root = std::move(out);
}

using Migration = void (*)(JsonNode&);
/// From version i + 1 to the next.
constexpr std::array<Migration, 1> kMigrations{&fromVersion1};

} // namespace

void migratePreset(JsonNode& root, int version)
{
    for (auto i = static_cast<std::size_t>(version - 1); i < kMigrations.size(); ++i) {
        kMigrations[i](root);
    }
}

} // namespace fumage
