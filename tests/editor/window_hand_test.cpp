// What holds for the hand in all windows and dialogs, whatever the widget: which buttons and wheels change something,
// and how a drag ends.
#include "window_fixture.h"

#include "ui/document/key_edits.h"
#include "ui/document/layer_edits.h"
#include "ui/document/marker_edits.h"
#include "ui/noise_preview/noise_canvas.h"
#include "ui/panels/effect_panel.h"
#include "ui/panels/parameter_row.h"
#include "ui/presets/start_dialog.h"
#include "ui/shell/action_table.h"
#include "ui/shell/docks.h"
#include "ui/timeline/timeline_bar.h"
#include "ui/viewport/gizmos.h"
#include "ui/viewport/viewport.h"

#include "core/effect/known_parameter.h"

#include <QAbstractSpinBox>
#include <QAbstractItemView>
#include <QColorDialog>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QLineEdit>
#include <QScrollBar>
#include <QTabBar>
#include <QWindow>

#include <functional>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr const Parameter& kKeyed = knownParameter("wind.strength");

/// What a widget holds that a hand can change; invalid where it holds nothing.
QVariant heldBy(const QWidget& widget)
{
    if (const auto* list = qobject_cast<const QComboBox*>(&widget)) {
        return list->currentIndex();
    }
    if (const auto* tabs = qobject_cast<const QTabBar*>(&widget)) {
        return tabs->currentIndex();
    }
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) {
        return button->isChecked();
    }
    if (const auto* slider = qobject_cast<const QAbstractSlider*>(&widget)) {
        return qobject_cast<const QScrollBar*>(slider) != nullptr ? QVariant() : QVariant(slider->value());
    }
    if (const auto* line = qobject_cast<const QLineEdit*>(&widget)) {
        return line->text();
    }
    if (const auto* canvas = qobject_cast<const NoiseCanvas*>(&widget)) {
        return canvas->line();
    }
    return {};
}

QString nameOf(const QWidget& widget)
{
    return QString::fromLatin1(widget.metaObject()->className()) + QLatin1Char(' ') + widget.objectName() + u" in "_q
        + widget.window()->objectName();
}

/// Of all widgets that are on the screen.
QList<QWidget*> seenWidgets()
{
    QList<QWidget*> seen;
    for (QWidget* widget : QApplication::allWidgets()) {
        if (widget->isVisible() && !widget->size().isEmpty()) {
            seen += widget;
        }
    }
    return seen;
}

} // namespace

class WindowHandTest : public WindowFixture {
    Q_OBJECT

private slots:
    void otherButtonsChangeNothing_data() { windows(); }
    void otherButtonsChangeNothing()
    {
        QFETCH(QString, window);
        open(window);
        eachWidget([](QWidget& widget) {
            for (const Qt::MouseButton button :
                {Qt::RightButton, Qt::MiddleButton, Qt::BackButton, Qt::ForwardButton}) {
                for (const int quarter : {1, 2, 3}) {
                    const QPoint at(widget.width() * quarter / 4, widget.height() * quarter / 4);
                    QTest::mousePress(&widget, button, {}, at);
                    QMouseEvent move(
                        QEvent::MouseMove, at, widget.mapToGlobal(at), Qt::NoButton, button, Qt::NoModifier);
                    QApplication::sendEvent(&widget, &move);
                    QTest::mouseRelease(&widget, button, {}, at);
                }
            }
        });
    }

    void aWheelInPassingChangesNothing_data() { windows(); }
    void aWheelInPassingChangesNothing()
    {
        QFETCH(QString, window);
        open(window);
        eachWidget([this](QWidget& widget) {
            const bool zooms =
                &widget == m_window->viewport().surface() || qobject_cast<NoiseCanvas*>(&widget) != nullptr;
            for (const int notches : {2, -1}) {
                if (!zooms) {
                    m_window->centralWidget()->setFocus();
                    turnWheel(widget, notches);
                }
            }
            QVERIFY2(widget.focusPolicy() != Qt::WheelFocus, qPrintable(nameOf(widget)));
        });
    }

