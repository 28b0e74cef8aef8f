#pragma once

#include "ui/document/parameter_text.h"
#include "ui/document/text.h"

#include "core/effect/parameter_table.h"

#include <QApplication>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <QWheelEvent>
#include <QtTest/QtTest>

namespace fumage::tests {

using namespace fumage::ui;

inline QString operator""_q(const char16_t* text, std::size_t length)
{
    return QString(reinterpret_cast<const QChar*>(text), static_cast<qsizetype>(length));
}

/// Turns the wheel over a widget, as a mouse would.
inline void turnWheel(QWidget& widget, int notches)
{
    const QPointF at = QRectF(widget.rect()).center();
    QWheelEvent event(
        at, widget.mapToGlobal(at), {}, {0, notches * 120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&widget, &event);
}

/// Presses, moves in small steps and releases.
inline void dragMouse(QWidget& widget, QPoint from, QPoint to, Qt::MouseButton button = Qt::LeftButton,
    Qt::KeyboardModifiers modifiers = {})
{
    QTest::mousePress(&widget, button, modifiers, from);
    constexpr int kSteps = 6;
    for (int i = 1; i <= kSteps; ++i) {
        const QPoint at = from + (to - from) * i / kSteps;
        QMouseEvent event(QEvent::MouseMove, at, widget.mapToGlobal(at), Qt::NoButton, button, modifiers);
        QApplication::sendEvent(&widget, &event);
    }
    QTest::mouseRelease(&widget, button, modifiers, to);
}

inline Value valueOf(const Effect& effect, const char* key)
{
    return findParameter(key)->get(effect);
}

/// main() of a test program: folders of its own for settings and data, and the application.
template <class Test, class Application = QApplication>
int runTest(int argc, char** argv)
{
    const QTemporaryDir home;
    for (const char* variable : {"HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME", "XDG_RUNTIME_DIR"}) {
        const QString folder = home.filePath(QString::fromLatin1(variable));
        QDir().mkpath(folder);
        QFile::setPermissions(folder, QFileDevice::ReadOwner | QFileDevice::WriteOwner | QFileDevice::ExeOwner);
        qputenv(variable, folder.toLocal8Bit());
    }
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    QSurfaceFormat::setDefaultFormat(format);
    Application application(argc, argv);
    Test test;
    return QTest::qExec(&test, argc, argv);
}

/// A part of a widget by its objectName; it must be there.
template <class Widget>
Widget* childOf(const QWidget& parent, const QString& name)
{
    auto* widget = parent.findChild<Widget*>(name);
    if (widget == nullptr) {
        qFatal("there is no %s", qPrintable(name));
    }
    return widget;
}

} // namespace fumage::tests

#define FUMAGE_TEST_MAIN(Test)                                                                                         \
    int main(int argc, char** argv)                                                                                    \
    {                                                                                                                  \
        return fumage::tests::runTest<Test>(argc, argv);                                                               \
    }
