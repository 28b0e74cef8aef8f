#pragma once

#include <vector>

#include <glm/vec4.hpp>

namespace fumage {

/// Channels times alpha, and alpha; of pixels or of blocks of them.
struct PyramidLevel {
    int width = 0;
    int height = 0;
    std::vector<glm::vec4> blocks;

    PyramidLevel(int w, int h)
        : width(w)
        , height(h)
        , blocks(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), glm::vec4(0.0F))
    {
    }
    [[nodiscard]] std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x); }
    [[nodiscard]] const glm::vec4& at(int x, int y) const { return blocks[index(x, y)]; }
    [[nodiscard]] glm::vec4& at(int x, int y) { return blocks[index(x, y)]; }
};

/// Pixels, and sums of blocks of twice the size, up to one block: what pull and push go down again.
/// @param pixel called with (x, y)
template <class Pixel>
[[nodiscard]] std::vector<PyramidLevel> pyramidOf(int width, int height, const Pixel& pixel)
{
    std::vector<PyramidLevel> levels;
    levels.emplace_back(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            levels[0].at(x, y) = pixel(x, y);
        }
    }
    while (levels.back().width > 1 || levels.back().height > 1) {
        const PyramidLevel& fine = levels.back();
        PyramidLevel coarse((fine.width + 1) / 2, (fine.height + 1) / 2);
        for (int y = 0; y < fine.height; ++y) {
            for (int x = 0; x < fine.width; ++x) {
                coarse.at(x / 2, y / 2) += fine.at(x, y);
            }
        }
        levels.push_back(std::move(coarse));
    }
    return levels;
}

} // namespace fumage
