#include "app/cli/pass_options.h"

#include "core/base/text.h"

#include <array>
#include <string_view>

namespace fumage::cli {

namespace {

/// Of enumerators that are counted from 0, the one with a name that is among theirs.
template <class Enum, std::size_t kCount>
Enum named(const std::string& name)
{
    for (std::size_t i = 0; i < kCount; ++i) {
        if (nameOf(static_cast<Enum>(i)) == name) {
            return static_cast<Enum>(i);
        }
    }
    return Enum{};
}

} // namespace

Result<PassSet> parsePasses(const std::string& text)
{
    PassSet passes;
    for (std::string_view rest = text; !rest.empty();) {
        const std::string_view word = trimmed(rest.substr(0, rest.find(',')));
        rest.remove_prefix(std::min(rest.size(), rest.find(',') == std::string_view::npos ? rest.size() : rest.find(',') + 1));
        bool known = false;
        for (const Pass pass : kAllPasses) {
            const bool isSixWay = word == "six-way" && (pass == Pass::SixWayA || pass == Pass::SixWayB);
            if (word == "all" || isSixWay || word == passName(pass) || (word == "color" && pass == Pass::Colour)) {
                passes.add(pass);
                known = true;
            }
        }
        if (!known) {
            return Error{ErrorCode::UnknownName, said("there is no pass %1", inQuotes(word)), std::string("--passes"), said("Choose among colour, alpha, six-way, motion, normal, depth, emission, albedo, temperature, shadow and all")};
        }
    }
    if (passes == PassSet()) {
        return Error{ErrorCode::OutOfRange, said("no pass is asked for"), std::string("--passes"), said("Write colour,six-way,motion")};
    }
    return passes;
}

void PassOptions::addTo(CLI::App& command)
{
    command.add_option("--passes", passes, "Pictures to write, with commas between: colour, alpha, six-way (light maps), motion (vectors), normal, depth, emission, albedo, temperature, shadow, all")
        ->type_name("LIST")
        ->capture_default_str();
    command.add_option("--layout", layout, "Channels of the light maps: unity (right top back alpha, left bottom front emissive), embergen (top left right, bottom back front), rlt-bbf, tlrb-fb")
        ->check(CLI::IsMember({"unity", "embergen", "rlt-bbf", "tlrb-fb"}))
        ->capture_default_str();
    command.add_option("--vectors", vectors, "Signs of motion vectors: unity (red right, green up) or unreal (red left, green up)")->check(CLI::IsMember({"unity", "unreal"}))->capture_default_str();
    command.add_option("--alpha", alpha, "Light maps, emission and albedo: straight, or premultiplied. Default: straight in PNG, premultiplied in EXR")->check(CLI::IsMember({"straight", "premultiplied"}));
}

Status PassOptions::applyTo(ExportPlan& plan) const
{
    const Result<PassSet> parsed = parsePasses(passes);
    if (!parsed) {
        return parsed.error();
    }
    plan.passes = parsed.value();
    plan.style.layout = named<SixWayLayout, 4>(layout);
    plan.style.vectors = named<VectorSigns, 2>(vectors);
    plan.style.premultiplied = alpha.empty() ? fileEnding(plan.format) == ".exr" : alpha == "premultiplied";
    return Done{};
}

} // namespace fumage::cli
