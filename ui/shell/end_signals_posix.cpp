#include "ui/shell/end_signals.h"

#include <QSocketNotifier>

#include <array>
#include <csignal>

#include <fcntl.h>
#include <unistd.h>

namespace fumage::ui {

namespace {

/// A handler may do next to nothing: it writes the number here, and the loop of events reads it. Only a global reaches
/// a handler.
std::array<int, 2> s_pipe{-1, -1}; // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

extern "C" void noteSignal(int number)
{
    const auto byte = static_cast<unsigned char>(number);
    static_cast<void>(!::write(s_pipe[1], &byte, 1));
}

} // namespace

EndSignals::EndSignals(std::function<void(int)> end, QObject* parent)
    : QObject(parent)
{
    if (::pipe2(s_pipe.data(), O_CLOEXEC | O_NONBLOCK) != 0) {
        return; // the signals do what they always do
    }
    auto* heard = new QSocketNotifier(s_pipe[0], QSocketNotifier::Read, this);
    connect(heard, &QSocketNotifier::activated, this, [end = std::move(end)] {
        unsigned char number = 0;
        if (::read(s_pipe[0], &number, 1) == 1) {
            end(number);
        }
    });
    for (const int number : {SIGTERM, SIGINT, SIGHUP}) {
        struct sigaction action { };
        action.sa_handler = noteSignal; // NOLINT(cppcoreguidelines-pro-type-union-access): of the system
        action.sa_flags = SA_RESTART | static_cast<int>(SA_RESETHAND); // the second one ends a program that hangs
        struct sigaction before { };
        if (::sigaction(number, nullptr, &before) == 0
            && before.sa_handler != SIG_IGN) { // NOLINT(cppcoreguidelines-pro-type-union-access)
            ::sigaction(number, &action, nullptr);
        }
    }
}

EndSignals::~EndSignals() = default;

} // namespace fumage::ui
