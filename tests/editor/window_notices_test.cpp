// What a window says of its document and its file, and what comes of the answers; and what shows or hides all of a
// window.
#include "window_fixture.h"

#include "ui/widgets/message_bar.h"
#include "ui/presets/start_dialog.h"
#include "ui/shell/command_search.h"
#include "ui/shell/preferences.h"
#include "ui/shell/tour.h"
#include "ui/timeline/timeline_bar.h"
#include "ui/viewport/viewport.h"

#include "core/effect/known_parameter.h"
#include "core/preset/library.h"
#include "core/preset/preset_file.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QMenuBar>
#include <QPushButton>
#include <QSpinBox>
#include <QStatusBar>
#include <QToolBar>

using namespace fumage;
using namespace fumage::tests;

class WindowNoticesTest : public WindowFixture {
    Q_OBJECT

private slots:
    void aFileThatOthersChangedIsNotOverwrittenUnasked()
    {
        openMine();
        edit(2.0F);
        writeMine(7.0F);
        trigger("file.save"); // the last answer: cancel
        QCOMPARE(m_choiceQuestions.size(), 1);
        QCOMPARE(m_choiceQuestions[0].name, u"changedOnDiskBox"_q);
        QCOMPARE(gravityOf(mine()), 7.0F);
        QVERIFY(m_window->isWindowModified());
        m_chosenAnswer = 0; // save as
        m_chosenFile = m_folder.filePath(u"other.json"_q);
        trigger("file.save");
        QCOMPARE(gravityOf(mine()), 7.0F);
        QCOMPARE(gravityOf(m_chosenFile), 2.0F);
    }

    void aFileThatOthersChangedIsOverwrittenWhenThatIsWanted()
    {
        openMine();
        edit(2.0F);
        writeMine(7.0F);
        m_chosenAnswer = 1; // overwrite
        trigger("file.save");
        QCOMPARE(gravityOf(mine()), 2.0F);
        QVERIFY(!m_window->isWindowModified());
        edit(3.0F);
        trigger("file.save"); // it is the document's own again
        QCOMPARE(m_choiceQuestions.size(), 1);
        QCOMPARE(gravityOf(mine()), 3.0F);
    }

    void theLastQuestionBeforeClosingAsksTooWhereTheFileHasChanged()
    {
        openMine();
        edit(2.0F);
        writeMine(7.0F);
        answerNext("unsavedBox", [](QMessageBox& box) { pressButton(box, QMessageBox::Save); });
        QVERIFY(!m_window->close());
        QCOMPARE(m_choiceQuestions.size(), 1);
        QCOMPARE(gravityOf(mine()), 7.0F);
    }

    void aWindowSaysThatItsFileHasChangedAndReloadsIt()
    {
        openMine();
        edit(2.0F);
        writeMine(7.0F);
        QTRY_VERIFY(m_window->messages().says(u"notice.onDisk"_q));
        childOf<QPushButton>(*m_window, u"notice.onDisk.0"_q)->click();
        QCOMPARE(m_window->document().effect().motion.gravity, 7.0F);
        QVERIFY(!m_window->isWindowModified() && !m_window->messages().says(u"notice.onDisk"_q));
        trigger("edit.undo");
        QCOMPARE(m_window->document().effect().motion.gravity, 2.0F);
    }

    void aReloadThatFailsIsOfferedAgain()
    {
        openMine();
        QFile half(mine());
        QVERIFY(half.open(QIODevice::WriteOnly) && half.write("{ half a fi") > 0);
        half.close();
        QTRY_VERIFY(m_window->messages().says(u"notice.onDisk"_q));
        answerNext("errorBox", [](QMessageBox& box) { pressButton(box, QMessageBox::Ok); });
        childOf<QPushButton>(*m_window, u"notice.onDisk.0"_q)->click();
        QVERIFY(m_window->messages().says(u"notice.onDisk"_q));
        writeMine(7.0F); // now it is whole
        childOf<QPushButton>(*m_window, u"notice.onDisk.0"_q)->click();
        QCOMPARE(m_window->document().effect().motion.gravity, 7.0F);
        QVERIFY(!m_window->messages().says(u"notice.onDisk"_q));
    }

    void aVersionThatIsKeptIsSavedWithoutAnotherQuestion()
    {
        openMine();
        writeMine(7.0F);
        QTRY_VERIFY(m_window->messages().says(u"notice.onDisk"_q));
        childOf<QPushButton>(*m_window, u"notice.onDisk.1"_q)->click();
        QVERIFY(m_window->isWindowModified());
        trigger("file.save");
        QVERIFY(m_choiceQuestions.isEmpty());
        QCOMPARE(gravityOf(mine()), 1.0F);
        QVERIFY(!m_window->messages().says(u"notice.onDisk"_q));
    }

