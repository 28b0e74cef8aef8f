#include "core/export/sheets/motion_refine.h"

#include "core/base/math.h"
#include "core/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace fumage {

namespace {

using Field = std::vector<float>; ///< a number for each pixel of a cell

/// Pixels of a cell, from the first to before the last.
struct Area {
    int left = 0;
    int top = 0;
    int right = 0;
    int bottom = 0;

    [[nodiscard]] bool isEmpty() const { return left >= right || top >= bottom; }
    /// Some pixels more on every side, as far as the cell goes.
    [[nodiscard]] Area grown(int by, const SheetGrid& grid) const
    {
        return isEmpty() ? Area{}
                         : Area{std::max(0, left - by), std::max(0, top - by), std::min(grid.cellWidth, right + by),
                             std::min(grid.cellHeight, bottom + by)};
    }
};

Area around(const Area& a, const Area& b)
{
    return a.isEmpty() ? b
        : b.isEmpty()  ? a
                       : Area{std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right),
                          std::max(a.bottom, b.bottom)};
}

/// What a thread works in, pair after pair of cells: how much they differ where nothing moves, by half the vectors, and
/// by the whole.
struct Room {
    Field none;
    Field half;
    Field whole;
};

/// The cells of a sheet, which are looked at between pixels.
class Cells {
public:
    Cells(const Image& colour, const Image& motion, const SheetGrid& grid)
        : m_colour(colour)
        , m_motion(motion)
        , m_grid(grid)
    {
    }

    /// Vector of a pixel, in pixels, y down.
    [[nodiscard]] glm::vec2 vector(int cell, int x, int y) const
    {
        const SheetCell at = m_grid.cell(cell);
        const float* p = m_motion.row(at.top + y) + static_cast<std::size_t>(at.left + x) * 4;
        return {p[0] * static_cast<float>(m_grid.cellWidth), -p[1] * static_cast<float>(m_grid.cellHeight)};
    }
    /// The colour of a pixel, as it is shown.
    [[nodiscard]] glm::vec4 colour(int cell, int x, int y) const
    {
        const SheetCell at = m_grid.cell(cell);
        return shown(m_colour.at(at.left + x, at.top + y));
    }
    /// That of a place in pixels from the first.
    [[nodiscard]] glm::vec4 colour(int cell, glm::vec2 place) const
    {
        return shownBetween(m_colour, m_grid.cell(cell), place.x, place.y);
    }

    /// Where half a vector from a pixel may lead to smoke; elsewhere all that is looked at is exactly nothing.
    [[nodiscard]] Area reach(int cell) const
    {
        const SheetCell at = m_grid.cell(cell);
        Area smoke{at.width, at.height, 0, 0};
        float longest = 0.0F;
        for (int y = 0; y < at.height; ++y) {
            for (int x = 0; x < at.width; ++x) {
                const glm::vec2 way = vector(cell, x, y);
                longest = std::max({longest, std::abs(way.x), std::abs(way.y)});
                if (m_colour.at(at.left + x, at.top + y) != glm::vec4(0.0F)) {
                    smoke = {std::min(smoke.left, x), std::min(smoke.top, y), std::max(smoke.right, x + 1),
                        std::max(smoke.bottom, y + 1)};
                }
            }
        }
        const auto pixels =
            static_cast<int>(std::min(0.5F * longest, static_cast<float>(std::max(at.width, at.height))));
        return smoke.grown(
            pixels + 2, m_grid); // one for the part of a pixel, one for the neighbour that it is mixed with
    }

private:
    const Image& m_colour;
    const Image& m_motion;
    const SheetGrid& m_grid;
};

constexpr int kBlur = 2; // pixels on either side

/// Means of the pixels around each along one axis.
/// @param lines,pixels  from the first to before the last of those that may be anything but nothing
void blurAlong(Field& field, std::array<int, 2> lines, std::array<int, 2> pixels, int count, int lineStep, int step)
{
    std::vector<float> line(static_cast<std::size_t>(count));
    for (int i = lines[0]; i < lines[1]; ++i) {
        const auto at = [&](int j) -> float& {
            return field[static_cast<std::size_t>(i) * static_cast<std::size_t>(lineStep)
                + static_cast<std::size_t>(j) * static_cast<std::size_t>(step)];
        };
        for (int j = pixels[0]; j < pixels[1]; ++j) {
            const int first = std::max(0, j - kBlur);
            const int last = std::min(count - 1, j + kBlur);
            float sum = 0.0F;
            for (int k = first; k <= last; ++k) {
                sum += at(k);
            }
            line[static_cast<std::size_t>(j)] = sum / static_cast<float>(last - first + 1);
        }
        for (int j = pixels[0]; j < pixels[1]; ++j) {
            at(j) = line[static_cast<std::size_t>(j)];
        }
    }
}

/// Two cells, one shown after the other.
struct CellPair {
    int one = 0;
    int other = 0;
};

