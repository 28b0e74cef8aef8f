#pragma once

namespace fumage::ui {

/// The editor from start to end. @return exit code
int runEditor(int argc, char** argv);

} // namespace fumage::ui
