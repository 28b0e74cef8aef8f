#include "ui/shell/window_tour.h"

#include "ui/panels/key_mark.h"
#include "ui/panels/number_field.h"
#include "ui/shell/action_table.h"
#include "ui/shell/tour.h"
#include "ui/widgets/in_sight.h"

#include <QCoreApplication>
#include <QMainWindow>
#include <QToolBar>

namespace fumage::ui {

namespace {

QString tourText(const char* text)
{
    return QCoreApplication::translate("WindowTour", text);
}

/// The first widget of a type in the panel of parameters that is to be seen; null: none is.
template <class Widget>
QWidget* firstSeen(const QMainWindow& window)
{
    const auto* panel = window.findChild<QWidget*>(QStringLiteral("effectPanel"));
    const QList<Widget*> all = panel != nullptr ? panel->findChildren<Widget*>() : QList<Widget*>();
    for (Widget* widget : all) {
        if (isInSight(*widget)) {
            return widget;
        }
    }
    return nullptr;
}

} // namespace

Tour* startWindowTour(QMainWindow& window, const ActionSet& actions)
{
    const auto named = [&window](const char* name) {
        return [&window, name] { return window.findChild<QWidget*>(QLatin1String(name)); };
    };
    const auto button = [&window, &actions](const char* action) {
        return [&window, &actions, action]() -> QWidget* {
            const auto* bar = window.findChild<QToolBar*>(QStringLiteral("toolBar"));
            return bar != nullptr ? bar->widgetForAction(&actions.get(action)) : nullptr;
        };
    };
    return Tour::start(window,
        {{tourText(QT_TRANSLATE_NOOP("WindowTour",
              "This is the smoke. Drag in it to look from another side, and turn the wheel to come nearer.")),
             named("viewport")},
            {tourText(QT_TRANSLATE_NOOP("WindowTour",
                 "These are its parameters. Drag a number sideways, or click it and type: the smoke follows at once. "
                 "F1 explains the one under the mouse.")),
                [&window] { return firstSeen<NumberField>(window); }},
            {tourText(QT_TRANSLATE_NOOP("WindowTour",
                 "This plays the smoke and holds it, as Space does. Drag in the timeline to go to another frame.")),
                named("playButton")},
            {tourText(QT_TRANSLATE_NOOP("WindowTour",
                 "The diamond sets a key frame: change the number at another frame, and it changes over time.")),
                [&window] { return firstSeen<KeyMark>(window); }},
            {tourText(QT_TRANSLATE_NOOP("WindowTour",
                 "This is the short way into a game: click your engine, and a flipbook that suits it is written, and "
                 "plays on a mock ground beside what is to be done in the engine.")),
                button("file.engine")},
            {tourText(QT_TRANSLATE_NOOP("WindowTour",
                 "This takes the smoke away: as a flipbook, an image sequence, a video or data for an engine. "
                 "Help > Tour shows all of this again.")),
                button("file.export")}});
}

} // namespace fumage::ui
