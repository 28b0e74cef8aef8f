#include "core/export/spread.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <vector>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace fumage {

namespace {

/// Channels times alpha, and alpha; of pixels or of blocks of them.
struct Level {
    int width = 0;
    int height = 0;
    std::vector<glm::vec4> blocks;

    Level(int w, int h)
        : width(w)
        , height(h)
        , blocks(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), glm::vec4(0.0F))
    {
    }
    [[nodiscard]] std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x); }
};

/// Straight channels of a level; of a pixel or block without smoke what is around it.
using Channels = std::vector<glm::vec3>;

Level halved(const Level& fine)
{
    Level coarse((fine.width + 1) / 2, (fine.height + 1) / 2);
    for (int y = 0; y < fine.height; ++y) {
        for (int x = 0; x < fine.width; ++x) {
            coarse.blocks[coarse.index(x / 2, y / 2)] += fine.blocks[fine.index(x, y)];
        }
    }
    return coarse;
}

/// Between the centres of blocks twice as large.
glm::vec3 bilinear(const Level& level, const Channels& channels, int x, int y)
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

Channels channelsOf(const Level& level, const Level* coarse, const Channels& coarseChannels, float enough)
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

void straightenCell(const Image& from, int left, int top, int width, int height, float enough, Image& to)
{
    std::vector<Level> levels;
    levels.emplace_back(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            levels[0].blocks[levels[0].index(x, y)] = from.at(left + x, top + y);
        }
    }
    while (levels.back().width > 1 || levels.back().height > 1) {
        levels.push_back(halved(levels.back()));
    }
    Channels channels;
    for (std::size_t level = levels.size(); level-- > 0;) {
        channels = channelsOf(levels[level], level + 1 < levels.size() ? &levels[level + 1] : nullptr, channels, enough);
    }
    for (int y = 0; y < height; ++y) {
        float* pixel = to.row(top + y) + static_cast<std::size_t>(left) * 4;
        for (int x = 0; x < width; ++x, pixel += 4) {
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
    const int columns = image.width / cellWidth;
    const int rows = image.height / cellHeight;
    parallelFor(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), [&](std::size_t cell) {
        const auto number = static_cast<int>(cell);
        straightenCell(image, number % columns * cellWidth, number / columns * cellHeight, cellWidth, cellHeight, enough, out);
    });
    return out;
}

} // namespace fumage
