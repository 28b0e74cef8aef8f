#pragma once

#include <QObject>

#include <functional>

namespace fumage::ui {

/// Hears of the signals that ask a program to end: those of a session that closes, of kill, and of Ctrl-C in a
/// terminal; on Windows of what happens in the console that the program was started from. Once a program.
class EndSignals : public QObject {
public:
    /// @param end called with the number of the signal (2: Ctrl-C), on this object's thread
    explicit EndSignals(std::function<void(int)> end, QObject* parent = nullptr);
    ~EndSignals() override;
};

} // namespace fumage::ui
