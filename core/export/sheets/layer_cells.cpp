#include "core/export/sheets/layer_cells.h"

#include "core/export/sheets/sheet.h"

namespace fumage {

/// Makes room in all sheets for what cells are made of.
void LayerCells::begin(const SheetGrid& grid, const PassImages& cell)
{
    for (PassSheet& sheet : m_sheets) {
        sheet.grid = grid;
        for (std::size_t i = 0; i < kPassTargets; ++i) {
            if (cell.targets[i].width > 0) {
                makeRoom(grid, sheet.targets.targets[i]);
            }
        }
    }
}

Status LayerCells::takeAlone(const SheetGrid& grid, PassRenderer& renderer, const std::stop_token& stop)
{
    for (std::size_t layer = 0; layer < m_sheets.size(); ++layer) {
        if (Status status = renderer.renderAlone(layer, m_alone, stop); !status) {
            return status;
        }
        for (std::size_t i = 0; i < kPassTargets; ++i) {
            if (m_alone.targets[i].width > 0) {
                placeCell(grid, m_next, m_alone.targets[i], m_sheets[layer].targets.targets[i]);
            }
        }
    }
    return Done{};
}

Status LayerCells::take(
    const SheetGrid& grid, const PassImages& cell, int supersample, PassRenderer& renderer, const std::stop_token& stop)
{
    if (m_next == 0) {
        begin(grid, cell);
    }
    const auto place = [&](std::size_t layer, const Image& picture) {
        placeCell(grid, m_next, picture, m_sheets[layer].targets.of(PassTarget::Colour));
    };
    Status status = isShare(m_output)
        ? m_pictures.contributions(renderer.layers(), cell.of(PassTarget::Colour), supersample, place, stop)
        : takeAlone(grid, renderer, stop);
    ++m_next;
    return status;
}

} // namespace fumage
