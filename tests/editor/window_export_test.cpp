// Exports from the window, while one works.
#include "window_fixture.h"

#include "ui/export/export_queue.h"
#include "ui/viewport/viewport.h"

#include "core/effect/known_parameter.h"
#include "core/preset/preset_file.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QSpinBox>
#include <QStatusBar>
#include <QToolButton>

using namespace fumage;
using namespace fumage::tests;

class WindowExportTest : public WindowFixture {
    Q_OBJECT

private slots:
    void aSequenceIsExportedWhileOneWorks()
    {
        QDialog* dialog = openExport();
        childOf<QComboBox>(*dialog, u"export.kind"_q)->setCurrentIndex(0);
        const QString path = m_folder.filePath(u"out/smoke_##.png"_q);
        auto* field = childOf<QLineEdit>(*dialog, u"export.path"_q);
        field->selectAll();
        QTest::keyClicks(field, path);
        childOf<QSpinBox>(*dialog, u"export.first"_q)->setValue(3);
        childOf<QSpinBox>(*dialog, u"export.last"_q)->setValue(6);
        QTest::mouseClick(childOf<QPushButton>(*dialog, u"export.begin"_q), Qt::LeftButton);
        m_window->document().edit(knownParameter("motion.gravity"), 2.0F); // does not touch what is being written
        QTRY_COMPARE_WITH_TIMEOUT(stateOf(0), ExportState::Done, 60000);
        QCOMPARE(
            queue().at(0).job->preset.scene.layers[0].motion.gravity, smallPreset().scene.layers[0].motion.gravity);
        QCOMPARE(QDir(m_folder.filePath(u"out"_q)).entryList({u"*.png"_q}),
            (QStringList{u"smoke_03.png"_q, u"smoke_04.png"_q, u"smoke_05.png"_q, u"smoke_06.png"_q}));
        const QImage image(m_folder.filePath(u"out/smoke_03.png"_q));
        QCOMPARE(image.size(), QSize(128, 128));
        QVERIFY(image.hasAlphaChannel());
    }

    void theFileIsChosenInADialog()
    {
        QDialog* dialog = openExport();
        auto* field = childOf<QLineEdit>(*dialog, u"export.path"_q);
        const QString offered = field->text();
        QTest::mouseClick(childOf<QPushButton>(*dialog, u"export.choose"_q), Qt::LeftButton);
        QCOMPARE(field->text(), offered); // none was chosen
        m_chosenFile = m_folder.filePath(u"chosen_##.png"_q);
        QTest::mouseClick(childOf<QPushButton>(*dialog, u"export.choose"_q), Qt::LeftButton);
        QCOMPARE(m_fileQuestions.size(), 2);
        QCOMPARE(m_fileQuestions[1].purpose, FileQuestion::Purpose::Save);
        QCOMPARE(m_fileQuestions[1].start, offered);
        QVERIFY(m_fileQuestions[1].mayReplace); // that is asked when the export begins
        QCOMPARE(field->text(), m_chosenFile);
        // It is no suggestion: nothing but its ending follows the format.
        childOf<QComboBox>(*dialog, u"export.format"_q)->setCurrentIndex(2);
        QCOMPARE(field->text(), m_folder.filePath(u"chosen_##.exr"_q));
    }

