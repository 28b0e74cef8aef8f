#pragma once

#include "core/base/result.h"

#include <QApplication>
#include <QSet>

namespace fumage::ui {

/// An application that says so when memory runs out in the middle of an event, or anything else is thrown, and goes on:
/// unsaved work can be saved then.
class GuardedApplication : public QApplication {
    Q_OBJECT

public:
    using QApplication::QApplication;

    bool notify(QObject* receiver, QEvent* event) override;

private:
    void say(const Error& why);

    bool m_saying = false;
    QSet<QString> m_said; ///< once each: an event may come again and again
};

} // namespace fumage::ui
