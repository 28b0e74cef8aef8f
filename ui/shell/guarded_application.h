#pragma once

#include <QApplication>

namespace fumage::ui {

/// An application that says so when memory runs out in the middle of an event, and goes on: unsaved work can be saved then.
class GuardedApplication : public QApplication {
    Q_OBJECT

public:
    using QApplication::QApplication;

    bool notify(QObject* receiver, QEvent* event) override;

private:
    void sayExhausted();

    bool m_saying = false;
};

} // namespace fumage::ui
