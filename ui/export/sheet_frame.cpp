#include "ui/export/sheet_frame.h"

#include <cmath>

namespace fumage::ui {

QImage SheetFrame::at(const SheetPreview& preview, double seconds, CellBlending blending)
{
    constexpr double kPause = 1.0; // s, after what does not loop
    const SheetGrid& grid = preview.sheet.grid;
    const double length = grid.loops ? grid.cells : grid.cells - 1 + kPause * preview.cellsPerSecond;
    const double cell = std::fmod(seconds * preview.cellsPerSecond, length);
    preview.playback->picture(cell, grid.loops, blending, m_image);
    encode(m_image, preview.output, m_encoded);
    return QImage(
        m_encoded.pixels.data(), m_encoded.width, m_encoded.height, 4 * m_encoded.width, QImage::Format_RGBA8888)
        .copy();
}

} // namespace fumage::ui
