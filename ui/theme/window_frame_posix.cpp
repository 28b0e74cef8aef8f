#include "ui/theme/window_frame.h"

namespace fumage::ui {

void setFrames(QApplication&, bool)
{
    // The desktop has a theme for frames, which its user chose.
}

} // namespace fumage::ui
