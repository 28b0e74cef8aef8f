#include "core/export/sheets/motion_fill.h"

#include "core/base/parallel.h"
#include "core/export/sheets/pyramid.h"
#include "core/export/sheets/sheet_grid.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace fumage {

namespace {

/// Straight channels of a level; of a pixel or block without smoke what is around it.
using Channels = std::vector<glm::vec3>;

/// What a thread works in, cell after cell.
struct Room {
    std::vector<PyramidLevel> levels;
    Channels channels;
    Channels coarser;
};

/// Between the centres of blocks twice as large.
glm::vec3 bilinear(const PyramidLevel& level, const Channels& channels, int x, int y)
{
    const auto mixed = [](int at, int count, int& low, int& high) {
        // The nearer block has three quarters; beyond the outermost centres there is one.
        low = at / 2;
        high = std::clamp(at % 2 == 0 ? low - 1 : low + 1, 0, count - 1);
    };
    int left = 0;
    int right = 0;
    int top = 0;
    int bottom = 0;
    mixed(x, level.width, left, right);
    mixed(y, level.height, top, bottom);
    const auto row = [&](int v) {
        return 0.75F * channels[level.index(left, v)] + 0.25F * channels[level.index(right, v)];
    };
    return 0.75F * row(top) + 0.25F * row(bottom);
}

void findChannels(
    const PyramidLevel& level, const PyramidLevel* coarse, const Channels& coarseChannels, float enough, Channels& out)
{
    out.resize(level.blocks.size());
    for (int y = 0; y < level.height; ++y) {
        for (int x = 0; x < level.width; ++x) {
            const std::size_t i = level.index(x, y);
            const glm::vec4& block = level.blocks[i];
            const glm::vec3 own = block.w > 0.0F ? glm::vec3(block) / block.w : glm::vec3(0.0F);
            const float trusted = coarse == nullptr ? 1.0F : std::min(1.0F, block.w / enough);
            out[i] = trusted >= 1.0F ? own : trusted * own + (1.0F - trusted) * bilinear(*coarse, coarseChannels, x, y);
        }
    }
}

void straightenCell(Image& image, const SheetCell& cell, float enough, Room& room)
{
    std::vector<PyramidLevel>& levels = room.levels;
    buildPyramid(
        cell.width, cell.height, [&](int x, int y) { return image.at(cell.left + x, cell.top + y); }, levels);
    for (std::size_t level = levels.size(); level-- > 0;) {
        std::swap(room.channels, room.coarser);
        findChannels(levels[level], level + 1 < levels.size() ? &levels[level + 1] : nullptr, room.coarser, enough,
            room.channels);
    }
    const Channels& channels = room.channels;
    for (int y = 0; y < cell.height; ++y) {
        float* pixel = image.row(cell.top + y) + static_cast<std::size_t>(cell.left) * 4;
        for (int x = 0; x < cell.width; ++x, pixel += 4) {
            const std::size_t i = levels[0].index(x, y);
            std::copy_n(&channels[i].x, 3, pixel);
            pixel[3] = levels[0].blocks[i].w;
        }
    }
}

} // namespace

void straighten(Image& image, int cellWidth, int cellHeight, float enough)
{
    PerThread<Room> rooms;
    forSheetCells(image.width, image.height, cellWidth, cellHeight,
        [&](const SheetCell& cell) { straightenCell(image, cell, enough, rooms.local()); });
}

} // namespace fumage
