#include "core/export/flipbook.h"

#include "core/base/file.h"
#include "core/rendering/framing.h"
#include "core/rendering/renderer.h"
#include "core/simulation/simulator.h"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace fumage {

namespace {

Status check(const Effect& effect, const FlipbookOptions& options)
{
    const auto inRange = [](int count) { return count >= 1 && count <= kMaxSheetCells; };
    if (!inRange(options.columns) || !inRange(options.rows)) {
        return Error{ErrorCode::OutOfRange, said("a flipbook of %1 x %2 cells", options.columns, options.rows), {}, said("Use 1 to %1 columns and rows", kMaxSheetCells)};
    }
    const int cells = options.columns * options.rows;
    if (options.frames.count() < cells) {
        return Error{ErrorCode::OutOfRange, said("%1 frames do not fill %2 cells", options.frames.count(), cells), {}, said("Choose more frames or fewer columns and rows")};
    }
    const std::int64_t width = static_cast<std::int64_t>(effect.output.width) * options.columns;
    const std::int64_t height = static_cast<std::int64_t>(effect.output.height) * options.rows;
    if (width > kMaxSheetEdge || height > kMaxSheetEdge || width * height > static_cast<std::int64_t>(kMaxSheetPixels)) {
        return Error{ErrorCode::TooLarge, said("a flipbook of %1 x %2 pixels", width, height), {}, said("Choose smaller or fewer cells: edges up to %1 pixels, at most %2 million in all", kMaxSheetEdge, kMaxSheetPixels >> 20U)};
    }
    return Done{};
}

void place(const Image& cell, Image& sheet, int left, int top)
{
    for (int y = 0; y < cell.height; ++y) {
        std::copy_n(cell.row(y), static_cast<std::size_t>(cell.width) * 4, sheet.row(top + y) + static_cast<std::size_t>(left) * 4);
    }
}

float mostAlphaOnTheBorder(const Image& cell)
{
    float most = 0.0F;
    for (int x = 0; x < cell.width; ++x) {
        most = std::max({most, cell.at(x, 0).a, cell.at(x, cell.height - 1).a});
    }
    for (int y = 0; y < cell.height; ++y) {
        most = std::max({most, cell.at(0, y).a, cell.at(cell.width - 1, y).a});
    }
    return most;
}

/// Looks for smoke on the borders of cells with a transparent background.
class BorderWatch {
public:
    explicit BorderWatch(const SampledEffect& smoke)
        : m_smoke(smoke)
        , m_framing(smoke->camera, smoke->output.width, smoke->output.height)
    {
    }

    void look(const Image& cell, const Frame& frame, const Appearance& appearance)
    {
        if (m_smoke->output.background != Background::Transparent) {
            return;
        }
        m_framing.addParticles(frame.particles, appearance, secondsOf(m_smoke->timeline, frame.number));
        const float alpha = mostAlphaOnTheBorder(cell);
        m_alpha = std::max(m_alpha, alpha);
        constexpr float kSeen = 1.0F / 255.0F;
        if (alpha < kSeen) {
            return;
        }
        const PictureReach reach = reachOf(cell, kSeen);
        if (!m_cutOff) {
            m_cutOff = CutOff{.firstFrame = frame.number, .lastFrame = frame.number};
        }
        m_cutOff->firstFrame = std::min(m_cutOff->firstFrame, frame.number);
        m_cutOff->lastFrame = std::max(m_cutOff->lastFrame, frame.number);
        m_cutOff->left |= reach.left == 0;
        m_cutOff->top |= reach.top == 0;
        m_cutOff->right |= reach.right == cell.width;
        m_cutOff->bottom |= reach.bottom == cell.height;
    }

