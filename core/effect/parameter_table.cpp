#include "core/effect/parameter_table.h"

#include "core/base/text.h"
#include "core/effect/known_parameter.h"

#include <algorithm>
#include <vector>

namespace fumage {

namespace {

struct AnyMember {
    template <class T>
    constexpr operator T&() const&& noexcept; // NOLINT(google-explicit-constructor): stands for a member of any type
    template <class T>
    constexpr operator T&&() const&& noexcept; // NOLINT(google-explicit-constructor)
};

template <class T, class... Members>
consteval std::size_t memberCount()
{
    if constexpr (requires { T{Members{}..., AnyMember{}}; }) {
        return memberCount<T, Members..., AnyMember>();
    } else {
        return sizeof...(Members);
    }
}

template <class Members>
consteval bool everyMemberHasItsRow()
{
    static_assert(memberCount<Members>() == kRows<Members>.size(), "a member has no row, or there is a row too many");
    return true;
}

template <class... Members>
consteval bool everyGroupIsListed(GroupList<Members...> /*list*/)
{
    static_assert(memberCount<Effect>() == sizeof...(Members), "a member of Effect is missing in the list of groups");
    return (everyMemberHasItsRow<Members>() && ...);
}
static_assert(everyGroupIsListed(Groups()));

/// Two rows of one member would hide that another has none.
consteval bool everyRowIsDifferent()
{
    return std::all_of(kParameterTable.begin(), kParameterTable.end(), [](const Parameter& row) {
        return std::count_if(kParameterTable.begin(), kParameterTable.end(), [&](const Parameter& other) {
            return other.key == row.key || other.get == row.get;
        }) == 1;
    });
}
static_assert(everyRowIsDifferent(), "two rows have the same key or member");

/// Whether a row is there that can have the value that another one waits for.
constexpr bool canBe(const VisibleWhen& condition)
{
    const Parameter* row = rows::find(condition.key);
    return row != nullptr
        && (row->kind == Kind::Bool || row->kind == Kind::Int
            || (row->kind == Kind::Choice && static_cast<std::size_t>(condition.value) < row->choices.size()
                && static_cast<std::size_t>(condition.other) < row->choices.size()));
}
static_assert(std::all_of(kParameterTable.begin(), kParameterTable.end(),
                  [](const Parameter& row) { return row.visible.key.empty() || canBe(row.visible); }),
    "a row is visible only with a value that no other row can have");

/// A former key is nobody's today and was one row's.
consteval bool formerKeysAreUnique()
{
    return std::all_of(kParameterTable.begin(), kParameterTable.end(), [](const Parameter& row) {
        return row.formerly.empty()
            || std::count_if(kParameterTable.begin(), kParameterTable.end(),
                   [&](const Parameter& other) { return other.formerly == row.formerly || other.key == row.formerly; })
            == 1;
    });
}
static_assert(formerKeysAreUnique(), "a former key is that of another row, too");

const Groups::Heading* headingOf(std::string_view group)
{
    const auto* found = std::find_if(Groups::kHeadings.begin(), Groups::kHeadings.end(),
        [&](const Groups::Heading& heading) { return heading.name == group; });
    return found != Groups::kHeadings.end() ? found : nullptr;
}

} // namespace

std::span<const Parameter> parameterTable()
{
    return kParameterTable;
}

const Parameter* findParameter(std::string_view key)
{
    return rows::find(key);
}

const Parameter* findFormerParameter(std::string_view key)
{
    const auto* found = std::find_if(kParameterTable.begin(), kParameterTable.end(),
        [&](const Parameter& row) { return !row.formerly.empty() && row.formerly == key; });
    return found != kParameterTable.end() ? found : nullptr;
}

std::string_view nearestParameterKey(std::string_view key)
{
    std::vector<std::string_view> keys;
    for (const Parameter& parameter : kParameterTable) {
        keys.push_back(parameter.key);
        if (!parameter.formerly.empty()) {
            keys.push_back(parameter.formerly);
        }
    }
    const std::string_view nearest = nearestName(key, keys);
    const Parameter* former = findFormerParameter(nearest);
    return former != nullptr ? former->key : nearest;
}

std::string_view groupLabel(std::string_view group)
{
    const auto* heading = headingOf(group);
    return heading != nullptr ? heading->label : std::string_view();
}

std::optional<Scope> groupScope(std::string_view group)
{
    const auto* heading = headingOf(group);
    return heading != nullptr ? std::optional(heading->scope) : std::nullopt;
}

bool isVisible(const Parameter& parameter, const Effect& effect)
{
    const Parameter* other = parameter.visible.key.empty() ? nullptr : findParameter(parameter.visible.key);
    if (other == nullptr) {
        return true;
    }
    const Value value = other->get(effect);
    const bool* flag = std::get_if<bool>(&value);
    const int number = flag != nullptr ? static_cast<int>(*flag) : std::get<int>(value);
    return number == parameter.visible.value || number == parameter.visible.other;
}

} // namespace fumage
