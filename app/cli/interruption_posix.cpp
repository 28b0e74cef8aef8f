#include "app/cli/interruption.h"

#include <csignal>
#include <thread>

#include <pthread.h>

namespace fumage::cli {

namespace {

bool isIgnored(int number)
{
    struct sigaction action { };
    return ::sigaction(number, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

/// Ends the program as the signal would have without us.
[[noreturn]] void dieOf(int number, const sigset_t& signals)
{
    std::signal(number, SIG_DFL);
    pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
    std::raise(number);
    std::abort();
}

void takeSignals(const std::stop_source& stop, const sigset_t& signals)
{
    int number = 0;
    sigwait(&signals, &number);
    stop.request_stop();
    sigwait(&signals, &number);
    dieOf(number, signals);
}

} // namespace

std::stop_token interruption()
{
    // The signals are blocked everywhere and taken by one thread, which may do what a signal handler must not.
    static const std::stop_source source = [] {
        std::stop_source stop;
        sigset_t signals;
        sigemptyset(&signals);
        for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
            if (!isIgnored(number)) {
                sigaddset(&signals, number);
            }
        }
        pthread_sigmask(SIG_BLOCK, &signals, nullptr);
        std::thread(takeSignals, stop, signals).detach();
        return stop;
    }();
    return source.get_token();
}

} // namespace fumage::cli
