#include "app/cli/command.h"
#include "app/cli/kept_apart.h"
#include "app/cli/optimise.h"
#include "app/cli/picture_options.h"

#include "core/base/text.h"
#include "core/export/jobs/jobs.h"

#include <iomanip>
#include <memory>
#include <sstream>
#include <utility>

namespace fumage::cli {

namespace {

struct FlipbookArguments {
    PictureOptions picture;
    std::string grid; ///< empty: see gridFor()
    std::string budget;
};

/// Which edges, which frames, and what would help.
std::string complaint(const Flipbook& flipbook, const ExportPlan& plan)
{
    const CutOff& cut = *flipbook.cutOff;
    std::string edges;
    for (const auto& [reached, name] : {std::pair{cut.left, "left"}, std::pair{cut.right, "right"},
             std::pair{cut.top, "top"}, std::pair{cut.bottom, "bottom"}}) {
        if (reached) {
            edges += (edges.empty() ? "" : ", ") + std::string(name);
        }
    }
    std::ostringstream text;
    text << "the smoke is cut off at the edge of cells (" << edges << "; frames " << cut.firstFrame << " to "
         << cut.lastFrame << "; alpha up to " << std::setprecision(2) << flipbook.edgeAlpha << "): ";
    if (plan.fitCamera && plan.outlierPercent > 0.0F) {
        text << "--ignore-outliers leaves it outside";
        return text.str();
    }
    text << "--fit moves the camera so that all of it is seen";
    if (cut.distance > 0.0F) {
        text << ", as would --set camera.distance=" << std::setprecision(3) << cut.distance;
    }
    return text.str();
}

constexpr const char* kUsualGrid = "8x8";

/// A sheet that ends in _8x8 says itself how many cells it has: several tools read it off.
NamedPreset namedForItsGrid(const FlipbookArguments& arguments, NamedPreset named)
{
    int columns = 0;
    int rows = 0;
    if (arguments.picture.options.isForAnEngine() && gridFor(arguments.grid, kUsualGrid, named, columns, rows)) {
        named.name += "_" + std::to_string(columns) + "x" + std::to_string(rows);
    }
    return named;
}

/// Cells may have to be of another size than was asked for.
Status tellSize(const PictureJob& job)
{
    const Result<Output> output = outputFor(job.scene, job.plan);
    if (!output) {
        return output.error();
    }
    const int width = output.value().width;
    const int height = output.value().height;
    if (width != job.scene.output.width || height != job.scene.output.height) {
        report("cells are " + std::to_string(width) + " x " + std::to_string(height) + " pixels, and the sheet "
            + std::to_string(width * job.plan.flipbook.columns) + " x "
            + std::to_string(height * job.plan.flipbook.rows));
    }
    return Done{};
}

Result<PictureJob> jobOf(const FlipbookArguments& arguments, const NamedPreset& named)
{
    Result<PictureJob> job = arguments.picture.jobFor(named, ExportKind::Flipbook);
    if (!job) {
        return job.error();
    }
    ExportPlan& plan = job.value().plan;
    if (Status status = gridFor(arguments.grid, kUsualGrid, named, plan.flipbook.columns, plan.flipbook.rows);
        !status) {
        return status.error();
    }
    if (named.shown.sheet && arguments.picture.frames.empty() && !arguments.picture.options.has("retime")) {
        plan.flipbook.retime = named.shown.sheet->retime;
    }
    return job;
}

/// The same for the grid and the cells that play best within the budget.
Result<FlipbookArguments> optimised(FlipbookArguments arguments, const NamedPreset& named)
{
    const Result<PictureJob> job = jobOf(arguments, named);
    if (!job) {
        return job.error();
    }
    const Result<SheetCandidate> best = chooseSheet(job.value(), arguments.budget);
    if (!best) {
        return best.error();
    }
    arguments.budget.clear();
    arguments.grid = std::to_string(best.value().columns) + "x" + std::to_string(best.value().rows);
    arguments.picture.size = std::to_string(best.value().width) + "x" + std::to_string(best.value().height);
    return arguments;
}

Status renderOne(const FlipbookArguments& arguments, const NamedPreset& unnumbered, JobFiles& written)
{
    if (!arguments.budget.empty()) {
        const Result<FlipbookArguments> chosen = optimised(arguments, unnumbered);
        return chosen ? renderOne(chosen.value(), unnumbered, written) : chosen.error();
    }
    const NamedPreset named = namedForItsGrid(arguments, unnumbered);
    const Result<PictureJob> job = jobOf(arguments, named);
    if (!job) {
        return job.error();
    }
    if (Status status = tellSize(job.value()); !status) {
        return status;
    }
    if (Status status = keepApart(named.name, job.value().scene, job.value().plan, written); !status) {
        return status;
    }
    const Result<std::optional<Flipbook>> done = writePictures(job.value());
    if (!done) {
        return done.error();
    }
    if (done.value() && done.value()->cutOff) {
        warn(complaint(*done.value(), job.value().plan));
    }
    return Done{};
}

Status flipbook(const FlipbookArguments& arguments)
{
    JobFiles written;
    return arguments.picture.effect.forEach(
        arguments.picture.output, [&](const NamedPreset& named) { return renderOne(arguments, named, written); });
}

} // namespace

void addFlipbook(CLI::App& program, Action& action)
{
    auto arguments = std::make_shared<FlipbookArguments>();
    CLI::App* command =
        program.add_subcommand("flipbook", "Render a flipbook: frames side by side in one picture, and how to play it");
    arguments->picture.addTo(*command, "Picture to write. In a folder, and by default, the preset's name",
        "Size of a cell: 256 or 320x180. Default: the preset's",
        "Frames: 0-119 or 0-119:2. Default: the whole timeline, or those of the sheet that carries the preset");
    arguments->picture.addFormat(*command);
    arguments->picture.manifest.addTo(*command);
    CLI::Option* grid =
        command
            ->add_option("--grid", arguments->grid,
                "Columns and rows: 8 or 8x4. Default: 8x8, or of a sheet that carries its preset its own")
            ->type_name("GRID");
    command
        ->add_option("--optimise", arguments->budget,
            "Memory that the pictures may take as BC7, such as 4MB: tries grids with cells as large as fits, at most "
            "--size, prints how well each plays, and takes the best")
        ->type_name("BUDGET")
        ->option_text("BUDGET")
        ->excludes(grid);
    arguments->picture.options.addAllTo(*command, ExportKind::Flipbook);
    command->footer(
        "The frames are spread evenly over the cells, first at the top left, then along the rows. Beside smoke.png a "
        "file smoke.flipbook.json says\n"
        "how many columns and rows there are and how fast they are played. PNG: colours go on under transparent "
        "pixels, so that filtering makes no dark rims.\n"
        "--for an engine writes what makes it play: a scene and a shader for Godot, scripts that import the textures "
        "for Unity and Unreal, a project for\n"
        "Effekseer, TexturePacker's JSON for PixiJS and Phaser, a tile source for Defold, or one web page that plays "
        "the sheet by itself.\n"
        "Passes are pictures of their own: smoke_sixway_a.png, smoke_sixway_b.png, smoke_motion.png. They are linear: "
        "engines must not take them for sRGB. The\n"
        "side-car says what their channels are, and the scale that light and vectors are multiplied by.\n"
        "--pack puts channels of any passes into a picture of its own, at a resolution of its own; the side-car says "
        "what each holds. Only what is asked for is rendered.\n"
        "Examples:\n"
        "  fumage-cli flipbook campfire --size 256 --output fire.png\n"
        "  fumage-cli flipbook chimney --grid 8x4 --size 256x512 --frames 0-63 --set timeline.loop=true --output "
        "smoke.png\n"
        "  fumage-cli flipbook explosion --passes colour,six-way,motion --vectors unreal --output boom.png\n"
        "  fumage-cli flipbook explosion --pack masks=shadow,temperature,alpha@1/2 --pack "
        "light=six-way-a.r,six-way-a.g,0,1 --output boom.png\n"
        "  fumage-cli flipbook chimney --for godot --size 256 --output project/smoke/");
    command->callback([arguments, &action] { action = [arguments] { return flipbook(*arguments); }; });
}

} // namespace fumage::cli
