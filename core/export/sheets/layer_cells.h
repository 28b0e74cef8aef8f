#pragma once

#include "core/export/pass_picture.h"
#include "core/export/sheets/flipbook_options.h"
#include "core/rendering/layer_pictures.h"
#include "core/rendering/pass_renderer.h"

#include <vector>

namespace fumage {

/// Fills a sheet a layer, cell by cell, all on one grid: alone, with all passes, or as contributions.
class LayerCells {
public:
    /// @param layers as many as are drawn
    LayerCells(LayerOutput output, std::size_t layers)
        : m_output(output)
        , m_sheets(layers)
    {
    }

    /// Takes the next cell in.
    /// @param grid     of all sheets
    /// @param cell     the picture of all layers
    /// @param renderer that has just made it, supersample times larger
    /// @error those of PassRenderer and LayerPictures
    [[nodiscard]] Status take(const SheetGrid& grid, const PassImages& cell, int supersample, PassRenderer& renderer,
        const std::stop_token& stop);

    /// The sheets, in the order of the layers.
    [[nodiscard]] std::vector<PassSheet>& sheets() { return m_sheets; }

private:
    void begin(const SheetGrid& grid, const PassImages& cell);
    [[nodiscard]] Status takeAlone(const SheetGrid& grid, PassRenderer& renderer, const std::stop_token& stop);

    LayerOutput m_output;
    int m_next = 0;
    std::vector<PassSheet> m_sheets;
    LayerPictures m_pictures;
    PassImages m_alone;
};

} // namespace fumage
