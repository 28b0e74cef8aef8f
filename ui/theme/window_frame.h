#pragma once

class QApplication;

namespace fumage::ui {

/// Has the frames that the system draws around windows, those that are open and those to come, light or dark as the
/// program is. Elsewhere than on Windows frames are the desktop's.
void setFrames(QApplication& application, bool dark);

} // namespace fumage::ui
