#pragma once

#include <QObject>

#include <functional>

namespace fumage::ui {

/// Hears of the signals that ask a program to end: those of a session that closes, of kill, and of Ctrl-C in a
/// terminal. Once a program; no signals on Windows.
class EndSignals : public QObject {
public:
    /// @param end called with the number of the signal, on this object's thread
    explicit EndSignals(std::function<void(int)> end, QObject* parent = nullptr);
};

} // namespace fumage::ui