    void aListDoesNotTakeTheWheelEvenWithTheFocus_data() { windows(); }
    void aListDoesNotTakeTheWheelEvenWithTheFocus()
    {
        QFETCH(QString, window);
        open(window);
        eachWidget([](QWidget& widget) {
            if (qobject_cast<QComboBox*>(&widget) != nullptr) {
                widget.setFocus();
                turnWheel(widget, -1);
                turnWheel(widget, 1);
                turnWheel(widget, 1);
            }
        });
    }

    // --- the end of a drag ---

    void aDragWhoseReleaseNeverCameEndsWithoutAButton()
    {
        eachDrag([this](QWidget& widget, QPoint at) {
            const QString first = held();
            begin(widget, at);
            const QString dragged = held();
            QVERIFY2(dragged != first, qPrintable(nameOf(widget)));
            hover(widget, at + QPoint(30, 9));
            hover(widget, at + QPoint(60, 3));
            QVERIFY2(held() == dragged, qPrintable(nameOf(widget)));
        });
    }

    void aDragEndsWhenAnotherWindowTakesTheKeyboard()
    {
        eachDrag([this](QWidget& widget, QPoint at) {
            begin(widget, at);
            const QString dragged = held();
            QEvent gone(QEvent::WindowDeactivate);
            QApplication::sendEvent(widget.window(), &gone);
            QMouseEvent move(QEvent::MouseMove, at, widget.mapToGlobal(at + QPoint(50, 5)), Qt::NoButton,
                Qt::LeftButton, Qt::NoModifier);
            QApplication::sendEvent(&widget, &move);
            QVERIFY2(held() == dragged, qPrintable(nameOf(widget)));
            QTest::mouseRelease(&widget, Qt::LeftButton, {}, at);
            QVERIFY2(held() == dragged, qPrintable(nameOf(widget)));
        });
    }

    void escapeTakesADragBackAndLeavesNoStep()
    {
        eachDrag([this](QWidget& widget, QPoint at) {
            const QString first = held();
            const int steps = m_window->document().undoStack()->count();
            begin(widget, at);
            QVERIFY2(held() != first, qPrintable(nameOf(widget)));
            QTest::keyClick(
                QApplication::focusWidget() != nullptr ? QApplication::focusWidget() : m_window, Qt::Key_Escape);
            QVERIFY2(held() == first, qPrintable(nameOf(widget) + u": "_q + held() + u" is not "_q + first));
            QCOMPARE(m_window->document().undoStack()->count(), steps);
            QTest::mouseRelease(&widget, Qt::LeftButton, {}, at + QPoint(40, 5));
            QVERIFY2(held() == first, qPrintable(nameOf(widget)));
            QCOMPARE(m_window->document().undoStack()->count(), steps);
        });
    }

    /// Else the drag would go on in what the steps before it have left: here in a layer that is not that of the press.
    void undoInADragTakesItBackAndTheNextOneFindsNoDrag()
    {
        eachDrag([this](QWidget& widget, QPoint at) {
            const QString first = held();
            begin(widget, at);
            QVERIFY2(held() != first, qPrintable(nameOf(widget)));
            trigger("edit.undo");
            QVERIFY2(held() == first, qPrintable(nameOf(widget) + u": "_q + held() + u" is not "_q + first));
            trigger("edit.undo"); // the button is still down
            const QString undone = held();
            QCOMPARE(m_window->document().scene().layers.size(), std::size_t{1});
            drag(widget, at + QPoint(60, 20));
            QVERIFY2(held() == undone, qPrintable(nameOf(widget)));
            QTest::mouseRelease(&widget, Qt::LeftButton, {}, at + QPoint(60, 20));
            QVERIFY2(held() == undone, qPrintable(nameOf(widget)));
            trigger("edit.redo");
            QVERIFY2(held() == first, qPrintable(nameOf(widget)));
        });
    }

