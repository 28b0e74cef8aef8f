#include "core/export/bleed.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <vector>

#include <glm/vec4.hpp>

namespace fumage {

namespace {

/// Colours times alpha, and alpha; of pixels or of blocks of them.
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
    [[nodiscard]] const glm::vec4& at(int x, int y) const { return blocks[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)]; }
    [[nodiscard]] glm::vec4& at(int x, int y) { return blocks[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)]; }
};

Level halved(const Level& fine)
{
    Level coarse((fine.width + 1) / 2, (fine.height + 1) / 2);
    for (int y = 0; y < fine.height; ++y) {
        for (int x = 0; x < fine.width; ++x) {
            coarse.at(x / 2, y / 2) += fine.at(x, y);
        }
    }
    return coarse;
}

/// Of the eight pixels around one: what bilinear filtering mixes with it.
glm::vec4 aroundOf(const Level& level, int x, int y)
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
void bleedCell(EncodedImage<Channel>& image, int left, int top, int width, int height)
{
    const auto pixel = [&](int x, int y) { return image.pixels.data() + (static_cast<std::size_t>(top + y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(left + x)) * 4; };
    std::vector<Level> levels;
    levels.emplace_back(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const Channel* p = pixel(x, y);
            const auto alpha = static_cast<float>(p[3]);
            levels[0].at(x, y) = {alpha * static_cast<float>(p[0]), alpha * static_cast<float>(p[1]), alpha * static_cast<float>(p[2]), alpha};
        }
    }
    while (levels.back().width > 1 || levels.back().height > 1) {
        levels.push_back(halved(levels.back()));
    }
    if (levels.back().at(0, 0).w <= 0.0F) {
        return;
    }
    const Level seen = levels[0];
    for (std::size_t level = levels.size() - 1; level > 0; --level) {
        const Level& coarse = levels[level];
        Level& fine = levels[level - 1];
        for (int y = 0; y < fine.height; ++y) {
            for (int x = 0; x < fine.width; ++x) {
                if (fine.at(x, y).w <= 0.0F) {
                    fine.at(x, y) = coarse.at(x / 2, y / 2);
                }
            }
        }
    }
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            Channel* p = pixel(x, y);
            if (p[3] == 0) {
                const glm::vec4 near = aroundOf(seen, x, y);
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
    const int columns = image.width / cellWidth;
    const int rows = image.height / cellHeight;
    parallelFor(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), [&](std::size_t cell) {
        const auto number = static_cast<int>(cell);
        bleedCell(image, number % columns * cellWidth, number / columns * cellHeight, cellWidth, cellHeight);
    });
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
