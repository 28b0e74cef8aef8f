#include "core/effect/assignment.h"

#include "core/base/text.h"
#include "core/effect/parameter_table.h"
#include "core/effect/shown_table.h"
#include "core/effect/value.h"

namespace fumage {

Error noParameter(std::string_view key)
{
    const std::string_view near = nearestParameterKey(key);
    return {ErrorCode::UnknownKey, makeMessage("there is no parameter %1", inQuotes(key)), {},
        near.empty() ? makeMessage("List them with: fumage-cli parameters")
                     : makeMessage("Did you mean %1?", inQuotes(near))};
}

Result<bool> applyAssignment(Effect& effect, std::string_view assignment)
{
    const std::size_t equals = assignment.find('=');
    if (equals == std::string_view::npos) {
        return Error{ErrorCode::Syntax, makeMessage("%1 has no \"=\"", inQuotes(assignment)), {},
            makeMessage("Write key=value, for example wind.strength=1.5")};
    }
    const std::string_view key = trimmed(assignment.substr(0, equals));
    const Parameter* shown = findShownParameter(key);
    const Parameter* parameter = shown != nullptr ? shown : findFormerParameter(key);
    if (parameter == nullptr) {
        return noParameter(key);
    }
    const Result<Clamped> value = parseValue(*parameter, assignment.substr(equals + 1));
    if (!value) {
        return value.error();
    }
    const Value stored = storedValue(*parameter, value.value().value, effect);
    const bool changed = setClamped(effect, storedParameter(*parameter), stored);
    return changed || value.value().changed || clampValue(*parameter, value.value().value).changed;
}

} // namespace fumage
