#pragma once

#include "core/base/result.h"
#include "core/rendering/image.h"
#include "core/rendering/sprites.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace fumage {

/// What can be seen of smoke at a place of a picture, beside its colour.
enum class Pass {
    Colour, ///< as the effect lights it
    Alpha,
    Density, ///< optical depth: smoke in front of smoke adds up
    SixWayA, ///< white smoke under white light from the right, from the top and from behind
    SixWayB, ///< from the left, from the bottom and from the front; its fourth channel says how much smoke glows
    Motion, ///< way to the next picture, as a share of its width and height
    Normal, ///< the way that the smoke faces, as the six lights tell it
    Depth, ///< distance along the view, m
    Emission, ///< what the smoke gives of itself
    Albedo, ///< its own colour
    Temperature, ///< share of the heat at birth, of what glows; 0 where nothing does
    Shadow, ///< share of the sun that comes through
    LayerMasks, ///< of each layer the share of the alpha that it gives; they add up to it
};
inline constexpr std::size_t kPasses = 13;

/// All of them, in the order in which they are told.
inline constexpr std::array<Pass, kPasses> kAllPasses{Pass::Colour, Pass::Alpha, Pass::Density, Pass::SixWayA,
    Pass::SixWayB, Pass::Motion, Pass::Normal, Pass::Depth, Pass::Emission, Pass::Albedo, Pass::Temperature,
    Pass::Shadow, Pass::LayerMasks};

/// "colour", "six-way-a": what command lines and side-cars call it.
[[nodiscard]] std::string_view passName(Pass pass);

/// Some of the passes.
class PassSet {
public:
    constexpr PassSet() = default;
    constexpr PassSet(std::initializer_list<Pass> passes)
    {
        for (const Pass pass : passes) {
            add(pass);
        }
    }
    /// Takes one in.
    constexpr void add(Pass pass) { m_bits |= bit(pass); }
    /// Takes all of several in.
    constexpr void add(PassSet passes) { m_bits |= passes.m_bits; }
    /// Whether one is in it.
    [[nodiscard]] constexpr bool has(Pass pass) const { return (m_bits & bit(pass)) != 0; }
    /// Whether one of several is in it.
    [[nodiscard]] constexpr bool hasAny(PassSet passes) const { return (m_bits & passes.m_bits) != 0; }

    friend bool operator==(const PassSet&, const PassSet&) = default;

private:
    static constexpr std::uint32_t bit(Pass pass) { return 1U << static_cast<unsigned>(pass); }
    std::uint32_t m_bits = 0;
};

/// Reads "colour,six-way,motion"; "six-way" is both maps, "all" all that every format holds, which are all but the
/// masks of layers, and "none" alone none.
/// @error UnknownName; OutOfRange for an empty list
[[nodiscard]] Result<PassSet> parsePasses(std::string_view text);
/// "colour,six-way-a", "none": what parsePasses() reads.
[[nodiscard]] std::string textOf(PassSet passes);

/// The pictures that passes are made of: each three channels that are blended as the colour is, premultiplied, and the
/// alpha of the smoke.
enum class PassTarget {
    Colour,
    RightTopBack, ///< light of intensity 1 on white smoke, one direction a channel
    LeftBottomFront,
    Motion, ///< to the right and up, as shares of the picture, then the depth in m
    Emission,
    Albedo,
    Inner, ///< temperature and shadow
};
inline constexpr std::size_t kPassTargets = 7;

/// The targets that passes need.
[[nodiscard]] bool needsTarget(PassSet passes, PassTarget target);

/// The targets of one frame; those that nobody asked for are empty.
struct PassImages {
    std::array<Image, kPassTargets> targets;

    /// The picture of a target.
    [[nodiscard]] Image& of(PassTarget target) { return targets[static_cast<std::size_t>(target)]; }
    /// As above.
    [[nodiscard]] const Image& of(PassTarget target) const { return targets[static_cast<std::size_t>(target)]; }
};

} // namespace fumage
