#include "app/cli/progress.h"

#include <cstdio>
#include <iostream>

#include <unistd.h>

namespace fumage::cli {

ProgressBar::ProgressBar(std::string what)
    : m_what(std::move(what))
    , m_terminal(::isatty(STDERR_FILENO) != 0 && std::clog.rdbuf() != nullptr)
{
}

ProgressBar::~ProgressBar()
{
    if (m_shown) {
        std::fputc('\n', stderr);
    }
}

void ProgressBar::show(int done, int total)
{
    if (!m_terminal) {
        return;
    }
    constexpr int kWidth = 30;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
    const double left = seconds / done * (total - done);
    const std::string bar = std::string(static_cast<std::size_t>(kWidth * done / total), '#');
    // \033[K clears what a longer line left behind.
    std::fprintf(stderr, "\r%s [%-*s] %d/%d  %.1f/s  %.0f s left\033[K", m_what.c_str(), kWidth, bar.c_str(), done, total, done / seconds, left);
    std::fflush(stderr);
    m_shown = true;
}

} // namespace fumage::cli