    void aFlipbookIsExported()
    {
        QDialog* dialog = openExport();
        auto* begin = childOf<QPushButton>(*dialog, u"export.begin"_q);
        auto* kind = childOf<QComboBox>(*dialog, u"export.kind"_q);
        QVERIFY(!childOf<QSpinBox>(*dialog, u"export.columns"_q)->isVisible());
        kind->setCurrentIndex(kind->findText(u"Flipbook"_q));
        QVERIFY(childOf<QSpinBox>(*dialog, u"export.columns"_q)->isVisible());
        QVERIFY(childOf<QLineEdit>(*dialog, u"export.path"_q)->text().endsWith(u"_8x8.png"_q));
        auto* field = childOf<QLineEdit>(*dialog, u"export.path"_q);
        field->selectAll();
        QTest::keyClicks(field, m_folder.filePath(u"book.png"_q));
        childOf<QSpinBox>(*dialog, u"export.first"_q)->setValue(0);
        childOf<QSpinBox>(*dialog, u"export.last"_q)->setValue(9);
        QVERIFY(!begin->isEnabled()); // ten frames do not fill 64 cells
        QVERIFY(childOf<QLabel>(*dialog, u"export.files"_q)->text().contains(u"64"_q));
        childOf<QSpinBox>(*dialog, u"export.columns"_q)->setValue(4);
        childOf<QSpinBox>(*dialog, u"export.rows"_q)->setValue(2);
        QVERIFY(begin->isEnabled());
        m_window->document().edit(knownParameter("camera.distance"), 2.0F);
        exportAndWait(*begin);
        QCOMPARE(QImage(m_folder.filePath(u"book.png"_q)).size(), QSize(4 * 128, 2 * 128));
        QVERIFY(QFile::exists(m_folder.filePath(u"book.flipbook.json"_q)));
        QVERIFY(
            childOf<QLabel>(*dialog, u"export.state"_q)->text().contains(u"cut off"_q)); // the camera is in the smoke
        auto* fit = childOf<QPushButton>(*dialog, u"export.fitNow"_q);
        QVERIFY(fit->isVisible());
        m_chosenAnswer = kOverwrite;
        exportAndWait(*fit);
        QVERIFY(childOf<QCheckBox>(*dialog, u"export.fit"_q)->isChecked());
        QVERIFY(!fit->isVisible());
        QVERIFY(!childOf<QLabel>(*dialog, u"export.state"_q)->text().contains(u"cut off"_q));
    }

    void theDialogHasTheKeysOfTheWindow()
    {
        QDialog* dialog = openExport();
        for (const char* id : {"file.quit", "file.save", "edit.undo", "edit.redo"}) {
            const auto* action = m_window->findChild<QAction*>(QLatin1String(id));
            QVERIFY2(dialog->actions().contains(const_cast<QAction*>(action)), id);
        }
        m_window->document().edit(knownParameter("motion.gravity"), 2.0F);
        dialog->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(dialog));
        QTest::keyClick(dialog, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(m_window->document().effect().motion.gravity, smallPreset().scene.layers[0].motion.gravity);
    }

    void anEngineIsThreeClicksAwayInTheNextProgram()
    {
        {
            QDialog* dialog = openExport();
            auto* kind = childOf<QComboBox>(*dialog, u"export.kind"_q);
            kind->setCurrentIndex(kind->findText(u"Flipbook"_q));
            childOf<QComboBox>(*dialog, u"export.engine"_q)->setCurrentText(u"Unity"_q);
            childOf<QCheckBox>(*dialog, u"export.sixWay"_q)->setChecked(false);
            dialog->close();
        }
        MainWindow* next = m_session->openWindow();
        QVERIFY(QTest::qWaitForWindowExposed(next));
        next->findChild<QAction*>(u"file.export"_q)->trigger();
        auto* dialog = next->findChild<QDialog*>(u"exportDialog"_q);
        QCOMPARE(childOf<QComboBox>(*dialog, u"export.kind"_q)->currentText(), u"Flipbook"_q);
        QCOMPARE(childOf<QComboBox>(*dialog, u"export.engine"_q)->currentText(), u"Unity"_q);
        QVERIFY(!childOf<QCheckBox>(*dialog, u"export.sixWay"_q)->isChecked());
        QVERIFY(childOf<QCheckBox>(*dialog, u"export.motion"_q)->isChecked());
        QVERIFY(next->close());
    }

    void anExportIsCancelled()
    {
        QDialog* dialog = openExport();
        auto* field = childOf<QLineEdit>(*dialog, u"export.path"_q);
        field->selectAll();
        QTest::keyClicks(field, m_folder.filePath(u"long/smoke_####.png"_q));
        childOf<QSpinBox>(*dialog, u"export.last"_q)->setValue(5000);
        QTest::mouseClick(childOf<QPushButton>(*dialog, u"export.begin"_q), Qt::LeftButton);
        auto* cancel = childOf<QPushButton>(*dialog, u"export.cancel"_q);
        QTRY_VERIFY(!QDir(m_folder.filePath(u"long"_q)).isEmpty());
        QTest::mouseClick(cancel, Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(stateOf(0), ExportState::Cancelled, 60000);
        // What is there is whole.
        for (const QFileInfo& file : QDir(m_folder.filePath(u"long"_q)).entryInfoList(QDir::Files | QDir::Hidden)) {
            QVERIFY2(!QImage(file.filePath()).isNull(), qPrintable(file.filePath()));
        }
    }

    void closingTheWindowLetsAnExportFinish()
    {
        beginSequence(u"whole/smoke_##.png"_q, 40);
        m_chosenAnswer = 0;
        const QPointer<MainWindow> window(m_window);
        QVERIFY(m_window->close());
        QCOMPARE(m_choiceQuestions.size(), 1);
        QTRY_VERIFY(window == nullptr);
        const QString last = m_folder.filePath(u"whole/smoke_40.png"_q);
        QVERIFY(!QFile::exists(last)); // it was not waited for
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(last), 60000);
        QTRY_COMPARE(stateOf(0), ExportState::Done);
    }

