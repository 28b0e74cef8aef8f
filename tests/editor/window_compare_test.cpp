// Two effects beside one another.
#include "window_fixture.h"

#include "ui/viewport/viewport.h"

#include "core/effect/known_parameter.h"

#include <QElapsedTimer>

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
        QVERIFY(m_window->document().effect() == smallPreset().effect);
    }

    void bIsSeenWhileItsKeyIsHeld()
    {
        Viewport& viewport = m_window->viewport();
        QWidget* surface = viewport.surface();
        surface->setFocus();
        QTest::keyClick(surface, Qt::Key_B); // a tap stays
        QCOMPARE(viewport.compare(), Viewport::Compare::Other);
        QTest::keyClick(surface, Qt::Key_B);
        QCOMPARE(viewport.compare(), Viewport::Compare::Off);
        QTest::keyPress(surface, Qt::Key_B);
        QCOMPARE(viewport.compare(), Viewport::Compare::Other);
        QElapsedTimer held;
        held.start();
        QTRY_VERIFY(held.elapsed() > 400);
        QTest::keyRelease(surface, Qt::Key_B);
        QCOMPARE(viewport.compare(), Viewport::Compare::Off);
    }
};

FUMAGE_TEST_MAIN(WindowCompareTest)
#include "window_compare_test.moc"
