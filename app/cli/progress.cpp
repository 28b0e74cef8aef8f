#include "app/cli/progress.h"
#include "app/cli/interruption.h"
#include "app/cli/streams.h"
#include "app/cli/system.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <iostream>

namespace fumage::cli {

namespace {

std::string nameOf(ProgressPhase work, const std::string& frames)
{
    switch (work) {
    case ProgressPhase::Air: return "Baking the air";
    case ProgressPhase::PreRoll: return "Simulating steps before";
    case ProgressPhase::Fitting: return "Looking";
    case ProgressPhase::Frames: return frames;
    }
    return frames;
}

} // namespace

ProgressBar::ProgressBar(std::string what)
    : m_what(std::move(what))
    , m_terminal(isErrorOnTerminal() && std::clog.rdbuf() != nullptr)
{
}

ProgressBar::~ProgressBar()
{
    if (m_shown) {
        std::fputc('\n', stderr);
    }
}

Task ProgressBar::task()
{
    return {[this](ProgressPhase work, int done, int total) { show(work, done, total); }, interruption()};
}

void ProgressBar::showToOpenJd(ProgressPhase work, int done, int total)
{
    constexpr int kWhole = 100;
    const int percent = static_cast<int>(static_cast<std::int64_t>(kWhole) * done / std::max(1, total));
    if (m_work != work) {
        tellOpenJd("status", nameOf(work, m_what));
    }
    // The way to the frames is none of them: a number that fell back would be none that people trust.
    if (work == ProgressPhase::Frames && percent != m_percent) {
        tellOpenJd("progress", std::to_string(percent));
        m_percent = percent;
    }
}

void ProgressBar::show(ProgressPhase work, int done, int total)
{
    if (talksToOpenJd()) {
        showToOpenJd(work, done, total);
        m_work = work;
        return;
    }
    const bool between = m_work == ProgressPhase::Frames && work != ProgressPhase::Frames;
    if (!m_terminal || between) {
        return;
    }
    if (m_work != work) {
        // What one part took says nothing of the next.
        m_start = m_work ? std::chrono::steady_clock::now() : m_start;
        m_work = work;
    }
    constexpr int kWidth = 30;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
    const double left = seconds / done * (total - done);
    const std::string bar = std::string(static_cast<std::size_t>(kWidth * done / total), '#');
    // \033[K clears what a longer line left behind.
    std::fprintf(stderr, "\r%s [%-*s] %d/%d  %.1f/s  %.0f s left\033[K", nameOf(work, m_what).c_str(), kWidth,
        bar.c_str(), done, total, done / seconds, left);
    std::fflush(stderr);
    m_shown = true;
}

} // namespace fumage::cli
