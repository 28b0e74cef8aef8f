#include "core/rendering/passes.h"

namespace fumage {

namespace {

constexpr std::array<std::string_view, kPasses> kNames{"colour", "alpha", "six-way-a", "six-way-b", "motion", "normal", "depth", "emission", "albedo", "temperature", "shadow"};

} // namespace

std::string_view passName(Pass pass)
{
    return kNames[static_cast<std::size_t>(pass)];
}

bool needsLayer(PassSet passes, PassLayer layer)
{
    switch (layer) {
    case PassLayer::Colour: return passes.hasAny({Pass::Colour, Pass::Alpha});
    case PassLayer::RightTopBack: // both maps have one scale
    case PassLayer::LeftBottomFront: return passes.hasAny({Pass::SixWayA, Pass::SixWayB, Pass::Normal});
    case PassLayer::Motion: return passes.hasAny({Pass::Motion, Pass::Depth});
    case PassLayer::Emission: return passes.has(Pass::Emission);
    case PassLayer::Albedo: return passes.has(Pass::Albedo);
    case PassLayer::Inner: return passes.hasAny({Pass::SixWayB, Pass::Temperature, Pass::Shadow});
    }
    return false;
}

} // namespace fumage
