#include "core/rendering/passes.h"

#include "core/base/text.h"

namespace fumage {

namespace {

constexpr std::array<std::string_view, kPasses> kNames{"colour", "alpha", "density", "six-way-a", "six-way-b", "motion",
    "normal", "depth", "emission", "albedo", "temperature", "shadow", "layer-masks"};
constexpr std::string_view kNone = "none";

/// The passes that a word of a list stands for; none: it is not known.
PassSet passesCalled(std::string_view word)
{
    PassSet passes;
    for (const Pass pass : kAllPasses) {
        const bool isSixWay = word == "six-way" && (pass == Pass::SixWayA || pass == Pass::SixWayB);
        const bool isAmongAll = word == "all" && pass != Pass::LayerMasks;
        if (isAmongAll || isSixWay || word == passName(pass) || (word == "color" && pass == Pass::Colour)) {
            passes.add(pass);
        }
    }
    return passes;
}

} // namespace

std::string_view passName(Pass pass)
{
    return kNames[static_cast<std::size_t>(pass)];
}

Result<PassSet> parsePasses(std::string_view text)
{
    PassSet passes;
    if (trimmed(text) == kNone) {
        return passes;
    }
    if (trimmed(text).empty()) {
        return Error{
            ErrorCode::OutOfRange, makeMessage("no pass is asked for"), {}, makeMessage("Write colour,six-way,motion")};
    }
    Parts parts(text, ',');
    while (const std::optional<std::string_view> part = parts.next()) {
        const std::string_view word = trimmed(*part);
        const PassSet called = passesCalled(word);
        if (called == PassSet()) {
            return Error{ErrorCode::UnknownName, makeMessage("there is no pass %1", inQuotes(word)), {},
                makeMessage("Choose from colour, alpha, density, six-way, motion, normal, depth, emission, albedo, "
                            "temperature, shadow, layer-masks and all")};
        }
        passes.add(called);
    }
    return passes;
}

std::string textOf(PassSet passes)
{
    std::string text;
    for (const Pass pass : kAllPasses) {
        if (passes.has(pass)) {
            text += (text.empty() ? "" : ",") + std::string(passName(pass));
        }
    }
    return text.empty() ? std::string(kNone) : text;
}

bool needsTarget(PassSet passes, PassTarget target)
{
    switch (target) {
    case PassTarget::Colour: return passes.hasAny({Pass::Colour, Pass::Alpha, Pass::Density, Pass::LayerMasks});
    case PassTarget::RightTopBack: // both maps have one scale
    case PassTarget::LeftBottomFront: return passes.hasAny({Pass::SixWayA, Pass::SixWayB, Pass::Normal});
    case PassTarget::Motion: return passes.hasAny({Pass::Motion, Pass::Depth});
    case PassTarget::Emission: return passes.hasAny({Pass::SixWayB, Pass::Emission});
    case PassTarget::Albedo: return passes.has(Pass::Albedo);
    case PassTarget::Inner: return passes.hasAny({Pass::Temperature, Pass::Shadow});
    }
    return false;
}

} // namespace fumage
