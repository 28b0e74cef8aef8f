#pragma once

#include "core/preset/json_tree.h"

#include <functional>

namespace fumage {

/// How what is wrong with a node is said.
struct NodeTalk {
    std::function<Error(const JsonNode& node, ErrorCode code, const Message& message, const Message& remedy)> error;
    std::function<void(const JsonNode& node, const Message& message)> warn;
};

} // namespace fumage