    /// Writes down what was seen.
    void tell(Flipbook& flipbook) const
    {
        flipbook.edgeAlpha = m_alpha;
        flipbook.cutOff = m_cutOff;
        if (m_cutOff && m_smoke->camera.mode == CameraMode::Orbit) {
            flipbook.cutOff->distance = m_framing.distanceFrom(m_smoke->camera.target);
        }
    }

private:
    const SampledEffect& m_smoke;
    Framing m_framing;
    float m_alpha = 0.0F;
    std::optional<CutOff> m_cutOff;
};

std::string describe(const Effect& effect, const FlipbookOptions& options, const Flipbook& flipbook)
{
    const bool png = fileEnding(options.format) == ".png";
    nlohmann::ordered_json json;
    json["format"] = "fumage-flipbook";
    json["version"] = 1;
    json["picture"] = flipbook.picture.filename().string();
    json["columns"] = options.columns;
    json["rows"] = options.rows;
    json["cell_width"] = effect.output.width;
    json["cell_height"] = effect.output.height;
    json["order"] = "left to right, then top to bottom";
    json["cells_per_second"] = flipbook.cellsPerSecond;
    json["seconds"] = options.columns * options.rows / flipbook.cellsPerSecond;
    json["loop"] = effect.timeline.loop;
    json["alpha"] = png ? "straight" : "premultiplied";
    json["colour"] = png ? "sRGB" : "linear";
    return json.dump(2) + "\n";
}

/// Renders the cells into the sheet, and says of the flipbook whether they hold all smoke.
Status renderCells(const Effect& effect, const FlipbookOptions& options, Image& sheet, Flipbook& flipbook, const Progress& progress, const std::stop_token& stop)
{
    const Output& output = effect.output;
    const SampledEffect smoke = sampled(effect);
    Simulator simulator(smoke);
    Renderer renderer;
    Image cell;
    BorderWatch borders(smoke);
    const int cells = options.columns * options.rows;
    sheet.resize(output.width * options.columns, output.height * options.rows);
    for (int number = 0; number < cells; ++number) {
        const Result<std::shared_ptr<const Frame>> frame = simulator.frame(frameOfCell(options, number), stop, progress);
        if (!frame) {
            return frame.error();
        }
        if (Status status = renderer.render(*frame.value(), smoke, output.width, output.height, cell, stop); !status) {
            return status.error();
        }
        borders.look(cell, *frame.value(), renderer.appearance());
        place(cell, sheet, number % options.columns * cell.width, number / options.columns * cell.height);
        progress(Work::Frames, number + 1, cells);
    }
    borders.tell(flipbook);
    return Done{};
}

} // namespace

int frameOfCell(const FlipbookOptions& options, int cell)
{
    const std::int64_t index = static_cast<std::int64_t>(cell) * options.frames.count() / (options.columns * options.rows);
    return options.frames.at(static_cast<int>(index));
}

std::filesystem::path descriptionOf(const std::filesystem::path& picture)
{
    return std::filesystem::path(picture).replace_extension(".flipbook.json");
}

Result<Flipbook> renderFlipbook(const Effect& effect, const FlipbookOptions& options, const Progress& progress, const std::stop_token& stop)
{
    if (Status status = check(effect, options); !status) {
        return status.error();
    }
    Flipbook flipbook;
    flipbook.picture = withEnding(options.output, fileEnding(options.format));
    flipbook.description = descriptionOf(flipbook.picture);
    const double frames = static_cast<double>(options.frames.count()) * options.frames.step;
    flipbook.cellsPerSecond = options.columns * options.rows * static_cast<double>(effect.timeline.frameRate) / frames;
    if (Status status = makeFolderOf(flipbook.picture); !status) {
        return status.error();
    }

    Image sheet;
    if (Status status = renderCells(effect, options, sheet, flipbook, progress, stop); !status) {
        return status.error();
    }
    const Result<std::vector<std::byte>> bytes = encodeSheet(sheet, effect.output, options.format, effect.output.width, effect.output.height);
    if (!bytes) {
        Error error = bytes.error();
        error.place = flipbook.picture.string();
        return error;
    }
    const std::string description = describe(effect, options, flipbook);
    if (Status status = writePairAtomically({flipbook.picture, bytes.value()}, {flipbook.description, std::as_bytes(std::span(description))}); !status) {
        return status.error();
    }
    return flipbook;
}

} // namespace fumage
