// Two effects beside one another.
#include "window_fixture.h"

#include "ui/viewport/viewport.h"

#include "core/effect/known_parameter.h"

#include <QDockWidget>
#include <QElapsedTimer>
#include <QToolButton>
#include <QWindow>

using namespace fumage;
using namespace fumage::tests;

class WindowCompareTest : public WindowFixture {
    Q_OBJECT

private slots:
    void aAndBAreSeenSideBySide()
    {
        Viewport& viewport = m_window->viewport();
        trigger("compare.remember");
        m_window->document().edit(knownParameter("look.colour"), glm::vec3(1.0F, 0.1F, 0.1F));
        const QImage a = settled();
        m_window->actions().get("compare.split").setChecked(true);
        QCOMPARE(viewport.compare(), Viewport::Compare::Split);
        QTRY_VERIFY(viewport.otherPicture() && viewport.otherPicture()->complete);
        QVERIFY(viewport.otherPicture()->image != a);
        // Both halves move together.
        const QImage b = viewport.otherPicture()->image;
        m_window->document().edit(knownParameter("camera.yaw"), 50.0F);
        QTRY_VERIFY(viewport.otherPicture()->image != b);
        m_window->actions().get("compare.split").setChecked(false);
        trigger("compare.adopt");
        QVERIFY(m_window->document().effect() == smallPreset().scene.effect());
    }

    void bIsSeenWhileItsKeyIsHeld()
    {
        QWindow& window = *m_window->windowHandle();
        m_window->viewport().surface()->setFocus();
        tapB(); // stays
        QCOMPARE(m_window->viewport().compare(), Viewport::Compare::Other);
        QTest::keyClick(&window, Qt::Key_B);
        QCOMPARE(m_window->viewport().compare(), Viewport::Compare::Off);
        holdB(window);
        QCOMPARE(m_window->viewport().compare(), Viewport::Compare::Other);
        QTest::keyRelease(&window, Qt::Key_B);
        QCOMPARE(m_window->viewport().compare(), Viewport::Compare::Off);
    }

    void aHeldKeyIsSeenReleasedWhereverTheFocusHasGone_data()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("a field, which keeps the release to itself") << u"frameField"_q;
        QTest::newRow("a list") << u"historyView"_q;
        QTest::newRow("a slider") << u"emitter.speed.slider"_q;
    }
    void aHeldKeyIsSeenReleasedWhereverTheFocusHasGone()
    {
        QFETCH(QString, name);
        QWindow& window = *m_window->windowHandle();
        m_window->viewport().surface()->setFocus();
        holdB(window);
        auto* widget = childOf<QWidget>(*m_window, name);
        widget->setFocus();
        QCOMPARE(m_window->viewport().compare(), Viewport::Compare::Other);
        QTest::keyRelease(&window, Qt::Key_B);
        QCOMPARE(m_window->viewport().compare(), Viewport::Compare::Off);
    }

    void aHeldKeyIsSeenReleasedInAPanelThatFloats()
    {
        auto* dock = childOf<QDockWidget>(*m_window, u"dock.noise"_q);
        dock->setFloating(true);
        dock->activateWindow();
        QTRY_COMPARE(QGuiApplication::focusWindow(), dock->windowHandle());
        childOf<QToolButton>(*dock, u"noiseTiled"_q)->setFocus(); // lists have a use for letters
        holdB(*dock->windowHandle());
        QCOMPARE(m_window->viewport().compare(), Viewport::Compare::Other);
        QTest::keyRelease(dock->windowHandle(), Qt::Key_B);
        QCOMPARE(m_window->viewport().compare(), Viewport::Compare::Off);
    }

    void bGoesWithTheKeyboardWhileItsKeyIsHeld()
    {
        m_window->viewport().surface()->setFocus();
        QTest::keyPress(m_window->windowHandle(), Qt::Key_B);
        QCOMPARE(m_window->viewport().compare(), Viewport::Compare::Other);
        QWidget another;
        another.show();
        QVERIFY(QTest::qWaitForWindowActive(&another));
        QTRY_COMPARE(m_window->viewport().compare(), Viewport::Compare::Off);
        // The key was let go over there; here the next tap is a tap again.
        another.close();
        QTRY_COMPARE(QGuiApplication::focusWindow(), m_window->windowHandle());
        m_window->viewport().surface()->setFocus();
        tapB();
        QCOMPARE(m_window->viewport().compare(), Viewport::Compare::Other);
    }

    void bFromTheMenuStaysWithoutTheKeyboard()
    {
        trigger("compare.hold");
        QWidget another;
        another.show();
        QVERIFY(QTest::qWaitForWindowActive(&another));
        QCOMPARE(m_window->viewport().compare(), Viewport::Compare::Other);
    }

    void bIsTheSmokeThatWasOpenedLast()
    {
        Viewport& viewport = m_window->viewport();
        m_window->actions().get("compare.split").setChecked(true);
        QTRY_VERIFY(viewport.otherPicture() && viewport.otherPicture()->complete);
        const QImage before = viewport.otherPicture()->image;
        Preset red = smallPreset();
        red.scene.layers[0].look.colour = {1.0F, 0.1F, 0.1F};
        m_window->document().load(red, {});
        QTRY_VERIFY(viewport.otherPicture()->complete && viewport.otherPicture()->image != before);
        m_window->document().edit(*findParameter("motion.gravity"), 2.0F);
        trigger("compare.adopt");
        QVERIFY(m_window->document().effect() == red.scene);
    }

private:
    /// Presses the key of B and keeps it down for longer than a tap.
    static void holdB(QWindow& window)
    {
        QTest::keyPress(&window, Qt::Key_B);
        QElapsedTimer held;
        held.start();
        QTRY_VERIFY(held.hasExpired(Comparison::kTapMs + 100));
    }

    /// Taps the key of B; again where the machine was so busy meanwhile that it was held.
    void tapB() const
    {
        QElapsedTimer down;
        do {
            down.start();
            QTest::keyClick(m_window->windowHandle(), Qt::Key_B);
        } while (m_window->viewport().compare() == Viewport::Compare::Off && down.hasExpired(Comparison::kTapMs));
    }
};

FUMAGE_TEST_MAIN(WindowCompareTest)
#include "window_compare_test.moc"
