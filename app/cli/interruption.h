#pragma once

#include <stop_token>

namespace fumage::cli {

/// A token that stops when the user presses Ctrl-C, closes the terminal, or the program is asked to end. The second
/// time the program ends at once. Signals that the caller has the program ignore stay ignored, as nohup and background
/// jobs want it. The first call must come before any thread starts.
[[nodiscard]] std::stop_token interruption();

} // namespace fumage::cli
