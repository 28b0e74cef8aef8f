#pragma once

#include "app/cli/streams.h"

#include <nlohmann/json.hpp>

namespace fumage::cli {

/// Prints an answer for programs; what is not UTF-8 in names of files becomes replacement characters.
[[nodiscard]] inline Status printJson(const nlohmann::ordered_json& answer)
{
    return print(answer.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

} // namespace fumage::cli
