#pragma once

#include "app/cli/streams.h"

#include "core/effect/parameter.h"
#include "core/preset/preset_file.h"
#include "core/preset/preset_keys.h"

#include <nlohmann/json.hpp>

namespace fumage::cli {

/// Prints an answer for programs; what is not UTF-8 in names of files becomes replacement characters.
[[nodiscard]] inline Status printJson(const nlohmann::ordered_json& answer)
{
    return print(answer.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

/// The values of a preset as they stand in its file.
class JsonValues {
public:
    explicit JsonValues(const Preset& preset)
        : m_file(nlohmann::ordered_json::parse(formatPreset(preset)))
    {
    }

    [[nodiscard]] const nlohmann::ordered_json& of(const Parameter& parameter, std::size_t layer = 0) const
    {
        const std::string_view group = parameter.group();
        const nlohmann::ordered_json& owner =
            parameter.scope == Scope::Scene ? m_file.at(kScene) : m_file.at(kLayers).at(layer);
        return owner.at(std::string(group)).at(std::string(parameter.key.substr(group.size() + 1)));
    }

private:
    nlohmann::ordered_json m_file;
};

} // namespace fumage::cli
