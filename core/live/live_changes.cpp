#include "core/live/live_changes.h"

#include "core/effect/known_parameter.h"
#include "core/effect/parameter_table.h"

#include <algorithm>

namespace fumage {

namespace {

/// Whether two layers are the same to those who refer to them.
bool isSameLayer(const Layer& one, const Layer& other)
{
    return one.name == other.name && one.visible == other.visible && one.from == other.from;
}

} // namespace

Status checkChange(const Effect& now, const Effect& wanted)
{
    for (const Parameter& parameter : parameterTable()) {
        const bool matters =
            parameter.group() != "air" || now.air.enabled || &parameter == &knownParameter("air.enabled");
        if (parameter.live == Live::Fixed && matters && parameter.get(now) != parameter.get(wanted)) {
            return Error{ErrorCode::OutOfRange, makeMessage("%1 is fixed while the simulation runs", parameter.key), {},
                makeMessage("Keep it, or start a new simulation")};
        }
    }
    return Done{};
}

Status checkChange(const Scene& now, const Scene& wanted)
{
    if (!std::equal(wanted.layers.begin(), wanted.layers.end(), now.layers.begin(), now.layers.end(), isSameLayer)) {
        return Error{ErrorCode::OutOfRange,
            makeMessage("layers, their names, what is muted and what is born on what are fixed while the simulation "
                        "runs"),
            {}, makeMessage("Keep them, or start a new simulation; a layer whose share is 0 goes out")};
    }
    for (std::size_t layer = 0; layer < wanted.layers.size(); ++layer) {
        if (Status status = checkChange(now.effect(layer), wanted.effect(layer)); !status) {
            return status;
        }
    }
    return Done{};
}

} // namespace fumage
