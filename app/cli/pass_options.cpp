#include "app/cli/pass_options.h"

#include "core/base/text.h"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

namespace fumage::cli {

void PassOptions::addTo(CLI::App& command)
{
    std::vector<std::string> engines;
    std::transform(kAllEngines.begin(), kAllEngines.end(), std::back_inserter(engines),
        [](Engine each) { return std::string(nameOf(each)); });
    command
        .add_option("--for", engine,
            "What is to play it: generic, unity, unreal, godot (4), godot3, effekseer, pixi (Phaser, too), defold, "
            "web. Chooses passes and their signs, and writes the files that it needs")
        ->type_name("ENGINE")
        ->check(CLI::IsMember(engines))
        ->capture_default_str();
    command
        .add_option("--passes", passes,
            "Pictures to write, with commas between: colour, alpha, density, six-way (light maps), motion (vectors), "
            "normal, depth, emission, albedo, temperature, shadow, all; none beside --pack. Default: colour, or what "
            "--for makes use of")
        ->type_name("LIST");
    command
        .add_option("--layout", layout,
            "Channels of the light maps: unity (right top back alpha, left bottom front emissive; the default), "
            "embergen (top left right, bottom back front; of unreal), rlt-bbf, tlrb-fb")
        ->check(CLI::IsMember({"unity", "embergen", "rlt-bbf", "tlrb-fb"}));
    command
        .add_option("--vectors", vectors,
            "Signs of motion vectors: unity (red right, green up; the default) or unreal (red left, green up)")
        ->check(CLI::IsMember({"unity", "unreal"}));
    command.add_option("--normals", normals, "Green of normals: opengl (up; the default) or directx (down; of unreal)")
        ->check(CLI::IsMember({"opengl", "directx"}));
    command
        .add_option("--alpha", alpha,
            "Light maps, emission and albedo: straight, or premultiplied. Default: straight in PNG, premultiplied in "
            "EXR, as the colour always is")
        ->check(CLI::IsMember({"straight", "premultiplied"}));
}

void PassOptions::addPackTo(CLI::App& command)
{
    command
        .add_option("--pack", packs,
            "A picture with channels of your choice: masks=shadow,temperature,alpha makes smoke_masks.png. One to "
            "four, each a pass of one number (alpha, density, depth, temperature, shadow), a channel of another "
            "(colour.r, six-way-a.g, motion.r, normal.b), 0 or 1; at the end @1/2 to @1/16 for fewer pixels. Up to "
            "five times")
        ->type_name("NAME=CHANNELS[@SCALE]")
        ->take_all()
        ->allow_extra_args(false)
        ->option_text("NAME=CHANNELS[@SCALE]");
}

void PassOptions::addTargetsTo(CLI::App& command)
{
    command
        .add_option("--passes", passes,
            "Layers of an EXR, with commas between: colour, alpha, density, six-way (light from six sides), motion "
            "(vectors), normal, depth, emission, albedo, temperature, shadow, all. Default: colour")
        ->type_name("LIST");
    command
        .add_option("--alpha", alpha,
            "Light, emission and albedo: premultiplied (the default), or straight; the colour is premultiplied, as "
            "readers of EXR expect it")
        ->check(CLI::IsMember({"straight", "premultiplied"}));
}

Status PassOptions::applyTo(ExportPlan& plan) const
{
    plan.engine = enumeratorNamed<Engine, kEngines>(engine).value_or(Engine{});
    plan.passes = passesFor(plan.engine);
    plan.style = styleFor(plan.engine, plan.format);
    if (!passes.empty()) {
        const Result<PassSet> parsed = parsePasses(passes);
        if (!parsed) {
            Error error = parsed.error();
            error.place = std::string("--passes");
            return error;
        }
        plan.passes = parsed.value();
    }
    if (!layout.empty()) {
        plan.style.layout = enumeratorNamed<SixWayLayout, kSixWayLayouts>(layout).value_or(SixWayLayout{});
    }
    if (!vectors.empty()) {
        plan.style.vectors = enumeratorNamed<VectorSigns, kVectorSigns>(vectors).value_or(VectorSigns{});
    }
    if (!normals.empty()) {
        plan.style.normals = enumeratorNamed<NormalGreen, kNormalGreens>(normals).value_or(NormalGreen{});
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
