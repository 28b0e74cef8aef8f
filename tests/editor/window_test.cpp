// The window as a whole: it fits, it is operated by keyboard alone, it remembers how it was left.
#include "window_fixture.h"

#include "ui/panels/effect_panel.h"
#include "ui/panels/number_field.h"
#include "ui/panels/number_slider.h"
#include "ui/noise_preview/noise_pane.h"
#include "ui/viewport/viewport.h"

#include "core/effect/known_parameter.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QDialog>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QOpenGLWidget>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTabBar>

using namespace fumage;
using namespace fumage::tests;

class WindowTest : public WindowFixture {
    Q_OBJECT

private slots:
    void theWindowHasAnOpenGlViewport()
    {
        // Unless there is none, or only the processor's, which a plain widget beats.
        const QString wish = qEnvironmentVariable("FUMAGE_OPENGL");
        const bool expected = wish.isEmpty() ? m_session->glSupport() == GlSupport::Hardware : wish != u"none"_q;
        QCOMPARE(qobject_cast<QOpenGLWidget*>(m_window->viewport().surface()) != nullptr, expected);
    }

    void theWindowFitsASmallScreen()
    {
        // 1920 x 1080 at 200 %
        const QSize least = m_window->minimumSizeHint();
        QString parts;
        for (const QWidget* widget : m_window->findChildren<QWidget*>()) {
            if (widget->minimumSizeHint().width() > 150 && widget->parentWidget() != nullptr
                && !widget->objectName().isEmpty() && !widget->objectName().contains(u"."_q)) {
                parts += QStringLiteral(" %1:%2").arg(widget->objectName()).arg(widget->minimumSizeHint().width());
            }
        }
        QVERIFY2(least.width() <= 960 && least.height() <= 520,
            qPrintable(QStringLiteral("%1 x %2").arg(least.width()).arg(least.height()) + parts));
    }
    void severalWindowsHaveDocumentsOfTheirOwn()
    {
        trigger("file.newWindow");
        MainWindow* second = otherWindow();
        QVERIFY(second != nullptr);
        second->document().edit(knownParameter("motion.gravity"), 5.0F);
        QVERIFY(m_window->document().effect() == smallPreset().scene.effect());
        QVERIFY(!m_window->isWindowModified());
    }
    void aMaximisedWindowIsSoAgainAfterFullScreen()
    {
        m_window->showMaximized();
        QTRY_VERIFY(m_window->isMaximized());
        trigger("view.fullScreen");
        QTRY_VERIFY(m_window->isFullScreen());
        trigger("view.fullScreen");
        QTRY_VERIFY(!m_window->isFullScreen());
        QVERIFY(m_window->isMaximized());
    }

