#include "app/cli/pass_options.h"

#include "core/base/text.h"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

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
    if (trimmed(text) == "none") {
        return passes;
    }
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
    std::vector<std::string> engines;
    std::transform(kAllEngines.begin(), kAllEngines.end(), std::back_inserter(engines), [](Engine each) { return std::string(nameOf(each)); });
    command.add_option("--for", engine,
               "What is to play it: generic, unity, unreal, godot (4), godot3, effekseer, pixi (Phaser, too), defold, web. Chooses passes and "
               "their signs, and writes the files that it needs")
        ->type_name("ENGINE")
        ->check(CLI::IsMember(engines))
        ->capture_default_str();
    command.add_option("--passes", passes,
               "Pictures to write, with commas between: colour, alpha, six-way (light maps), motion (vectors), normal, depth, emission, albedo, "
               "temperature, shadow, all; none beside --pack. Default: colour, or what --for makes use of")
        ->type_name("LIST");
    command.add_option("--layout", layout,
               "Channels of the light maps: unity (right top back alpha, left bottom front emissive; the default), embergen (top left right, "
               "bottom back front; of unreal), rlt-bbf, tlrb-fb")
        ->check(CLI::IsMember({"unity", "embergen", "rlt-bbf", "tlrb-fb"}));
    command.add_option("--vectors", vectors,
               "Signs of motion vectors: unity (red right, green up; the default) or unreal (red left, green up)")
        ->check(CLI::IsMember({"unity", "unreal"}));
    command.add_option("--alpha", alpha,
               "Light maps, emission and albedo: straight, or premultiplied. Default: straight in PNG, premultiplied in EXR")
        ->check(CLI::IsMember({"straight", "premultiplied"}));
}

void PassOptions::addPackTo(CLI::App& command)
{
    command.add_option("--pack", packs,
               "A picture with channels of your choice: masks=shadow,temperature,alpha makes smoke_masks.png. One to four, each a pass of one number "
               "(alpha, depth, temperature, shadow), a channel of another (colour.r, six-way-a.g, motion.r, normal.b), 0 or 1; at the end @1/2 to @1/16 "
               "for fewer pixels. Up to five times")
        ->type_name("NAME=CHANNELS[@SCALE]")
        ->take_all()
        ->allow_extra_args(false)
        ->option_text("NAME=CHANNELS[@SCALE]");
}

void PassOptions::addLayersTo(CLI::App& command)
{
    command.add_option("--passes", passes,
               "Layers of an EXR, with commas between: colour, alpha, six-way (light from six sides), motion (vectors), normal, depth, emission, "
               "albedo, temperature, shadow, all. Default: colour")
        ->type_name("LIST");
    command.add_option("--alpha", alpha, "Light, emission and albedo: premultiplied (the default), or straight")->check(CLI::IsMember({"straight", "premultiplied"}));
}

Status PassOptions::applyTo(ExportPlan& plan) const
{
    plan.engine = named<Engine, kEngines>(engine);
    plan.passes = passesFor(plan.engine);
    plan.style = styleFor(plan.engine, plan.format);
    if (!passes.empty()) {
        const Result<PassSet> parsed = parsePasses(passes);
        if (!parsed) {
            return parsed.error();
        }
        plan.passes = parsed.value();
    }
    if (!layout.empty()) {
        plan.style.layout = named<SixWayLayout, 4>(layout);
    }
    if (!vectors.empty()) {
        plan.style.vectors = named<VectorSigns, 2>(vectors);
    }
    if (!alpha.empty()) {
        plan.style.premultiplied = alpha == "premultiplied";
    }
    for (const std::string& text : packs) {
        const Result<PackedPicture> pack = parsePack(text);
        if (!pack) {
            Error error = pack.error();
            error.place = std::string("--pack");
            return error;
        }
        plan.packs.push_back(pack.value());
    }
    return Done{};
}

} // namespace fumage::cli
