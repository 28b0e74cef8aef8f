#include "core/export/sheets/flipbook_files.h"
#include "core/export/sheets/sheet_playback.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace fumage {

glm::vec4 SheetPlayback::moved(const SheetCell& cell, int x, int y, float way) const
{
    const float* vector = m_motion.values.data()
        + (static_cast<std::size_t>(cell.top + y) * static_cast<std::size_t>(m_motion.width)
              + static_cast<std::size_t>(cell.left + x))
            * 3;
    const float right = vector[0] * m_scale * static_cast<float>(cell.width) * way;
    const float up = vector[1] * m_scale * static_cast<float>(cell.height) * way;
    return shownBetween(
        m_sheet.targets.of(PassTarget::Colour), cell, static_cast<float>(x) + right, static_cast<float>(y) - up);
}

glm::vec4 SheetPlayback::pixel(int one, int other, float f, int x, int y, CellBlending blending) const
{
    const SheetCell from = m_sheet.grid.cell(one);
    const SheetCell to = m_sheet.grid.cell(other);
    if (blending == CellBlending::Motion) {
        return glm::mix(moved(from, x, y, -f), moved(to, x, y, 1.0F - f), f);
    }
    const Image& colour = m_sheet.targets.of(PassTarget::Colour);
    const glm::vec4 here = shown(colour.at(from.left + x, from.top + y));
    return blending == CellBlending::None ? here : glm::mix(here, shown(colour.at(to.left + x, to.top + y)), f);
}

void SheetPlayback::picture(double cell, bool loops, CellBlending blending, Image& out) const
{
    const SheetGrid& grid = m_sheet.grid;
    const double last = grid.cells - 1;
    const double at = loops ? std::fmod(cell, grid.cells) : std::min(cell, last);
    const int one = std::min(static_cast<int>(at), grid.cells - 1);
    const int other = loops ? (one + 1) % grid.cells : std::min(one + 1, grid.cells - 1);
    const auto f = static_cast<float>(at - one);
    const CellBlending possible = blending == CellBlending::Motion && !hasMotion() ? CellBlending::CrossFade : blending;
    out.resize(grid.cellWidth, grid.cellHeight);
    parallelFor(static_cast<std::size_t>(grid.cellHeight), [&](std::size_t row) {
        const int y = static_cast<int>(row);
        float* to = out.row(y);
        for (int x = 0; x < grid.cellWidth; ++x, to += 4) {
            const glm::vec4 colour = pixel(one, other, f, x, y, possible);
            for (int channel = 0; channel < 4; ++channel) {
                to[channel] = colour[channel];
            }
        }
    });
}

SheetMemory memoryOf(std::int64_t width, std::int64_t height, int pictures, ImageFormat format)
{
    constexpr std::int64_t kBlock = 4; // pixels along an edge
    const std::int64_t blocks = (width + kBlock - 1) / kBlock * ((height + kBlock - 1) / kBlock);
    const std::int64_t channel = format == ImageFormat::ExrFloat ? 4
        : holdsFloats(format) || format == ImageFormat::Png16    ? 2
                                                                 : 1;
    return {blocks * kBlock * kBlock * pictures, width * height * 4 * channel * pictures};
}

SheetMemory memoryOf(const FlipbookOptions& options, int cellWidth, int cellHeight, std::size_t layers)
{
    constexpr std::size_t kChannels = 4;
    const std::int64_t width = static_cast<std::int64_t>(cellWidth) * options.columns;
    const std::int64_t height = static_cast<std::int64_t>(cellHeight) * options.rows;
    std::size_t pictures = picturesOf(options).size() - options.packs.size();
    if (options.passes.has(Pass::LayerMasks)) {
        pictures += (layers + kChannels - 1) / kChannels - 1;
    }
    SheetMemory sum = memoryOf(width, height, static_cast<int>(pictures), options.format);
    for (const PackedPicture& pack : options.packs) {
        const SheetMemory one = memoryOf(width / pack.divisor, height / pack.divisor, 1, options.format);
        sum.compressed += one.compressed;
        sum.plain += one.plain;
    }
    const auto sheets = static_cast<std::int64_t>(isDivided(options) ? layers : 1);
    sum.compressed *= sheets;
    sum.plain *= sheets;
    return sum;
}

} // namespace fumage
