#include "core/effect/shown_table.h"

#include "core/effect/parameter_table.h"
#include "core/effect/parameters/derived.h"
#include "core/effect/value.h"

#include <algorithm>

namespace fumage {

namespace {

const DerivedParameter* derivedOf(const Parameter& parameter)
{
    const auto found = std::find_if(kDerivedParameters.begin(), kDerivedParameters.end(),
        [&](const DerivedParameter& one) { return &one.row == &parameter; });
    return found != kDerivedParameters.end() ? &*found : nullptr;
}

/// Derived ones first in their group: they are the plain way to it.
std::vector<const Parameter*> arranged()
{
    std::vector<const Parameter*> all;
    std::string_view group;
    for (const Parameter& parameter : kParameterTable) {
        if (parameter.group() != group) {
            group = parameter.group();
            for (const DerivedParameter& derived : kDerivedParameters) {
                if (derived.row.group() == group) {
                    all.push_back(&derived.row);
                }
            }
        }
        all.push_back(&parameter);
    }
    return all;
}

} // namespace

const std::vector<const Parameter*>& shownParameters()
{
    static const std::vector<const Parameter*> all = arranged();
    return all;
}

const Parameter* findShownParameter(std::string_view key)
{
    for (const DerivedParameter& derived : kDerivedParameters) {
        if (derived.row.key == key) {
            return &derived.row;
        }
    }
    return findParameter(key);
}

const Parameter& storedParameter(const Parameter& shown)
{
    const DerivedParameter* derived = derivedOf(shown);
    return derived != nullptr ? *findParameter(derived->stored) : shown;
}

Value storedValue(const Parameter& shown, const Value& value, const Effect& effect)
{
    const Parameter& stored = storedParameter(shown);
    if (&stored == &shown) {
        return value;
    }
    Effect changed = effect;
    shown.set(changed, clampValue(shown, value).value);
    return clampValue(stored, stored.get(changed)).value;
}

} // namespace fumage