    void twoWindowsOnOneFileKnowOfOneAnother()
    {
        openMine();
        MainWindow* other = m_session->openWindow();
        QVERIFY(other->files().openFile(mine()));
        other->document().edit(knownParameter("motion.gravity"), 4.0F);
        QVERIFY(other->files().save());
        edit(2.0F);
        trigger("file.save");
        QCOMPARE(gravityOf(mine()), 4.0F);
        QTRY_VERIFY(m_window->messages().says(u"notice.onDisk"_q));
        QVERIFY(!other->messages().says(u"notice.onDisk"_q));
    }

    void aFileThatIsGoneIsSaidAndSavedAnew()
    {
        openMine();
        QVERIFY(QFile::remove(mine()));
        QTRY_VERIFY(m_window->messages().says(u"notice.onDisk"_q));
        QVERIFY(m_window->isWindowModified());
        childOf<QPushButton>(*m_window, u"notice.onDisk.0"_q)->click();
        QCOMPARE(gravityOf(mine()), 1.0F);
        QVERIFY(!m_window->isWindowModified() && !m_window->messages().says(u"notice.onDisk"_q));
    }

    void whatWasSaidOfADocumentGoesWithIt()
    {
        openMine();
        m_window->notices().sayRecovered();
        m_window->notify(u"of this document"_q);
        writeMine(7.0F);
        QTRY_VERIFY(m_window->messages().says(u"notice.onDisk"_q));
        m_window->document().load(smallPreset(), {});
        QVERIFY(!m_window->messages().says(u"notice.recovered"_q) && !m_window->messages().says(u"notice.onDisk"_q));
        QCOMPARE(m_window->statusBar()->currentMessage(), QString());
        QVERIFY(!m_window->messages().isVisible());
    }

    void recoveredWorkIsDiscardedAndHadBack()
    {
        Preset work = smallPreset();
        work.scene.layers[0].motion.gravity = 9.0F;
        writeMine(1.0F);
        m_window->document().loadUnsaved(work, mine());
        m_window->notices().sayRecovered();
        childOf<QPushButton>(*m_window, u"notice.recovered.1"_q)->click();
        QCOMPARE(m_window->document().effect().motion.gravity, 1.0F);
        QVERIFY(!m_window->isWindowModified() && !m_window->messages().says(u"notice.recovered"_q));
        trigger("edit.redo");
        QCOMPARE(m_window->document().effect().motion.gravity, 9.0F);
    }

    void workThatBeganWithAnOlderFileIsNotSavedOverTheNewerOneUnasked()
    {
        openMine();
        const FileMark began = m_window->document().fileMark();
        writeMine(7.0F);
        Preset work = smallPreset();
        work.scene.layers[0].motion.gravity = 9.0F;
        m_window->document().loadUnsaved(work, mine(), began);
        trigger("file.save");
        QCOMPARE(m_choiceQuestions.size(), 1);
        QCOMPARE(gravityOf(mine()), 7.0F);
    }

