#pragma once

#include <algorithm>
#include <vector>

#include <glm/vec4.hpp>

namespace fumage {

/// Channels times alpha, and alpha; of pixels or of blocks of them.
struct PyramidLevel {
    int width = 0;
    int height = 0;
    std::vector<glm::vec4> blocks;

    /// Of that size, and without smoke; keeps its memory.
    void clear(int w, int h)
    {
        width = w;
        height = h;
        blocks.assign(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), glm::vec4(0.0F));
    }
    [[nodiscard]] std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    [[nodiscard]] const glm::vec4& at(int x, int y) const { return blocks[index(x, y)]; }
    [[nodiscard]] glm::vec4& at(int x, int y) { return blocks[index(x, y)]; }
};

/// Pixels, and sums of blocks of twice the size, up to one block: what pull and push go down again.
/// @param pixel called with (x, y)
/// @param levels made anew; what they had of memory is used again
template <class Pixel>
void buildPyramid(int width, int height, const Pixel& pixel, std::vector<PyramidLevel>& levels)
{
    levels.resize(std::max<std::size_t>(1, levels.size()));
    levels[0].clear(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            levels[0].at(x, y) = pixel(x, y);
        }
    }
    std::size_t count = 1;
    for (; levels[count - 1].width > 1 || levels[count - 1].height > 1; ++count) {
        levels.resize(std::max(count + 1, levels.size()));
        const PyramidLevel& fine = levels[count - 1];
        PyramidLevel& coarse = levels[count];
        coarse.clear((fine.width + 1) / 2, (fine.height + 1) / 2);
        for (int y = 0; y < fine.height; ++y) {
            for (int x = 0; x < fine.width; ++x) {
                coarse.at(x / 2, y / 2) += fine.at(x, y);
            }
        }
    }
    levels.resize(count);
}

} // namespace fumage
