#include "core/export/sheets/sheet_metrics.h"

#include "core/base/math.h"
#include "core/export/sheets/cell_frames.h"
#include "core/export/difference.h"
#include "core/export/sheets/sheet.h"
#include "core/export/sheets/sheet_playback.h"
#include "core/rendering/view_transform.h"
#include "core/rendering/scene_renderer.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

namespace fumage {

namespace {

constexpr int kDirections = 20;

/// Directions on a spiral from pole to pole, each with as much of the sphere around it.
std::array<glm::vec3, kDirections> lightDirections()
{
    std::array<glm::vec3, kDirections> out;
    const float golden = kPi * (3.0F - std::sqrt(5.0F));
    for (std::size_t i = 0; i < out.size(); ++i) {
        const float y = 1.0F - (2.0F * static_cast<float>(i) + 1.0F) / static_cast<float>(kDirections);
        const float across = std::sqrt(1.0F - y * y);
        const float turn = std::fmod(golden * static_cast<float>(i), kTau);
        out[i] = {across * portableCos(turn), y, across * portableSin(turn)};
    }
    return out;
}

/// White smoke under one white light from a direction of the camera's frame, and no other. Flames are as clear as they
/// are, but give next to nothing: without any glow they would be opaque smoke, which no map shows.
Effect litFrom(const Effect& effect, const View& view, const glm::vec3& towards)
{
    Effect lit = effect;
    lit.look.colour = glm::vec3(1.0F);
    lit.look.colourGradient = Gradient{{0.0F, glm::vec3(1.0F)}};
    lit.light.colour = glm::vec3(1.0F);
    lit.light.intensity = 1.0F;
    lit.light.ambient = 0.0F;
    constexpr float kFaintest = 1e-6F;
    lit.glow.emission = std::min(effect.glow.emission, kFaintest);
    lit.glow.fireLight = 0.0F;
    lit.light.direction = -(view.right * towards.x + view.up * towards.y + view.forward * towards.z);
    lit.output.background = Background::Transparent;
    return lit;
}

/// Relit from Unity's maps: the premultiplied light of a pixel.
float relit(const DataImage& a, const DataImage& b, std::size_t pixel, const glm::vec3& towards, float scale)
{
    float sum = 0.0F;
    for (int axis = 0; axis < 3; ++axis) {
        const RawArray<float>& map = towards[axis] >= 0.0F ? a.values : b.values;
        sum += towards[axis] * towards[axis] * map[pixel * 4 + static_cast<std::size_t>(axis)];
    }
    return sum * scale * a.values[pixel * 4 + 3];
}

Status scoreSixWay(const Scene& scene, const FlipbookOptions& options, const PassSheet& sheet,
    const std::vector<int>& frames, int lit, SceneRenderer& smoke, SheetScore& score, const std::stop_token& stop)
{
    const PassPictures pictures(sheet, {Pass::SixWayA, Pass::SixWayB}, {});
    const PassScales& scales = pictures.scales();
    const DataImage a = stored(pictures.picture(Pass::SixWayA), options.format);
    const DataImage b = stored(pictures.picture(Pass::SixWayB), options.format);
    const std::array<glm::vec3, kDirections> directions = lightDirections();
    std::array<Difference, kDirections> differences;
    Renderer renderer;
    Image truth;
    for (int i = 0; i < lit; ++i) {
        const int number = static_cast<int>(
            (2 * static_cast<std::int64_t>(i) + 1) * static_cast<std::int64_t>(frames.size()) / (2 * lit));
        const Result<SceneFrame> frame = smoke.frame(frames[static_cast<std::size_t>(number)], stop);
        if (!frame) {
            return frame.error();
        }
        const View view = makeView(scene.atFrame(frames[static_cast<std::size_t>(number)]).camera,
            secondsOf(scene.timeline, frame.value().layers.front()->number), sheet.grid.cellWidth,
            sheet.grid.cellHeight);
        const SheetCell cell = sheet.grid.cell(number);
        for (std::size_t direction = 0; direction < kDirections; ++direction) {
            std::vector<SampledEffect> layers;
            for (const SampledEffect& layer : smoke.layers()) {
                const SampledEffect now = layer.atFrame(frame.value().layers.front()->number);
                layers.push_back(sampled(
                    litFrom(now, view, directions[direction]), now.tracks() != nullptr ? *now.tracks() : Tracks()));
            }
            if (Status status =
                    renderer.render(LayersAtFrame(frame.value(), layers), cell.width, cell.height, truth, stop);
                !status) {
                return status;
            }
            for (int y = 0; y < cell.height; ++y) {
                for (int x = 0; x < cell.width; ++x) {
                    const std::size_t pixel = static_cast<std::size_t>(cell.top + y) * static_cast<std::size_t>(a.width)
                        + static_cast<std::size_t>(cell.left + x);
                    differences[direction].add(
                        relit(a, b, pixel, directions[direction], scales.light), truth.at(x, y).r);
                }
            }
        }
    }
    Difference all;
    for (const Difference& each : differences) {
        all.add(each);
    }
    score.sixWay.scale = scales.light;
    score.sixWay.decibels = all.decibels();
    score.sixWay.worst =
        std::min_element(differences.begin(), differences.end(), [](const Difference& x, const Difference& y) {
            return x.decibels() < y.decibels();
        })->decibels();
    return Done{};
}

/// The middle between two cells as an engine shows it, with and without vectors, beside the frame that is there.
struct Between {
    Difference rebuilt;
    Difference faded;
    int count = 0;

