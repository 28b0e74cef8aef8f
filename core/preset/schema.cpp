#include "core/preset/schema.h"

#include "core/base/base64.h"
#include "core/effect/parameter_table.h"
#include "core/effect/track.h"
#include "core/effect/value.h"
#include "core/preset/preset_keys.h"
#include "core/preset/preset.h"

#include <nlohmann/json.hpp>

namespace fumage {

namespace {

using Json = nlohmann::ordered_json;

Json number(double value)
{
    return value == static_cast<double>(static_cast<std::int64_t>(value)) ? Json(static_cast<std::int64_t>(value))
                                                                          : Json(value);
}

Json ranged(const char* type, const Range& range)
{
    return {{"type", type}, {"minimum", number(range.low)}, {"maximum", number(range.high)}};
}

Json tuple(std::vector<Json> items)
{
    const std::size_t count = items.size();
    return {{"type", "array"}, {"prefixItems", std::move(items)}, {"minItems", count}, {"maxItems", count}};
}

Json listOf(Json item)
{
    return {{"type", "array"}, {"items", std::move(item)}, {"minItems", 1}, {"maxItems", kMaxControlPoints}};
}

Json valueSchema(const Parameter& parameter)
{
    Json component = ranged("number", parameter.hard);
    const Json position = ranged("number", {0.0, 1.0});
    switch (parameter.kind) {
    case Kind::Bool: return {{"type", "boolean"}};
    case Kind::Int:
    case Kind::Seed: return ranged("integer", parameter.hard);
    case Kind::Float: return component;
    case Kind::Choice: {
        Json names = Json::array();
        for (const std::string_view choice : parameter.choices) {
            names.push_back(choice);
        }
        return {{"enum", names}};
    }
    case Kind::Direction:
    case Kind::Vector:
    case Kind::Colour: return tuple({component, component, component});
    case Kind::Curve: return listOf(tuple({position, component}));
    case Kind::Gradient: return listOf(tuple({position, component, component, component}));
    case Kind::Picture:
        return {{"type", "string"}, {"contentEncoding", "base64"}, {"contentMediaType", "image/png"},
            {"maxLength", base64Length(kMaxPictureBytes)}};
    }
    return {};
}

std::string describe(const Parameter& parameter)
{
    const std::string_view unit = unitSymbol(parameter.unit);
    return std::string(parameter.tip) + (unit.empty() ? "" : " Unit: " + std::string(unit) + ".")
        + (parameter.source.empty() ? "" : " Source: " + std::string(parameter.source) + ".");
}

/// All groups of a scope, as an object of objects.
Json groupsSchema(Scope scope)
{
    Json groups = Json::object();
    const Effect defaults;
    for (const Parameter& parameter : parameterTable()) {
        if (parameter.scope != scope) {
            continue;
        }
        const std::string group(parameter.group());
        if (!groups.contains(group)) {
            groups[group] = {{"title", groupLabel(group)}, {"type", "object"}, {"additionalProperties", false},
                {"properties", Json::object()}};
        }
        Json schema = valueSchema(parameter);
        schema["title"] = parameter.label;
        schema["description"] = describe(parameter);
        schema["default"] = Json::parse(formatJson(parameter, parameter.get(defaults)));
        groups[group]["properties"][std::string(parameter.name())] = std::move(schema);
    }
    return {{"type", "object"}, {"additionalProperties", false}, {"properties", std::move(groups)}};
}

/// The tracks of a scope.
Json animationSchema(Scope scope)
{
    Json tracks = Json::array();
    for (const Parameter& parameter : parameterTable()) {
        if (parameter.scope != scope || !canAnimate(parameter)) {
            continue;
        }
        const Json slope = {{"anyOf",
            {Json{{"type", "number"}},
                tuple({Json{{"type", "number"}}, Json{{"type", "number"}}, Json{{"type", "number"}}})}}};
        const Json key = {{"type", "array"}, {"minItems", 2}, {"maxItems", 5},
            {"prefixItems", {Json{{"type", "number"}}, valueSchema(parameter), Json{{"enum", kEases}}, slope, slope}}};
        const Json outside = {{"enum", kExtrapolations}, {"default", kExtrapolations.front()}};
        tracks.push_back({{"type", "object"}, {"title", parameter.label}, {"additionalProperties", false},
            {"required", {kTrackParameter, kTrackKeys}},
            {"properties",
                {{kTrackParameter, {{"const", parameter.key}}}, {kTrackBefore, outside}, {kTrackAfter, outside},
                    {kTrackKeys, {{"type", "array"}, {"minItems", 1}, {"maxItems", kMaxKeyFrames}, {"items", key}}}}}});
    }
    return {{"type", "array"}, {"items", {{"anyOf", std::move(tracks)}}}};
}

/// The markers of a scene.
Json markersSchema()
{
    return {{"type", "array"}, {"maxItems", kMaxMarkers},
        {"items",
            {{"type", "object"}, {"additionalProperties", false}, {"required", {kMarkerName, kMarkerTime}},
                {"properties",
                    {{kMarkerName, {{"type", "string"}, {"minLength", 1}, {"maxLength", kMaxMarkerName}}},
                        {kMarkerTime, ranged("number", {0.0, kMaxMarkerSeconds})}}}}}};
}

/// A layer: what stands beside its groups, and those.
Json layerSchema()
{
    Json layer = groupsSchema(Scope::Layer);
    layer["properties"][kLayerName] = {{"type", "string"}, {"maxLength", kMaxLayerName}};
    layer["properties"][kLayerVisible] = {{"type", "boolean"}, {"default", true}};
    layer["properties"][kLayerLocked] = {{"type", "boolean"}, {"default", false}};
    layer["properties"][kLayerTag] = {{"enum", kColourTags}, {"default", kColourTags.front()}};
    layer["properties"][kLayerFrom] = {{"type", "string"}, {"maxLength", kMaxLayerName}};
    layer["properties"][kAnimation] = animationSchema(Scope::Layer);
    return layer;
}

} // namespace

std::string presetSchema()
{
    Json properties;
    properties["$schema"] = {{"type", "string"}};
    properties["format"] = {{"const", kPresetFormat}};
    properties["version"] = {{"const", kPresetVersion}};
    properties["name"] = {{"type", "string"}};
    properties["description"] = {{"type", "string"}};
    properties["scene"] = groupsSchema(Scope::Scene);
    properties["scene"]["properties"][kAnimation] = animationSchema(Scope::Scene);
    properties["scene"]["properties"][kMarkers] = markersSchema();
    properties["layers"] = {{"type", "array"}, {"minItems", 1}, {"maxItems", kMaxLayers}, {"items", layerSchema()}};
    const Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", "Fumage preset"},
        {"type", "object"}, {"required", {"format", "version"}}, {"additionalProperties", false},
        {"properties", std::move(properties)}};
    return schema.dump(2) + "\n";
}

} // namespace fumage
