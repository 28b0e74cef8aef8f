#include "core/export/spread.h"

#include "core/export/pyramid.h"
#include "core/export/sheet_grid.h"

#include <algorithm>
#include <vector>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace fumage {

namespace {

/// Straight channels of a level; of a pixel or block without smoke what is around it.
using Channels = std::vector<glm::vec3>;

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
    const auto row = [&](int v) { return 0.75F * channels[level.index(left, v)] + 0.25F * channels[level.index(right, v)]; };
    return 0.75F * row(top) + 0.25F * row(bottom);
}

Channels channelsOf(const PyramidLevel& level, const PyramidLevel* coarse, const Channels& coarseChannels, float enough)
{
    Channels out(level.blocks.size());
    for (int y = 0; y < level.height; ++y) {
        for (int x = 0; x < level.width; ++x) {
            const std::size_t i = level.index(x, y);
            const glm::vec4& block = level.blocks[i];
            const glm::vec3 own = block.w > 0.0F ? glm::vec3(block) / block.w : glm::vec3(0.0F);
            const float trusted = coarse == nullptr ? 1.0F : std::min(1.0F, block.w / enough);
            out[i] = trusted >= 1.0F ? own : trusted * own + (1.0F - trusted) * bilinear(*coarse, coarseChannels, x, y);
        }
    }
    return out;
}

void straightenCell(const Image& from, const SheetCell& cell, float enough, Image& to)
{
    const std::vector<PyramidLevel> levels = pyramidOf(cell.width, cell.height, [&](int x, int y) { return from.at(cell.left + x, cell.top + y); });
    Channels channels;
    for (std::size_t level = levels.size(); level-- > 0;) {
        channels = channelsOf(levels[level], level + 1 < levels.size() ? &levels[level + 1] : nullptr, channels, enough);
    }
    for (int y = 0; y < cell.height; ++y) {
        float* pixel = to.row(cell.top + y) + static_cast<std::size_t>(cell.left) * 4;
        for (int x = 0; x < cell.width; ++x, pixel += 4) {
            const std::size_t i = levels[0].index(x, y);
            std::copy_n(&channels[i].x, 3, pixel);
            pixel[3] = levels[0].blocks[i].w;
        }
    }
}

} // namespace

Image straightened(const Image& image, int cellWidth, int cellHeight, float enough)
{
    Image out;
    out.resize(image.width, image.height);
    forSheetCells(image.width, image.height, cellWidth, cellHeight, [&](const SheetCell& cell) { straightenCell(image, cell, enough, out); });
    return out;
}

} // namespace fumage
