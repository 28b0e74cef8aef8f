#pragma once

#include "core/effect/parameter.h"

#include <array>
#include <type_traits>

/// What the files of this folder are written in: one file a group of parameters, one block a row, one fact a line.
namespace fumage {

/// A struct of the Effect as the table sees it. Its file specialises kGroup and kRows.
template <class Members>
struct Group {
    Members Effect::*member = nullptr;
    std::string_view name; ///< first part of its keys
    std::string_view label; ///< heading, key for tr()
    Scope scope = Scope::Layer;
};

template <class Members>
inline constexpr Group<Members> kGroup{};

/// The rows of a group in the order of panels and files, the most used first.
template <class Members>
inline constexpr std::array<Parameter, 0> kRows{};

namespace rows {

/// Never defined, and not constexpr: a row that calls it does not compile, and the compiler shows the line that says
/// why.
void mistake(const char* what);

template <class>
struct Pointer;
template <class Struct, class Field>
struct Pointer<Field Struct::*> {
    using Class = Struct;
    using Type = Field;
};

template <auto Member>
struct Access {
    using Class = typename Pointer<decltype(Member)>::Class;
    using Type = typename Pointer<decltype(Member)>::Type;

    static Value get(const Effect& effect)
    {
        const Type& member = (effect.*kGroup<Class>.member).*Member;
        if constexpr (std::is_enum_v<Type>) {
            return static_cast<int>(member);
        } else {
            return member;
        }
    }

    static void set(Effect& effect, const Value& value)
    {
        Type& member = (effect.*kGroup<Class>.member).*Member;
        if constexpr (std::is_enum_v<Type>) {
            member = static_cast<Type>(std::get<int>(value));
        } else {
            member = std::get<Type>(value);
        }
    }
};

/// The kind that follows from a member's type; a vector has to say its own.
template <class T>
consteval Kind kindOf(Kind said)
{
    if constexpr (std::is_same_v<T, bool>) {
        return Kind::Bool;
    } else if constexpr (std::is_same_v<T, int>) {
        return Kind::Int;
    } else if constexpr (std::is_same_v<T, float>) {
        return Kind::Float;
    } else if constexpr (std::is_same_v<T, std::uint32_t>) {
        return Kind::Seed;
    } else if constexpr (std::is_same_v<T, Curve>) {
        return Kind::Curve;
    } else if constexpr (std::is_same_v<T, Gradient>) {
        return Kind::Gradient;
    } else if constexpr (std::is_same_v<T, Bitmap>) {
        return Kind::Picture;
    } else if constexpr (std::is_same_v<T, glm::vec3>) {
        if (said != Kind::Direction && said != Kind::Vector && said != Kind::Colour) {
            mistake("the row of a vec3 says whether it is a Kind::Direction, a Kind::Vector or a Kind::Colour");
        }
        return said;
    } else {
        static_assert(std::is_enum_v<T>, "parameters are of the types that a Value can hold");
        return Kind::Choice;
    }
}

} // namespace rows

/// Completes what a row says of a member with what follows from it: group, accessors and kind. A slider spans the hard
/// range where no soft one is given.
template <auto Member>
consteval Parameter row(Parameter parameter)
{
    using Field = rows::Access<Member>;
    constexpr std::string_view kName = kGroup<typename Field::Class>.name;
    if (parameter.key.size() < kName.size() + 2 || parameter.group() != kName) {
        rows::mistake("a key is the name of the member's group, a dot and a name");
    }
    parameter.kind = rows::kindOf<typename Field::Type>(parameter.kind);
    parameter.get = &Field::get;
    parameter.set = &Field::set;
    parameter.scope = kGroup<typename Field::Class>.scope;
    if (parameter.soft.low == parameter.soft.high) {
        parameter.soft = parameter.hard;
    }
    return parameter;
}

/// The row matters only while the member with this key has this value: an enumerator, a whole number or a bool.
consteval VisibleWhen when(std::string_view key, auto value)
{
    return {key, static_cast<int>(value)};
}

/// Only while it has one of two values.
consteval VisibleWhen when(std::string_view key, auto value, auto other)
{
    return {key, static_cast<int>(value), static_cast<int>(other)};
}

inline constexpr Range kUnit{0.0, 1.0};
inline constexpr Range kFarAway{-10000.0, 10000.0};
inline constexpr Range kComponents{-1.0, 1.0};
inline constexpr Range kColours{0.0, 100.0};
inline constexpr Range kSeeds{0.0, 4294967295.0};

} // namespace fumage