    void compare(const SheetPlayback& playback, int cell, int next, float f, const Image& truth)
    {
        for (int y = 0; y < truth.height; ++y) {
            for (int x = 0; x < truth.width; ++x) {
                const glm::vec4 there = shown(truth.at(x, y));
                const glm::vec4 moved = playback.pixel(cell, next, f, x, y, CellBlending::Motion);
                const glm::vec4 mixed = playback.pixel(cell, next, f, x, y, CellBlending::CrossFade);
                for (int channel = 0; channel < 4; ++channel) {
                    rebuilt.add(moved[channel], there[channel]);
                    faded.add(mixed[channel], there[channel]);
                }
            }
        }
        ++count;
    }
};

Status scoreMotion(const Scene& scene, const FlipbookOptions& options, const PassSheet& sheet, const CellFrames& frames,
    SceneRenderer& renderer, SheetScore& score, const std::stop_token& stop)
{
    const PassPictures pictures(sheet, {Pass::Motion}, {});
    const SheetPlayback playback(
        sheet, stored(pictures.picture(Pass::Motion), options.format), pictures.scales().motion);
    Between between;
    Image truth;
    const std::vector<int>& numbers = frames.numbers;
    for (std::size_t i = 0; i + (frames.turn ? 0 : 1) < numbers.size(); ++i) {
        const std::size_t next = (i + 1) % numbers.size();
        const int there = numbers[next] + (next == 0 ? *frames.turn : 0);
        const int middle = (numbers[i] + there) / 2;
        if (middle == numbers[i]) {
            continue;
        }
        const int length = scene.timeline.length; // of a loop that may be played backwards through its seam
        if (Status status = renderer.render(middle < 0 ? middle % length + length : middle, sheet.grid.cellWidth,
                sheet.grid.cellHeight, truth, stop);
            !status) {
            return status;
        }
        const float f = static_cast<float>(middle - numbers[i]) / static_cast<float>(there - numbers[i]);
        between.compare(playback, static_cast<int>(i), static_cast<int>(next), f, truth);
    }
    score.motion = {between.rebuilt.decibels(), between.faded.decibels(), pictures.scales().motion, between.count};
    return Done{};
}

void scorePixels(const PassSheet& sheet, const Output& output, SheetScore& score)
{
    const float brightest = brightestShown(output);
    constexpr float kSeen = 0.5F / 255.0F;
    const Image& colour = sheet.targets.of(PassTarget::Colour);
    std::size_t smoke = 0;
    std::size_t clipped = 0;
    for (int number = 0; number < sheet.grid.cells; ++number) {
        const SheetCell cell = sheet.grid.cell(number);
        const std::size_t before = smoke;
        for (int y = 0; y < cell.height; ++y) {
            for (int x = 0; x < cell.width; ++x) {
                const glm::vec4 pixel = colour.at(cell.left + x, cell.top + y);
                const bool isBorder = x == 0 || y == 0 || x + 1 == cell.width || y + 1 == cell.height;
                score.edgeAlpha = isBorder ? std::max(score.edgeAlpha, pixel.a) : score.edgeAlpha;
                smoke += pixel.a >= kSeen ? 1U : 0U;
                clipped += pixel.a >= kSeen && std::max({pixel.r, pixel.g, pixel.b}) > brightest * pixel.a ? 1U : 0U;
            }
        }
        score.empty += smoke == before ? 1 : 0;
    }
    score.clipped = smoke > 0 ? static_cast<double>(clipped) / static_cast<double>(smoke) : 0.0;
}

} // namespace

Result<SheetScore> scoreSheet(const Scene& scene, const FlipbookOptions& options, int lit, const ExportTask& asked)
{
    const CellFrames frames = cellFramesOf(scene, options);
    Scene seen = scene;
    seen.output.background = Background::Transparent;
    PassSheet sheet;
    const ExportTask task = withShelf(asked); // one bake of the air for the sheet and for the truth
    if (Status status = renderSheet(
            seen, frames, options.columns, {Pass::Colour, Pass::SixWayA, Pass::SixWayB, Pass::Motion}, sheet, {}, task);
        !status) {
        return status.error();
    }
    SceneRenderer renderer(seen, task.shelf);
    SheetScore score;
    scorePixels(sheet, seen.output, score);
    if (Status status = scoreSixWay(seen, options, sheet, frames.numbers, lit, renderer, score, task.stop); !status) {
        return status.error();
    }
    if (Status status = scoreMotion(seen, options, sheet, frames, renderer, score, task.stop); !status) {
        return status.error();
    }
    return score;
}

} // namespace fumage
