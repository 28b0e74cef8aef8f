#pragma once

#include "core/effect/parameters/air.h"
#include "core/effect/parameters/camera.h"
#include "core/effect/parameters/emitter.h"
#include "core/effect/parameters/glow.h"
#include "core/effect/parameters/life.h"
#include "core/effect/parameters/light.h"
#include "core/effect/parameters/look.h"
#include "core/effect/parameters/motion.h"
#include "core/effect/parameters/noise.h"
#include "core/effect/parameters/output.h"
#include "core/effect/parameters/rings.h"
#include "core/effect/parameters/source.h"
#include "core/effect/parameters/timeline.h"
#include "core/effect/parameters/turbulence.h"
#include "core/effect/parameters/vortex.h"
#include "core/effect/parameters/wind.h"

namespace fumage {

/// The groups of the Effect in the order of panels and files.
template <class... Members>
struct GroupList {
    /// A group without its members.
    struct Heading {
        std::string_view name;
        std::string_view label;
        Scope scope;
    };
    static constexpr std::array kHeadings{
        Heading{kGroup<Members>.name, kGroup<Members>.label, kGroup<Members>.scope}...};

    static consteval auto table()
    {
        std::array<Parameter, (kRows<Members>.size() + ...)> all;
        auto* next = all.begin();
        ((next = std::copy(kRows<Members>.begin(), kRows<Members>.end(), next)), ...);
        return all;
    }
};
using Groups = GroupList<Emitter, Source, Motion, Wind, Air, Turbulence, Vortex, Rings, Life, Look, Noise, Glow, Light,
    Camera, Timeline, Output>;

/// The table behind parameterTable(), for what is decided while compiling.
inline constexpr std::array kParameterTable = Groups::table();

namespace rows {

/// @return the row with this key, or nullptr
constexpr const Parameter* find(std::string_view key)
{
    for (const Parameter& parameter : kParameterTable) {
        if (parameter.key == key) {
            return &parameter;
        }
    }
    return nullptr;
}

} // namespace rows

/// The row with a key that stands in the code: knownParameter("look.size"). A key that no row has does not compile.
[[nodiscard]] consteval const Parameter& knownParameter(std::string_view key)
{
    const Parameter* parameter = rows::find(key);
    if (parameter == nullptr) {
        rows::mistake("no parameter has this key");
    }
    return *parameter;
}

} // namespace fumage
