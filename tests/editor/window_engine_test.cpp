// From the window into an engine.
#include "window_fixture.h"

#include "ui/export/engine_dialog.h"
#include "ui/export/export_dialog.h"
#include "ui/export/export_queue.h"
#include "ui/export/mock_stage.h"

#include "core/effect/known_parameter.h"
#include "core/export/loop.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QToolBar>
#include <QToolButton>

using namespace fumage;
using namespace fumage::tests;

class WindowEngineTest : public WindowFixture {
    Q_OBJECT

private slots:
    void twoClicksInTheWindowEndWithASheetThatPlays()
    {
        EngineDialog& dialog = openEngine();
        QTest::mouseClick(childOf<QPushButton>(dialog, u"engine.godot"_q), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(dialog.stage().isPlaying(), 120000);
        QCOMPARE(m_session->exports().rowCount(), 1);
        const QStringList remembered = m_session->settings().list(u"exports/engine"_q, {});
        QCOMPARE(remembered.value(0), u"godot"_q);
        QVERIFY(QFile::exists(m_folder.filePath(u"game/small_4x8.tscn"_q)));
    }

    void aLoopIsClosedInTheOptionsToo()
    {
        Preset preset = smallPreset();
        preset.scene.timeline.loop = true;
        preset.scene.timeline.length = 150;
        m_window->document().load(preset, {});
        EngineDialog& dialog = openEngine();
        childOf<QPushButton>(dialog, u"engine.options"_q)->click();
        const auto* all = m_window->findChild<ExportDialog*>(u"exportDialog"_q);
        const FrameRange frames = all->plan().frames;
        QVERIFY(turnOf(preset.scene.timeline, frames).has_value());
        QCOMPARE(all->plan().flipbook.columns, 8);
        QVERIFY(frames.count() >= 64);
    }

    void moreOptionsAreThoseOfTheExportDialog()
    {
        EngineDialog& dialog = openEngine();
        childOf<QPushButton>(dialog, u"engine.options"_q)->click();
        QVERIFY(!dialog.isVisible());
        auto* all = m_window->findChild<QDialog*>(u"exportDialog"_q);
        QVERIFY(all != nullptr && all->isVisible());
        QCOMPARE(childOf<QComboBox>(*all, u"export.kind"_q)->currentText(), u"Flipbook"_q);
        QCOMPARE(childOf<QComboBox>(*all, u"export.engine"_q)->currentText(), u"Unity"_q);
        QVERIFY(childOf<QCheckBox>(*all, u"export.sixWay"_q)->isChecked());
        QVERIFY(childOf<QCheckBox>(*all, u"export.motion"_q)->isChecked());
        QVERIFY(childOf<QCheckBox>(*all, u"export.fit"_q)->isChecked());
        QCOMPARE(childOf<QLineEdit>(*all, u"export.path"_q)->text(), m_folder.filePath(u"game/small_4x8.png"_q));
    }

private:
    EngineDialog& openEngine()
    {
        m_session->settings().setList(u"exports/engine"_q, {u"unity"_q, u"2048"_q, m_folder.filePath(u"game"_q)});
        m_window->document().edit(
            {{&knownParameter("output.width"), 32}, {&knownParameter("output.height"), 32}}, u"Size"_q);
        const auto* bar = m_window->findChild<QToolBar*>(u"toolBar"_q);
        auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(&m_window->actions().get("file.engine")));
        button->click(); // a narrow window may have put it away
        return *m_window->findChild<EngineDialog*>(u"engineDialog"_q);
    }
};

FUMAGE_TEST_MAIN(WindowEngineTest)
#include "window_engine_test.moc"
