#include "core/export/sheets/bleed.h"

#include "core/base/parallel.h"
#include "core/export/sheets/pyramid.h"
#include "core/export/sheets/sheet_grid.h"

#include <algorithm>
#include <vector>

namespace fumage {

namespace {

/// What a thread works in, cell after cell.
struct Room {
    std::vector<PyramidLevel> levels;
    PyramidLevel seen;
};

/// Of the eight pixels around one: what bilinear filtering mixes with it.
glm::vec4 aroundOf(const PyramidLevel& level, int x, int y)
{
    glm::vec4 sum(0.0F);
    for (int j = std::max(0, y - 1); j <= std::min(level.height - 1, y + 1); ++j) {
        for (int i = std::max(0, x - 1); i <= std::min(level.width - 1, x + 1); ++i) {
            sum += level.at(i, j);
        }
    }
    return sum;
}

template <class Channel>
void bleedCell(EncodedImage<Channel>& image, const SheetCell& cell, Room& room)
{
    const auto pixel = [&](int x, int y) {
        return image.pixels.data()
            + (static_cast<std::size_t>(cell.top + y) * static_cast<std::size_t>(image.width)
                  + static_cast<std::size_t>(cell.left + x))
            * 4;
    };
    const auto weighted = [&](int x, int y) {
        const Channel* p = pixel(x, y);
        const auto alpha = static_cast<float>(p[3]);
        return glm::vec4(alpha * static_cast<float>(p[0]), alpha * static_cast<float>(p[1]),
            alpha * static_cast<float>(p[2]), alpha);
    };
    std::vector<PyramidLevel>& levels = room.levels;
    buildPyramid(cell.width, cell.height, weighted, levels);
    if (levels.back().at(0, 0).w <= 0.0F) {
        return;
    }
    room.seen = levels[0];
    for (std::size_t level = levels.size() - 1; level > 0; --level) {
        const PyramidLevel& coarse = levels[level];
        PyramidLevel& fine = levels[level - 1];
        for (int y = 0; y < fine.height; ++y) {
            for (int x = 0; x < fine.width; ++x) {
                if (fine.at(x, y).w <= 0.0F) {
                    fine.at(x, y) = coarse.at(x / 2, y / 2);
                }
            }
        }
    }
    for (int y = 0; y < cell.height; ++y) {
        for (int x = 0; x < cell.width; ++x) {
            Channel* p = pixel(x, y);
            if (p[3] == 0) {
                const glm::vec4 near = aroundOf(room.seen, x, y);
                const glm::vec4 colour = near.w > 0.0F ? near : levels[0].at(x, y);
                for (int channel = 0; channel < 3; ++channel) {
                    p[channel] = static_cast<Channel>(static_cast<int>(colour[channel] / colour.w + 0.5F));
                }
            }
        }
    }
}

template <class Channel>
void bleedCells(EncodedImage<Channel>& image, int cellWidth, int cellHeight)
{
    PerThread<Room> rooms;
    forSheetCells(image.width, image.height, cellWidth, cellHeight,
        [&](const SheetCell& cell) { bleedCell(image, cell, rooms.local()); });
}

} // namespace

void bleedColours(EncodedImage<std::uint8_t>& image, int cellWidth, int cellHeight)
{
    bleedCells(image, cellWidth, cellHeight);
}

void bleedColours(EncodedImage<std::uint16_t>& image, int cellWidth, int cellHeight)
{
    bleedCells(image, cellWidth, cellHeight);
}

} // namespace fumage