    /// Where the drag has made no step, as that of the camera, there may be one to be done again.
    void redoInADragBringsNoLayerUnderTheHand()
    {
        Document& document = m_window->document();
        addKeysAndMarker();
        addLayer(document);
        document.undoStack()->undo();
        QVERIFY(document.undoStack()->canRedo());
        QWidget& surface = *m_window->viewport().surface();
        const QString first = held();
        begin(surface, QPoint(20, 20));
        QVERIFY(held() != first);
        trigger("edit.redo");
        QCOMPARE(held(), first);
        QTest::mouseRelease(&surface, Qt::LeftButton, {}, QPoint(60, 40));
        QCOMPARE(held(), first);
        trigger("edit.redo");
        QCOMPARE(document.scene().layers.size(), std::size_t{2});
    }

    /// What changes the document otherwise ends the drag first: it stays as far as it has come.
    void aDragEndsBeforeItsLayerIsDeleted()
    {
        eachDrag([this](QWidget& widget, QPoint at) {
            begin(widget, at);
            const QString dragged = held();
            trigger("edit.deleteLayers");
            QCOMPARE(m_window->document().scene().layers.size(), std::size_t{1});
            const QString left = held();
            drag(widget, at + QPoint(60, 20));
            QVERIFY2(held() == left, qPrintable(nameOf(widget)));
            QTest::mouseRelease(&widget, Qt::LeftButton, {}, at + QPoint(60, 20));
            QVERIFY2(held() == left, qPrintable(nameOf(widget)));
            trigger("edit.undo");
            QVERIFY2(held() == dragged, qPrintable(nameOf(widget)));
        });
    }

