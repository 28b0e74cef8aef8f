#pragma once

#include "core/base/task.h"

#include <chrono>
#include <optional>
#include <string>

namespace fumage::cli {

/// A bar with the time left on standard error; nothing where that is not a terminal. Open Job Description hears of it
/// in lines of its own.
class ProgressBar {
public:
    /// @param what is being done to the frames: "Rendering"
    explicit ProgressBar(std::string what);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// Work that shows here how far it is, no longer than the bar lives, and that the user may interrupt; see
    /// interruption().
    [[nodiscard]] Task task();

private:
    void show(ProgressPhase work, int done, int total);
    void showToOpenJd(ProgressPhase work, int done, int total);

    std::string m_what;
    bool m_terminal;
    bool m_shown = false;
    std::optional<ProgressPhase> m_work;
    int m_percent = -1; ///< that Open Job Description was told last
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

} // namespace fumage::cli
