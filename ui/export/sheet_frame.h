#pragma once

#include "core/export/sheets/sheet_preview.h"
#include "core/rendering/view_transform.h"

#include <QImage>

namespace fumage::ui {

/// The picture that an engine shows of a flipbook at a time. Keeps its buffers from one to the next.
class SheetFrame {
public:
    /// @param seconds since the first cell; what does not loop rests a second on its last one and begins again
    /// @return straight alpha, of a cell's size; a copy
    /// O(pixels of a cell), on all threads.
    [[nodiscard]] QImage at(const SheetPreview& preview, double seconds, CellBlending blending);

private:
    Image m_image;
    EncodedImage<std::uint8_t> m_encoded;
};

} // namespace fumage::ui