/// How much two cells differ in the middle between them, around each pixel, where vectors are a share of what they are.
/// @param area where they may differ
void findMismatch(
    const Cells& cells, const CellPair& pair, const SheetGrid& grid, const Area& area, float share, Field& out)
{
    out.assign(static_cast<std::size_t>(grid.cellWidth) * static_cast<std::size_t>(grid.cellHeight), 0.0F);
    const bool moves = share > 0.0F;
    for (int y = area.top; y < area.bottom; ++y) {
        for (int x = area.left; x < area.right; ++x) {
            const glm::vec2 place(static_cast<float>(x), static_cast<float>(y));
            const glm::vec4 from = moves ? cells.colour(pair.one, place - 0.5F * share * cells.vector(pair.one, x, y))
                                         : cells.colour(pair.one, x, y);
            const glm::vec4 to = moves ? cells.colour(pair.other, place + 0.5F * share * cells.vector(pair.other, x, y))
                                       : cells.colour(pair.other, x, y);
            out[static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.cellWidth) + static_cast<std::size_t>(x)] =
                glm::dot(from - to, from - to);
        }
    }
    constexpr int kTimes = 2;
    const Area blurred = area.grown(kTimes * kBlur, grid);
    for (int time = 0; time < kTimes; ++time) {
        blurAlong(out, {blurred.top, blurred.bottom}, {blurred.left, blurred.right}, grid.cellWidth, grid.cellWidth, 1);
        blurAlong(
            out, {blurred.left, blurred.right}, {blurred.top, blurred.bottom}, grid.cellHeight, 1, grid.cellWidth);
    }
}

/// The share of the vectors at which two cells differ least, for each pixel.
Field bestShares(const Cells& cells, const CellPair& pair, const SheetGrid& grid, const Area& area, Room& room)
{
    const auto& [none, half, whole] = room;
    findMismatch(cells, pair, grid, area, 0.0F, room.none);
    findMismatch(cells, pair, grid, area, 0.5F, room.half);
    findMismatch(cells, pair, grid, area, 1.0F, room.whole);
    Field out(none.size());
    for (std::size_t i = 0; i < out.size(); ++i) {
        constexpr float kNothing = 1e-9F; // to be seen
        const float bend = 2.0F * (none[i] + whole[i] - 2.0F * half[i]);
        const float slope = 4.0F * half[i] - 3.0F * none[i] - whole[i];
        const bool flat = std::max({none[i], half[i], whole[i]}) < kNothing;
        out[i] = flat            ? 1.0F
            : bend > kNothing    ? std::clamp(-0.5F * slope / bend, 0.0F, 1.0F)
            : whole[i] < none[i] ? 1.0F
                                 : 0.0F;
    }
    return out;
}

/// 0 for what is blurred more than it gains, 1 for what goes as far as a pixel each from both sides.
float beyondAPixel(glm::vec2 vector)
{
    constexpr float kBlurred = 0.75F; // pixels; measured: none of the built-in presets is then worse than a cross-fade
    constexpr float kWhole = 2.0F;
    return smoothStep(std::clamp((std::sqrt(glm::dot(vector, vector)) - kBlurred) / (kWhole - kBlurred), 0.0F, 1.0F));
}

} // namespace

void refineMotion(const Image& colour, const SheetGrid& grid, Image& motion)
{
    if (grid.cells < 2) {
        return;
    }
    const Cells cells(colour, motion, grid);
    const auto count = static_cast<std::size_t>(grid.cells);
    std::vector<Field> shares(grid.loops ? count : count - 1); // of each cell and the one after it
    std::vector<Area> reaches(count);
    parallelFor(reaches.size(), [&](std::size_t cell) { reaches[cell] = cells.reach(static_cast<int>(cell)); });
    PerThread<Room> rooms;
    parallelFor(shares.size(), [&](std::size_t cell) {
        const std::size_t next = (cell + 1) % count;
        const CellPair pair{static_cast<int>(cell), static_cast<int>(next)};
        shares[cell] = bestShares(cells, pair, grid, around(reaches[cell], reaches[next]), rooms.local());
    });
    parallelFor(count, [&](std::size_t cell) {
        const Field& before = shares[cell > 0 ? cell - 1 : grid.loops ? count - 1 : 0];
        const Field& after = shares[std::min(cell, shares.size() - 1)];
        const auto number = static_cast<int>(cell);
        const SheetCell place = grid.cell(number);
        std::size_t i = 0;
        for (int y = 0; y < grid.cellHeight; ++y) {
            float* pixel = motion.row(place.top + y) + static_cast<std::size_t>(place.left) * 4;
            for (int x = 0; x < grid.cellWidth; ++x, ++i, pixel += 4) {
                const float share = 0.5F * (before[i] + after[i]);
                const float kept = share * beyondAPixel(share * cells.vector(number, x, y));
                pixel[0] *= kept;
                pixel[1] *= kept;
            }
        }
    });
}

} // namespace fumage