    void aNumberIsDraggedBeyondTheEdgeOfTheScreen()
    {
        auto* panel = m_window->findChild<EffectPanel*>();
        panel->showParameter(u"emitter.speed"_q);
        auto* field = childOf<QLineEdit>(*panel, u"emitter.speed.field"_q);
        const QRect screen = m_window->screen()->virtualGeometry();
        const auto moveTo = [&](int x) {
            const QPoint global(x, 400);
            QMouseEvent move(
                QEvent::MouseMove, field->mapFromGlobal(global), global, Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
            QApplication::sendEvent(field, &move);
        };
        m_window->centralWidget()->setFocus();
        QTest::mousePress(field, Qt::LeftButton, {}, QPoint(2, 2));
        moveTo(field->mapToGlobal(QPoint(2, 2)).x() + 5);
        moveTo(screen.right());
        const float atEdge = m_window->document().effect().emitter.speed;
        QVERIFY(QCursor::pos().x() < screen.left() + 20); // it came in again at the other side
        moveTo(QCursor::pos().x());
        QCOMPARE(m_window->document().effect().emitter.speed, atEdge);
        moveTo(QCursor::pos().x() + 100);
        QVERIFY(m_window->document().effect().emitter.speed > atEdge);
        QTest::mouseRelease(field, Qt::LeftButton, {}, QPoint(2, 2));
        QCOMPARE(m_window->document().undoStack()->count(), 1);
    }

    // --- the keyboard ---

    void keysOfDigitsAndLettersActByTheirPlace_data()
    {
        QTest::addColumn<int>("key");
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("modifiers");
        QTest::addColumn<uint>("scanCode"); // of X11
        QTest::addColumn<QString>("action");
        QTest::newRow("French 1") << int(Qt::Key_Ampersand) << u"&"_q << int(Qt::NoModifier) << 10U << u"view.front"_q;
        QTest::newRow("French 3") << int(Qt::Key_QuoteDbl) << u"\""_q << int(Qt::NoModifier) << 12U << u"view.right"_q;
        QTest::newRow("French 7") << int(Qt::Key_Egrave) << u"\u00e8"_q << int(Qt::NoModifier) << 16U << u"view.top"_q;
        QTest::newRow("French Ctrl+1") << int(Qt::Key_Ampersand) << QString() << int(Qt::ControlModifier) << 10U
                                       << u"view.back"_q;
        QTest::newRow("Russian F") << 0x0410 << u"\u0430"_q << int(Qt::NoModifier) << 41U << u"view.frameAll"_q;
        QTest::newRow("Greek X") << 0x03a7 << u"\u03c7"_q << int(Qt::NoModifier) << 53U << u"view.frame"_q;
        QTest::newRow("a French comma is no M")
            << int(Qt::Key_Comma) << u","_q << int(Qt::NoModifier) << 58U << QString();
        QTest::newRow("a French A is no Q") << int(Qt::Key_A) << u"a"_q << int(Qt::ControlModifier) << 24U << QString();
    }
    void keysOfDigitsAndLettersActByTheirPlace()
    {
        QFETCH(int, key);
        QFETCH(QString, text);
        QFETCH(int, modifiers);
        QFETCH(uint, scanCode);
        QFETCH(QString, action);
        QStringList done;
        for (const ActionSpec& spec : actionSpecs()) {
            QAction& one = m_window->actions().get(spec.id);
            connect(&one, &QAction::triggered, this, [&done, id = one.objectName()] { done += id; });
        }
        const auto press = [&](QWidget& widget) {
            QKeyEvent event(QEvent::KeyPress, key, Qt::KeyboardModifiers(modifiers), scanCode, 0, 0, text);
            QApplication::sendEvent(&widget, &event);
        };
        press(*m_window->viewport().surface());
        QCOMPARE(done, action.isEmpty() ? QStringList() : QStringList{action});
        // In a field the same keys are text, but for those with Ctrl.
        done.clear();
        press(*childOf<QLineEdit>(*m_window, u"parameterSearch"_q));
        QCOMPARE(done.isEmpty(), modifiers == Qt::NoModifier || action.isEmpty());
    }

    void theKeyboardGoesBackToThePictureAfterTheMouseHasChosen()
    {
        open(u"main"_q);
        int lists = 0;
        for (QWidget* widget : seenWidgets()) {
            auto* list = qobject_cast<QComboBox*>(widget);
            if (list == nullptr || list->window() != m_window) {
                continue;
            }
            ++lists;
            list->setFocus(Qt::MouseFocusReason);
            list->showPopup();
            QTRY_VERIFY(list->view()->isVisible());
            QTest::keyClick(list->view(), Qt::Key_Return);
            QTRY_VERIFY(!list->view()->isVisible());
            QTRY_COMPARE(QApplication::focusWidget(), m_window->viewport().surface());
        }
        QVERIFY(lists > 3);
        auto* loop = childOf<QAbstractButton>(*m_window, u"seamlessLoop"_q);
        loop->setFocus(Qt::MouseFocusReason);
        QTest::mouseClick(loop, Qt::LeftButton, {}, QPoint(8, loop->height() / 2));
        QVERIFY(m_window->document().effect().timeline.loop);
        QTRY_COMPARE(QApplication::focusWidget(), m_window->viewport().surface());
        TimelineRuler& ruler = m_window->findChild<TimelineBar*>()->ruler();
        childOf<QLineEdit>(*m_window, u"parameterSearch"_q)->setFocus();
        QTest::mouseClick(&ruler, Qt::LeftButton);
        QTRY_COMPARE(QApplication::focusWidget(), m_window->viewport().surface());
    }

    // --- the places of windows ---

    void aWindowOpensOnTheScreenWithItsFrame_data()
    {
        QTest::addColumn<QString>("window");
        QTest::addColumn<bool>("maximised");
        for (const char* window : {"main", "export", "commands", "reference", "shortcuts", "start", "colour"}) {
            for (const bool maximised : {false, true}) {
                QTest::addRow("%s%s", window, maximised ? ", maximised" : "")
                    << QString::fromLatin1(window) << maximised;
            }
        }
    }
    void aWindowOpensOnTheScreenWithItsFrame()
    {
        QFETCH(QString, window);
        QFETCH(bool, maximised);
        const QRect room = m_window->screen()->availableGeometry();
        if (maximised) {
            m_window->showMaximized();
            QTRY_VERIFY(m_window->width() >= room.width() - 20);
        } else {
            m_window->move(room.topLeft());
        }
        if (window != u"main"_q) {
            open(window);
        }
        const QWidget* opened = window == u"main"_q ? static_cast<QWidget*>(m_window) : dialog();
        QTRY_VERIFY(!opened->windowHandle()->frameMargins().isNull());
        const auto inside = [&] {
            return room.adjusted(-1, -1, 1, 1)
                .contains(opened->geometry().marginsAdded(opened->windowHandle()->frameMargins()));
        };
        if (!QTest::qWaitFor(inside)) {
            QDebug(QtDebugMsg) << opened->geometry() << opened->windowHandle()->frameMargins() << room;
            QFAIL("a part of it is beyond the screen");
        }
    }

private:
    static void windows()
    {
        QTest::addColumn<QString>("window");
        for (const char* window : {"main", "export", "commands", "reference", "shortcuts", "start", "colour"}) {
            QTest::newRow(window) << QString::fromLatin1(window);
        }
    }

    /// Brings a window to the screen, with everything in it that can be seen.
    void open(const QString& window)
    {
        auto* panel = m_window->findChild<EffectPanel*>();
        if (window == u"main"_q) {
            for (QDockWidget* dock : m_window->findChildren<QDockWidget*>()) {
                dock->show();
            }
            QStringList all;
            for (const Parameter& parameter : parameterTable()) {
                all += toQString(parameter.group());
            }
            panel->setOpenGroups(all);
            return;
        }
        if (window == u"start"_q) {
            (new StartDialog({}, m_window))->open();
        } else if (window == u"colour"_q) {
            panel->showParameter(u"look.colour"_q);
            childOf<QAbstractButton>(*panel, u"look.colour.swatch"_q)->click();
        } else {
            const QHash<QString, const char*> actions{{u"export"_q, "file.export"}, {u"commands"_q, "edit.commands"},
                {u"reference"_q, "help.manual"}, {u"shortcuts"_q, "help.shortcuts"}};
            trigger(actions.value(window));
        }
        QTRY_VERIFY(dialog() != nullptr && dialog()->isVisible());
    }

    QDialog* dialog() const
    {
        for (QWidget* widget : QApplication::topLevelWidgets()) {
            if (auto* dialog = qobject_cast<QDialog*>(widget); dialog != nullptr && dialog->isVisible()) {
                return dialog;
            }
        }
        return nullptr;
    }

    /// All that a hand can change.
    QString held() const
    {
        const Player& player = m_window->player();
        return toQString(formatPreset(m_window->document().preset()))
            + u" frame %1, %2 to %3"_q.arg(player.frame()).arg(player.first()).arg(player.last());
    }

    /// Does something to each widget on the screen, after which all must hold what they held.
    template <class Act>
    void eachWidget(const Act& act)
    {
        QHash<QWidget*, QVariant> before;
        const QList<QWidget*> seen = seenWidgets();
        QVERIFY(seen.size() > 10);
        for (QWidget* widget : seen) {
            before.insert(widget, heldBy(*widget));
        }
        const QString document = held();
        for (const QPointer<QWidget>& widget : QList<QPointer<QWidget>>(seen.begin(), seen.end())) {
            if (widget && widget->isVisible() && widget->isEnabled()) {
                act(*widget);
                QVERIFY2(widget, "a widget is gone");
                QVERIFY2(heldBy(*widget) == before.value(widget), qPrintable(nameOf(*widget)));
                QVERIFY2(held() == document, qPrintable(nameOf(*widget)));
            }
        }
        for (QWidget* widget : seen) {
            QVERIFY2(heldBy(*widget) == before.value(widget), qPrintable(nameOf(*widget)));
        }
    }

    static void begin(QWidget& widget, QPoint at)
    {
        QTest::mousePress(&widget, Qt::LeftButton, {}, at);
        for (const int way : {4, 12, 25}) {
            drag(widget, at + QPoint(way, way / 3));
        }
    }

    static void drag(QWidget& widget, QPoint to)
    {
        QMouseEvent move(QEvent::MouseMove, to, widget.mapToGlobal(to), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&widget, &move);
    }

    static void hover(QWidget& widget, QPoint at)
    {
        QMouseEvent move(QEvent::MouseMove, at, widget.mapToGlobal(at), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
        QApplication::sendEvent(&widget, &move);
    }

    /// A key frame and a marker at the frame that is shown: they belong to all layers.
    void addKeysAndMarker()
    {
        addKey(m_window->document(), kKeyed);
        addMarkerHere(m_window->document());
        auto* bar = m_window->findChild<TimelineBar*>();
        bar->setShowsGraph(true);
        QTRY_VERIFY(bar->lanes().isVisible() && bar->graph().isVisible() && bar->markers().isVisible());
    }

    /// Where the handle of the emitter's normal is on the screen.
    QPoint normalOnScreen() const
    {
        const View view = m_window->viewport().view();
        for (const Gizmo& gizmo : gizmosOf(m_window->document().effect(), view)) {
            if (gizmo.id == GizmoId::EmitterNormal) {
                const Projected at = project(view, gizmo.to);
                return {qRound(at.x), qRound(at.y)};
            }
        }
        return {};
    }

    /// Calls with one widget of each kind that is dragged, and where. The last step before is that which has brought
    /// the layer that is edited.
    template <class Act>
    void eachDrag(const Act& act)
    {
        open(u"main"_q);
        addKeysAndMarker();
        duplicateLayers(m_window->document(), {0});
        const TimelineBar& bar = *m_window->findChild<TimelineBar*>();
        QTRY_VERIFY(bar.emission().isVisible()); // the bar has its height
        if (QTest::currentTestFailed()) {
            return;
        }
        auto* panel = m_window->findChild<EffectPanel*>();
        QList<std::pair<QWidget*, std::function<QPoint()>>> drags; // what was dragged before may be elsewhere by now
        for (const char* name : {"emitter.speed.field", "emitter.speed.slider", "wind.angle.dial", "emitter.normal.x",
                 "emitter.normal.yaw.slider", "emitter.position.x", "look.colour.r", "emitter.count.slider",
                 "life.alpha.area", "look.colour_over_life.bar"}) {
            auto* widget = childOf<QWidget>(*panel, QString::fromLatin1(name));
            drags.append({widget, [widget] { return QPoint(widget->width() / 3, widget->height() / 4); }});
        }
        TimelineRuler& ruler = bar.ruler();
        drags.append({&ruler, [&ruler] { return QPoint(ruler.width() / 3, ruler.height() / 2); }});
        drags.append({&bar.markers(), [&bar] { return bar.markers().flagOf(0).center().toPoint(); }});
        const auto key = [this] { return KeyPlace{&kKeyed, m_window->document().track(kKeyed)->keys.front().seconds}; };
        drags.append({&bar.lanes(), [&bar, key] { return bar.lanes().placeOf(key()).toPoint(); }});
        drags.append({&bar.graph(), [&bar, key] { return bar.graph().placeOf(key()).toPoint(); }});
        QWidget* surface = m_window->viewport().surface();
        drags.append({surface, [this] { return normalOnScreen(); }});
        drags.append({surface, [] { return QPoint(20, 20); }});
        for (const auto& [widget, at] : drags) {
            m_window->centralWidget()->setFocus();
            act(*widget, at());
            if (QTest::currentTestFailed()) {
                return;
            }
        }
    }
};

FUMAGE_TEST_MAIN(WindowHandTest)
#include "window_hand_test.moc"