    void allNewDocumentsAreTheSame()
    {
        const Effect expected = newPreset().scene.effect();
        trigger("file.new");
        QVERIFY(m_window->document().effect() == expected);
        trigger("file.newWindow");
        QVERIFY(otherWindow()->document().effect() == expected && !otherWindow()->isWindowModified());
        delete otherWindow();
        const QString broken = m_folder.filePath(u"broken.json"_q);
        QFile file(broken);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("{") == 1);
        file.close();
        answerNext("errorBox", [](QMessageBox& box) { pressButton(box, QMessageBox::Ok); });
        m_session->start({broken});
        QVERIFY(otherWindow()->document().effect() == expected);
    }

    void nothingOfOneDocumentIsSeenUnderTheNameOfAnother()
    {
        QVERIFY(!settled().isNull());
        int shown = 0;
        Preset other = smallPreset();
        other.scene.layers[0].motion.gravity = 2.0F;
        connect(&m_window->viewport(), &Viewport::pictureShown, this, [&] { ++shown; });
        m_window->document().load(other, {});
        QVERIFY(m_window->viewport().picture() == nullptr);
        QCOMPARE(shown, 0);
        QVERIFY(!settled().isNull());
        QVERIFY(shown > 0);
    }

    void namesWithDotsAreNotCutAndGetTheirEnding()
    {
        const FileQuestion question{.purpose = FileQuestion::Purpose::Save,
            .title = u"Save"_q,
            .start = m_folder.filePath(u"a.json"_q),
            .filter = u"Presets (*.json)"_q,
            .ending = u"json"_q};
        for (const QString& name :
            {u"smoke v1.2"_q, u"0.1"_q, u"a.b.c"_q, u"plain"_q, u"whole.json"_q, u"LOUD.JSON"_q}) {
            answerNext<QFileDialog>("fileDialog", [name](QFileDialog& dialog) {
                dialog.findChild<QLineEdit*>(u"fileNameEdit"_q)->setText(name);
                static_cast<QDialog&>(dialog).accept();
            });
            const QString path = askInDialog(m_window, question);
            QVERIFY2(path.endsWith(u".json"_q, Qt::CaseInsensitive), qPrintable(path));
            const QString bare = name.endsWith(u".json"_q, Qt::CaseInsensitive) ? name.chopped(5) : name;
            m_window->document().load(smallPreset(), path);
            QCOMPARE(m_window->document().displayName(), bare);
            QVERIFY2(m_window->windowTitle().startsWith(bare + u"[*]"_q), qPrintable(m_window->windowTitle()));
        }
    }

    void anEndingThatIsAddedDoesNotWriteOverAFileUnasked()
    {
        writeMine(1.0F);
        QVERIFY(QFile::rename(mine(), m_folder.filePath(u"v1.2.json"_q)));
        const FileQuestion question{.purpose = FileQuestion::Purpose::Save,
            .title = u"Save"_q,
            .start = m_folder.filePath(u"a.json"_q),
            .filter = u"Presets (*.json)"_q,
            .ending = u"json"_q};
        answerNext<QFileDialog>("fileDialog", [](QFileDialog& dialog) {
            dialog.findChild<QLineEdit*>(u"fileNameEdit"_q)->setText(u"v1.2"_q);
            answerNext("replaceFileBox", [](QMessageBox& box) {
                QCOMPARE(box.standardButton(box.defaultButton()), QMessageBox::No);
                answerNext<QFileDialog>("fileDialog", [](QFileDialog& again) { again.reject(); });
                pressButton(box, QMessageBox::No);
            });
            static_cast<QDialog&>(dialog).accept();
        });
        QCOMPARE(askInDialog(m_window, question), QString());
    }

    void onlyTheSmokeIsNothingButTheSmoke()
    {
        const QImage smoke = settled();
        m_window->messages().say(u"notice.left"_q, u"Something"_q, {});
        m_window->actions().get("view.smokeOnly").setChecked(true);
        for (const QWidget* part :
            {static_cast<QWidget*>(m_window->menuBar()), static_cast<QWidget*>(m_window->statusBar()),
                static_cast<QWidget*>(m_window->findChild<TimelineBar*>())}) {
            QVERIFY(!part->isVisible());
        }
        QVERIFY(!m_window->messages().isVisible() && m_window->messages().says(u"notice.left"_q));
        QTRY_VERIFY(!settled().isNull() && settled().size() != smoke.size()); // the whole window is its
        const QImage seen = m_window->viewport().surface()->grab().toImage().convertToFormat(QImage::Format_RGB32);
        const QImage picture = settled().convertToFormat(QImage::Format_RGB32);
        QCOMPARE(seen.size(), picture.size());
        QVERIFY(seen == picture);
        QTest::keyClick(m_window, Qt::Key_Escape);
        QVERIFY(m_window->menuBar()->isVisible() && !m_window->actions().get("view.smokeOnly").isChecked());
    }

    void theStartDialogIsOpenedAgainAndSwitchedOnAgain()
    {
        m_session->settings().setShowsStartDialog(false);
        trigger("file.start");
        auto* start = m_window->findChild<StartDialog*>();
        QVERIFY(start != nullptr && start->isVisible());
        auto* again = childOf<QCheckBox>(*start, u"startAgain"_q);
        QVERIFY(!again->isChecked());
        again->setChecked(true);
        childOf<QPushButton>(*start, u"startDefault"_q)->click();
        QVERIFY(m_session->settings().showsStartDialog());
        QVERIFY(m_window->document().effect() == newPreset().scene.effect());
    }

    void theTourShowsTheRealControls()
    {
        m_window->docks().arrange();
        QCoreApplication::processEvents();
        trigger("help.tour");
        const QPointer<Tour> tour = m_window->findChild<Tour*>();
        QVERIFY(tour && tour->isVisible());
        QSet<const QWidget*> seen;
        for (int i = 0; i < 6 && tour->isVisible(); ++i) {
            QVERIFY(tour->target()->isVisible());
            QVERIFY(m_window->rect().contains(tour->geometry()));
            seen += tour->target();
            tour->next();
        }
        QCOMPARE(seen.size(), 6);
        QVERIFY(seen.contains(&m_window->viewport()));
        const auto* bar = childOf<QToolBar>(*m_window, u"toolBar"_q);
        for (const char* action : {"file.engine", "file.export"}) {
            QVERIFY(seen.contains(bar->widgetForAction(&m_window->actions().get(action))));
        }
        QTRY_VERIFY(tour.isNull());
        trigger("help.tour");
        QTest::keyClick(m_window->findChild<Tour*>(), Qt::Key_Escape);
        QTRY_VERIFY(m_window->findChild<Tour*>() == nullptr);
    }

    void aChoiceThatIsGoneFromItsMenuIsChosenInVain()
    {
        Settings& settings = m_session->settings();
        const QString path = u"/nowhere/fire & smoke.json"_q;
        settings.addRecentFile(path);
        CommandSearch search(m_window->actions(), m_window);
        childOf<QLineEdit>(search, u"commandSearch.text"_q)->setText(u"smoke.json"_q);
        auto* list = childOf<QListWidget>(search, u"commandSearch.list"_q);
        const QList<QListWidgetItem*> found = list->findItems(u"fire & smoke.json"_q, Qt::MatchContains);
        QCOMPARE(found.size(), 1);
        list->setCurrentItem(found[0]);
        settings.removeRecentFile(path); // as another window does that finds no such file
        emit list->itemClicked(found[0]);
        QCOMPARE(search.result(), static_cast<int>(QDialog::Accepted));
    }

    void preferencesAreFoundByTheWordsThatPeopleUse()
    {
        for (const QString& word :
            {u"preferences"_q, u"settings"_q, u"start"_q, u"welcome"_q, u"begin"_q, u"options"_q}) {
            CommandSearch search(m_window->actions(), m_window);
            childOf<QLineEdit>(search, u"commandSearch.text"_q)->setText(word);
            const auto* list = childOf<QListWidget>(search, u"commandSearch.list"_q);
            bool found = false;
            for (int i = 0; i < list->count(); ++i) {
                const QString text = list->item(i)->text();
                found = found
                    || (!list->item(i)->isHidden()
                        && (text.contains(u"Preferences"_q) || text.contains(u"New from a preset"_q)));
            }
            QVERIFY2(found, qPrintable(word));
        }
    }

    void preferencesAreRememberedAndTakeEffect()
    {
        Settings& settings = m_session->settings();
        Preferences preferences(*m_session, m_window);
        const auto choose = [&](const char* name, int index) {
            auto* list = childOf<QComboBox>(preferences, QString::fromLatin1(name));
            list->setCurrentIndex(index);
            emit list->activated(index);
        };
        choose("preferences.theme", 2);
        QCOMPARE(settings.theme(), Theme::Light);
        choose("preferences.navigation", 1);
        QCOMPARE(m_window->viewport().navigationStyle(), NavigationStyle::Maya);
        choose("preferences.openGl", 2);
        QCOMPARE(settings.openGl(), OpenGlChoice::Never);
        choose("preferences.language", 2);
        QCOMPARE(settings.language(), u"sv"_q);
        childOf<QCheckBox>(preferences, u"preferences.start"_q)->setChecked(!settings.showsStartDialog());
        childOf<QSpinBox>(preferences, u"preferences.memory"_q)->setValue(64);
        QCOMPARE(Settings().pictureMegabytes(), 64);
        // A page that is opened anew shows what was chosen.
        const Preferences again(*m_session, m_window);
        QCOMPARE(childOf<QComboBox>(again, u"preferences.theme"_q)->currentIndex(), 2);
        QCOMPARE(childOf<QComboBox>(again, u"preferences.language"_q)->currentIndex(), 2);
        QCOMPARE(childOf<QSpinBox>(again, u"preferences.memory"_q)->value(), 64);
        choose("preferences.theme", 0);
        choose("preferences.navigation", 0);
        choose("preferences.openGl", 0);
        choose("preferences.language", 0);
    }

    void coloursHaveTheirValuesInTheHistory()
    {
        edit(2.0F);
        m_window->document().edit(knownParameter("output.background_colour"), glm::vec3(1.0F, 0.0F, 0.0F));
        QVERIFY2(m_window->document().undoStack()->undoText().contains(u"#ff0000"_q),
            qPrintable(m_window->document().undoStack()->undoText()));
    }

private:
    [[nodiscard]] QString mine() const { return m_folder.filePath(u"mine.json"_q); }
    void edit(float gravity) { m_window->document().edit(knownParameter("motion.gravity"), gravity); }
    void writeMine(float gravity) const
    {
        Preset preset = smallPreset();
        preset.scene.layers[0].motion.gravity = gravity;
        QVERIFY(writePresetFile(mine().toStdString(), preset).ok());
    }
    void openMine()
    {
        writeMine(1.0F);
        QVERIFY(m_window->files().openFile(mine()));
    }
    static float gravityOf(const QString& path)
    {
        return readPresetFile(path.toStdString()).value().preset.scene.layers[0].motion.gravity;
    }
};

FUMAGE_TEST_MAIN(WindowNoticesTest)
#include "window_notices_test.moc"