    void anExportThatIsAskedForAsTheWindowClosesIsNotLost()
    {
        const QDialog* dialog = fillSequence(u"last/smoke_##.png"_q, 3, 4);
        saveDocument();
        m_chosenAnswer = 0; // finish
        const QPointer<MainWindow> window(m_window);
        childOf<QPushButton>(*dialog, u"export.begin"_q)->click();
        QVERIFY(!m_window->close()); // its files are still looked for
        QTRY_VERIFY(window == nullptr); // and then it closes by itself
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(m_folder.filePath(u"last/smoke_04.png"_q)), 60000);
        QTRY_COMPARE(stateOf(0), ExportState::Done);
    }

    void quittingWaitsForAnExportThatIsAskedForAndThenClosesAllWindows()
    {
        const QDialog* dialog = fillSequence(u"quit/smoke_##.png"_q, 3, 4);
        saveDocument();
        m_chosenAnswer = 0; // finish
        const QPointer<MainWindow> window(m_window);
        const QPointer<MainWindow> other(m_session->openWindow());
        QVERIFY(QTest::qWaitForWindowExposed(other));
        childOf<QPushButton>(*dialog, u"export.begin"_q)->click();
        QVERIFY(m_window->exports().isBusy());
        trigger("file.quit");
        QTRY_VERIFY(window == nullptr);
        QTRY_VERIFY(other == nullptr);
        QCOMPARE(m_choiceQuestions.size(), 1); // of the last
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(m_folder.filePath(u"quit/smoke_04.png"_q)), 60000);
        QTRY_COMPARE(stateOf(0), ExportState::Done);
    }

    void closingTheWindowStopsAnExport()
    {
        beginSequence(u"part/smoke_####.png"_q, 5000);
        m_chosenAnswer = 1;
        const QPointer<MainWindow> window(m_window);
        QVERIFY(m_window->close());
        QTRY_VERIFY(window == nullptr);
        QCOMPARE(queue().active(), 0);
        QVERIFY(!QFile::exists(m_folder.filePath(u"part/smoke_5000.png"_q)));
    }

    void aWindowThatIsNotClosedGoesOnExporting()
    {
        beginSequence(u"on/smoke_####.png"_q, 5000);
        QVERIFY(!m_window->close());
        QCOMPARE(m_choiceQuestions.size(), 1);
        QCOMPARE(stateOf(0), ExportState::Running);
    }

    void onlyTheLastWindowAsks()
    {
        beginSequence(u"on/smoke_####.png"_q, 5000);
        MainWindow* other = m_session->openWindow();
        QVERIFY(QTest::qWaitForWindowExposed(other));
        QVERIFY(m_window->close());
        QVERIFY(m_choiceQuestions.isEmpty());
        QCOMPARE(stateOf(0), ExportState::Running);
        QVERIFY(!other->close());
        QCOMPARE(m_choiceQuestions.size(), 1);
    }

    void thePanelOfTheExportsComesOnceByItself()
    {
        auto* dock = childOf<QDockWidget>(*m_window, u"dock.queue"_q);
        m_session->settings().setKnowsQueue(false);
        dock->hide();
        QVERIFY(!dock->isVisible());
        const QDialog* dialog = fillSequence(u"a_##.png"_q, 3, 3);
        auto* begin = childOf<QPushButton>(*dialog, u"export.begin"_q);
        const QSize before = m_window->viewport().size();
        exportAndWait(*begin);
        QTRY_VERIFY(dock->isVisible());
        QCOMPARE(m_window->viewport().size(), before);
        QVERIFY(!childOf<QDockWidget>(*m_window, u"dock.presets"_q)
                     ->visibleRegion()
                     .isEmpty()); // which it does not displace
        dock->hide();
        m_chosenAnswer = kOverwrite;
        exportAndWait(*begin);
        QVERIFY(!dock->isVisible()); // the user has put it away
    }

    void exportingAgainTakesTheSmokeAsItIsNow()
    {
        const QDialog* dialog = fillSequence(u"a_##.png"_q, 3, 3);
        exportAndWait(*childOf<QPushButton>(*dialog, u"export.begin"_q));
        m_window->document().edit(knownParameter("motion.gravity"), 2.0F);
        m_chosenAnswer = kSaveAs;
        trigger("file.exportAgain");
        QTRY_COMPARE_WITH_TIMEOUT(stateOf(1), ExportState::Done, 60000);
        QCOMPARE(queue().at(1).job->preset.scene.layers[0].motion.gravity, 2.0F);
        const Result<PresetReading> carried = readPresetFile(m_folder.filePath(u"a-2_03.png"_q).toStdString());
        QVERIFY(carried.ok());
        QCOMPARE(carried.value().preset.scene.layers[0].motion.gravity, 2.0F);
    }

    void filesThatAreThereAreAskedAbout()
    {
        const QString first = m_folder.filePath(u"a_03.png"_q);
        QFile file(first);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.close();
        const QDialog* dialog = fillSequence(u"a_##.png"_q, 3, 4);
        auto* begin = childOf<QPushButton>(*dialog, u"export.begin"_q);
        QTest::mouseClick(begin, Qt::LeftButton); // and is cancelled
        QTRY_COMPARE(m_choiceQuestions.size(), 1);
        QVERIFY(m_choiceQuestions[0].text.contains(first));
        QCOMPARE(m_choiceQuestions[0].answers.front(), u"Save as a-2_##.png"_q); // Return loses nothing
        QTRY_VERIFY(begin->isEnabled());
        QCOMPARE(queue().rowCount(), 0);
        QCOMPARE(QFileInfo(first).size(), 0);
        m_chosenAnswer = kOverwrite;
        exportAndWait(*begin);
        QVERIFY(QFileInfo(first).size() > 0);
    }

    void anExportIsNumberedOn()
    {
        const QDialog* dialog = fillSequence(u"a_##.png"_q, 3, 4);
        auto* begin = childOf<QPushButton>(*dialog, u"export.begin"_q);
        exportAndWait(*begin);
        QVERIFY(m_choiceQuestions.isEmpty());
        m_chosenAnswer = kSaveAs;
        exportAndWait(*begin);
        exportAndWait(*begin);
        QCOMPARE(m_choiceQuestions.size(), 2);
        QVERIFY(QFile::exists(m_folder.filePath(u"a-3_04.png"_q)));
        QCOMPARE(childOf<QLineEdit>(*dialog, u"export.path"_q)->text(), m_folder.filePath(u"a-3_##.png"_q));
    }

    void anExportIsVerifiedAndAgainAfterItWasSpoilt()
    {
        const QDialog* dialog = fillSequence(u"a_##.png"_q, 3, 6);
        childOf<QCheckBox>(*dialog, u"export.manifest"_q)->setChecked(true);
        exportAndWait(*childOf<QPushButton>(*dialog, u"export.begin"_q));
        QVERIFY(QFile::exists(m_folder.filePath(u"a.3-6.manifest.json"_q)));
        childOf<QDockWidget>(*m_window, u"dock.queue"_q)->show();
        auto* verify = childOf<QToolButton>(*m_window, u"queue.verify.button"_q);
        QTRY_VERIFY(verify->isVisible());
        childOf<QListView>(*m_window, u"queue.list"_q)->setCurrentIndex(queue().index(0));
        const auto said = [this] { return queue().index(0).data(ExportQueue::ToldRole).toString(); };
        QTest::mouseClick(verify, Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(said(), u"Verified: 4 files are as they were written"_q, 60000);
        QVERIFY(QFile::resize(m_folder.filePath(u"a_04.png"_q), 100));
        QVERIFY(QFile::remove(m_folder.filePath(u"a_06.png"_q)));
        QTest::mouseClick(verify, Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(
            said(), u"2 of 4 files are not as they were written: a_04.png is broken, a_06.png is missing"_q, 60000);
        // Exported again, with the manifest that was asked for, it is right, and nobody has looked at it yet.
        m_chosenAnswer = kOverwrite;
        trigger("file.exportAgain");
        QTRY_COMPARE_WITH_TIMEOUT(stateOf(1), ExportState::Done, 60000);
        QCOMPARE(queue().at(0).check.state, CheckState::None);
        queue().verify(1);
        QTRY_COMPARE_WITH_TIMEOUT(queue().at(1).check.state, CheckState::Same, 60000);
    }

    void exportingAgainAsksOnce()
    {
        const QDialog* dialog = fillSequence(u"a_##.png"_q, 3, 3);
        exportAndWait(*childOf<QPushButton>(*dialog, u"export.begin"_q));
        m_chosenAnswer = kSaveAs;
        for (int i = 0; i < 3; ++i) {
            trigger("file.exportAgain");
            QTRY_COMPARE_WITH_TIMEOUT(stateOf(i + 1), ExportState::Done, 60000);
        }
        QCOMPARE(m_choiceQuestions.size(), 1);
        QVERIFY(QFile::exists(m_folder.filePath(u"a-4_03.png"_q)));
    }

    void theDialogStandsBesideTheMiddleAndTheSmokeStaysWhereItIs()
    {
        m_window->resize(1200, 800);
        QVERIFY(QTest::qWaitFor([this] { return m_window->width() == 1200; }));
        const QSize before = m_window->viewport().size();
        const QDialog* dialog = openExport();
        QTRY_VERIFY(dialog->frameGeometry().center().x() > m_window->geometry().center().x() + 200);
        exportAndWait(*childOf<QPushButton>(*fillSequence(u"a_##.png"_q, 3, 3), u"export.begin"_q));
        QVERIFY(!m_window->statusBar()->currentMessage().isEmpty());
        QCOMPARE(m_window->viewport().size(), before);
    }

    void anExportThatFailsSaysWhy()
    {
        QDialog* dialog = openExport();
        auto* field = childOf<QLineEdit>(*dialog, u"export.path"_q);
        field->selectAll();
        QTest::keyClicks(field, u"/proc/smoke_##.png"_q);
        QTest::mouseClick(childOf<QPushButton>(*dialog, u"export.begin"_q), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(stateOf(0), ExportState::Failed, 60000);
        QVERIFY(childOf<QLabel>(*dialog, u"export.state"_q)->text().contains(u"/proc"_q));
    }

private:
    static constexpr int kSaveAs = 0; ///< answers
    static constexpr int kOverwrite = 1;

    /// Begins a sequence from frame 0 and waits for its first file.
    void beginSequence(const QString& name, int last)
    {
        const QDialog* dialog = fillSequence(name, 0, last);
        QTest::mouseClick(childOf<QPushButton>(*dialog, u"export.begin"_q), Qt::LeftButton);
        QTRY_VERIFY(!QDir(QFileInfo(m_folder.filePath(name)).path()).isEmpty());
        saveDocument();
    }

    /// Nothing is asked about it.
    void saveDocument() { QVERIFY(m_window->document().save(m_folder.filePath(u"saved.json"_q)).ok()); }

    QDialog* fillSequence(const QString& name, int first, int last)
    {
        QDialog* dialog = openExport();
        auto* field = childOf<QLineEdit>(*dialog, u"export.path"_q);
        field->selectAll();
        QTest::keyClicks(field, m_folder.filePath(name));
        childOf<QSpinBox>(*dialog, u"export.first"_q)->setValue(first);
        childOf<QSpinBox>(*dialog, u"export.last"_q)->setValue(last);
        return dialog;
    }

    void exportAndWait(QPushButton& begin)
    {
        const int row = queue().rowCount();
        QTest::mouseClick(&begin, Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(queue().rowCount() > row && stateOf(row) == ExportState::Done, 60000);
    }

    [[nodiscard]] ExportQueue& queue() { return m_session->exports(); }
    /// As if it waited until it is there.
    [[nodiscard]] ExportState stateOf(int row)
    {
        return row < queue().rowCount() ? queue().at(row).state : ExportState::Waiting;
    }

    QDialog* openExport()
    {
        m_window->document().edit(
            {{&knownParameter("output.width"), 128}, {&knownParameter("output.height"), 128}}, u"Size"_q);
        trigger("file.export");
        return m_window->findChild<QDialog*>(u"exportDialog"_q);
    }
};

FUMAGE_TEST_MAIN(WindowExportTest)
#include "window_export_test.moc"