    void aWindowThatWasClosedFullScreenComesBackSoAndCanBeLeft()
    {
        trigger("view.fullScreen");
        QTRY_VERIFY(m_window->isFullScreen());
        m_window->close();
        m_window = m_session->openWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window));
        QVERIFY(m_window->isFullScreen());
        trigger("view.fullScreen");
        QTRY_VERIFY(!m_window->isFullScreen());
        m_window->close();
        m_window = m_session->openWindow();
        QVERIFY(!m_window->isFullScreen());
    }

    void onlyTheSmokeIsShownAndThePanelsComeBack()
    {
        childOf<QDockWidget>(*m_window, u"dock.history"_q)->close();
        const auto shown = [this] {
            QStringList names;
            for (const QDockWidget* dock : m_window->findChildren<QDockWidget*>()) {
                if (!dock->isHidden()) {
                    names += dock->objectName();
                }
            }
            names.sort();
            return names;
        };
        const QStringList before = shown();
        const int width = m_window->viewport().width();
        trigger("view.smokeOnly");
        QCOMPARE(shown(), QStringList());
        QTRY_COMPARE(m_window->viewport().width(), m_window->width());
        QVERIFY(!childOf<QWidget>(*m_window, u"timeline"_q)->isVisible());
        trigger("view.smokeOnly");
        QCOMPARE(shown(), before);
        QTRY_COMPARE(m_window->viewport().width(), width);
        trigger("view.smokeOnly");
        m_window->close();
        m_window = m_session->openWindow();
        QCOMPARE(shown(), before); // it is not remembered
    }

    void aWindowGoesWhileOneTypes_data()
    {
        QTest::addColumn<bool>("floats");
        QTest::newRow("in a dock") << false;
        QTest::newRow("in a panel that floats") << true;
    }
    void aWindowGoesWhileOneTypes()
    {
        QFETCH(bool, floats);
        auto* dock = childOf<QDockWidget>(*m_window, u"dock.parameters"_q);
        dock->setFloating(floats);
        dock->activateWindow();
        QTRY_COMPARE(QGuiApplication::focusWindow(), dock->window()->windowHandle());
        childOf<EffectPanel>(*dock, {})->showParameter(u"emitter.speed"_q);
        auto* field = childOf<NumberField>(*dock, u"emitter.speed.field"_q);
        field->setFocus();
        QTRY_VERIFY(field->hasFocus());
        QTest::keyClicks(field, u"3"_q);
        QSignalSpy edits(&m_window->document(), &Document::effectChanged);
        m_session.reset();
        QCOMPARE(edits.size(), 1);
    }

    void aSmallWindowShowsSeveralPresets()
    {
        m_window->resize(1280, 720);
        QTRY_COMPARE(m_window->height(), 720);
        trigger("view.resetLayout");
        const auto* list = childOf<QListWidget>(*m_window, u"presetList"_q);
        QTRY_VERIFY(list->viewport()->height() > 400);
        QVERIFY(list->isVisible());
    }

    void theDesktopsThemeIsFoundAgainAfterAnother()
    {
        const bool desktopIsDark = isDark(QApplication::palette());
        m_session->applyTheme(desktopIsDark ? Theme::Light : Theme::Dark);
        QCOMPARE(isDark(QApplication::palette()), !desktopIsDark);
        m_session->applyTheme(Theme::System);
        QCOMPARE(isDark(QApplication::palette()), desktopIsDark);
    }

    void whatIsDrawnOverTheSmokeIsRemembered()
    {
        const auto isShown = [](MainWindow& window, const char* action) {
            return window.actions().get(action).isChecked();
        };
        QVERIFY(
            isShown(*m_window, "view.grid") && !isShown(*m_window, "view.trails") && !isShown(*m_window, "view.frame"));
        trigger("view.grid");
        trigger("view.trails");
        trigger("view.frame");
        m_window->close();
        MainWindow* next = m_session->openWindow();
        QVERIFY(!isShown(*next, "view.grid") && isShown(*next, "view.trails") && isShown(*next, "view.readout"));
        QVERIFY(!isShown(*next, "view.frame")); // belongs to the export dialog
        QVERIFY(!next->viewport().overlays().testFlag(Overlay::Grid)
            && next->viewport().overlays().testFlag(Overlay::Trails));
        next->actions().get("view.grid").trigger();
        next->actions().get("view.trails").trigger();
        next->close();
        m_window = m_session->openWindow();
        QVERIFY(isShown(*m_window, "view.grid") && !isShown(*m_window, "view.trails"));
    }
    // --- keyboard ---

    void theKeyboardAloneIsEnough()
    {
        // Search a parameter, go to it, type a value, undo: no mouse.
        QTest::keyClick(m_window, Qt::Key_F, Qt::ControlModifier);
        auto* search = m_window->findChild<QLineEdit*>(u"parameterSearch"_q);
        QTRY_VERIFY(search->hasFocus());
        QTest::keyClicks(search, u"fade rate"_q);
        auto* field = m_window->findChild<EffectPanel*>()->findChild<NumberField*>(u"life.fade_rate.field"_q);
        for (int i = 0; i < 6 && !field->hasFocus(); ++i) {
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        }
        QVERIFY(field->hasFocus());
        QTest::keyClicks(field, u"0.08"_q);
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(m_window->document().effect().life.fadeRate, 0.08F);
        QTest::keyClick(m_window, Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(m_window->document().effect().life.fadeRate != 0.08F);
    }

    void returnTakesANumberOverAndTheKeysAreShortcutsAgain_data() { addNumberFields(); }
    void returnTakesANumberOverAndTheKeysAreShortcutsAgain()
    {
        QLineEdit& field = numberField();
        QTest::keyClicks(&field, u"7"_q);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        QCOMPARE(field.text().left(1), u"7"_q);
        QTRY_VERIFY(m_window->viewport().surface()->hasFocus());
        const bool frame = m_window->actions().get("view.frame").isChecked();
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_X);
        QCOMPARE(m_window->actions().get("view.frame").isChecked(), !frame);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
        QVERIFY(m_window->player().isPlaying());
        QCOMPARE(field.text().left(1), u"7"_q);
    }

    void escapeLeavesANumberAsItWas_data() { addNumberFields(); }
    void escapeLeavesANumberAsItWas()
    {
        QLineEdit& field = numberField();
        const QString before = field.text();
        QTest::keyClicks(&field, u"7"_q);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
        QTRY_VERIFY(m_window->viewport().surface()->hasFocus());
        QCOMPARE(field.text(), before);
        QCOMPARE(m_window->player().frame(), 30);
        QCOMPARE(m_window->document().undoStack()->count(), 0);
    }

    void mouseHabitsChangeInEveryWindow()
    {
        MainWindow* other = m_session->openWindow();
        m_window->actions().submenu("view.mouseHabits").actions()[1]->trigger();
        for (const MainWindow* window : {m_window, other}) {
            QCOMPARE(window->findChild<Viewport*>()->navigationStyle(), NavigationStyle::Maya);
        }
        QVERIFY(other->actions().submenu("view.mouseHabits").actions()[1]->isChecked());
        m_window->actions().submenu("view.mouseHabits").actions()[0]->trigger();
        QCOMPARE(other->viewport().navigationStyle(), NavigationStyle::Blender);
    }

    void plainKeysBelongToTheTimelineUnlessAWidgetNeedsThem()
    {
        m_window->viewport().surface()->setFocus();
        QTest::keyClick(m_window->viewport().surface(), Qt::Key_Right);
        QCOMPARE(m_window->player().frame(), 31);
        QTest::keyClick(m_window->viewport().surface(), Qt::Key_Left);
        QCOMPARE(m_window->player().frame(), 30);
        QTest::keyClick(m_window->viewport().surface(), Qt::Key_End);
        QCOMPARE(m_window->player().frame(), 59);
        QTest::keyClick(m_window->viewport().surface(), Qt::Key_Home);
        QCOMPARE(m_window->player().frame(), 0);
        auto* slider = m_window->findChild<EffectPanel*>()->findChild<NumberSlider*>(u"emitter.speed.slider"_q);
        slider->setFocus();
        const float before = m_window->document().effect().emitter.speed;
        QTest::keyClick(slider, Qt::Key_Right);
        QCOMPARE(m_window->player().frame(), 0);
        QVERIFY(m_window->document().effect().emitter.speed > before);
    }

    void aCommandIsFoundAndDone()
    {
        QTest::keyClick(m_window, Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY(m_window->findChild<QDialog*>(u"commandSearch"_q) != nullptr);
        auto* text = m_window->findChild<QLineEdit*>(u"commandSearch.text"_q);
        QTest::keyClicks(text, u"ground grid"_q);
        const bool before = m_window->viewport().overlays().testFlag(Overlay::Grid);
        QTest::keyClick(text, Qt::Key_Return);
        QCOMPARE(m_window->viewport().overlays().testFlag(Overlay::Grid), !before);
    }

    void theCommandSearchKnowsWhatMenusOffer_data()
    {
        QTest::addColumn<QString>("text");
        for (const char* text :
            {"theme light", "mouse habits maya", "language svenska", "panels noise", "preset volcano"}) {
            QTest::newRow(text) << QString::fromLatin1(text);
        }
    }
    void theCommandSearchKnowsWhatMenusOffer()
    {
        QFETCH(QString, text);
        const auto* list = searchCommands(text);
        QVERIFY(list->currentItem() != nullptr && !list->currentItem()->isHidden());
        QVERIFY(!childOf<QLabel>(*m_window, u"commandSearch.nothing"_q)->isVisible());
    }

    void aThemeAndAPresetAreChosenInTheCommandSearch()
    {
        searchCommands(u"theme light"_q);
        QTest::keyClick(childOf<QLineEdit>(*m_window, u"commandSearch.text"_q), Qt::Key_Return);
        QCOMPARE(m_session->settings().theme(), Theme::Light);
        m_session->applyTheme(Theme::System);
        QTRY_VERIFY(m_window->findChild<QDialog*>(u"commandSearch"_q) == nullptr);
        searchCommands(u"preset volcano"_q);
        QTest::keyClick(childOf<QLineEdit>(*m_window, u"commandSearch.text"_q), Qt::Key_Return);
        QCOMPARE(m_window->document().displayName().toLower(), u"volcano"_q);
    }

    void aCommandThatIsNotThereIsNotFound()
    {
        QVERIFY(searchCommands(u"zebra"_q)->currentItem() == nullptr);
        QVERIFY(childOf<QLabel>(*m_window, u"commandSearch.nothing"_q)->text().contains(u"zebra"_q));
    }

    void theNoisePaneHasItsParameters()
    {
        auto* field = childOf<NumberField>(m_window->noisePane(), u"noisePane/noise.sharpness.field"_q);
        m_window->document().edit(knownParameter("noise.sharpness"), 2.0F);
        QCOMPARE(field->value(), 2.0);
        QTest::mouseClick(field, Qt::LeftButton);
        field->selectAll();
        QTest::keyClicks(field, u"3"_q);
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(m_window->document().effect().noise.sharpness, 3.0F);
        QVERIFY(m_window->noisePane().findChild<NumberField*>(u"noisePane/noise.octaves.field"_q) != nullptr);
    }

    void everyActionHasATextAndNoShortcutIsTakenTwice()
    {
        QSet<QKeySequence> taken;
        for (const ActionSpec& spec : actionSpecs()) {
            QAction& action = m_window->actions().get(spec.id);
            QVERIFY(!action.text().isEmpty());
            for (const QKeySequence& keys : action.shortcuts()) {
                QVERIFY2(!keys.isEmpty() && !taken.contains(keys), spec.id);
                taken += keys;
            }
        }
    }

    void everythingThatCanBeReachedHasAName()
    {
        for (const QWidget* widget : m_window->findChildren<QWidget*>()) {
            // Tabs have their texts, and the field of a spin box speaks for the box.
            const bool isPart = qobject_cast<const QTabBar*>(widget) != nullptr
                || qobject_cast<const QAbstractSpinBox*>(widget->parent()) != nullptr;
            if (widget->focusPolicy() & Qt::TabFocus && widget->isVisible() && !isPart) {
                const auto* button = qobject_cast<const QAbstractButton*>(widget);
                const bool named = !widget->accessibleName().isEmpty()
                    || (button != nullptr && !button->text().isEmpty()) || !widget->toolTip().isEmpty();
                QVERIFY2(named,
                    qPrintable(widget->objectName() + u" "_q + QString::fromLatin1(widget->metaObject()->className())));
            }
        }
    }

private:
    static void addNumberFields()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("of a parameter") << u"emitter.speed.field"_q;
        QTest::newRow("of the timeline") << u"frameField"_q;
    }

    /// Opens the search of commands and types into it.
    QListWidget* searchCommands(const QString& text)
    {
        trigger("edit.commands");
        QTest::keyClicks(childOf<QLineEdit>(*m_window, u"commandSearch.text"_q), text);
        return childOf<QListWidget>(*m_window, u"commandSearch.list"_q);
    }

    /// The field that is asked for, with the keyboard in it and all of it selected.
    QLineEdit& numberField()
    {
        QFETCH(QString, name);
        auto* widget = m_window->findChild<QWidget*>(name);
        widget->setFocus(Qt::TabFocusReason);
        auto* box = qobject_cast<QSpinBox*>(widget);
        QLineEdit* field = box != nullptr ? box->findChild<QLineEdit*>() : qobject_cast<QLineEdit*>(widget);
        field->selectAll();
        return *field;
    }
};

FUMAGE_TEST_MAIN(WindowTest)
#include "window_test.moc"
