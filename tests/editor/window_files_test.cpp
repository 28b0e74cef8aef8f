// Files of a document: saving, opening, giving up, and what is asked and told on the way.
#include "window_fixture.h"

#include "ui/presets/preset_browser.h"

#include "core/effect/known_parameter.h"
#include "core/export/plan.h"
#include "core/preset/library.h"
#include "core/preset/preset_file.h"

#include <QDragEnterEvent>
#include <QFileDialog>
#include <QInputDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>

using namespace fumage;
using namespace fumage::tests;

class WindowFilesTest : public WindowFixture {
    Q_OBJECT

private slots:
    void whatIsSavedIsWhatIsLoaded()
    {
        const QString path = m_folder.filePath(u"mine.json"_q);
        m_window->document().edit(knownParameter("motion.gravity"), 2.0F);
        QVERIFY(m_window->document().save(path).ok());
        const Effect saved = m_window->document().effect();
        m_window->document().load(Preset(), {});
        QVERIFY(m_window->files().openFile(path));
        QVERIFY(m_window->document().effect() == saved);
        QVERIFY(m_window->windowTitle().contains(u"mine"_q));
        QVERIFY(!m_window->isWindowModified());
        auto* recent = m_window->findChild<QMenu*>(u"file.recent"_q);
        QVERIFY(!recent->actions().isEmpty());
        QCOMPARE(recent->actions().first()->data().toString(), path);
        QVERIFY(recent->toolTipsVisible() && recent->actions().first()->toolTip() == path);
        m_window->document().load(Preset(), {});
        recent->actions().first()->trigger();
        QVERIFY(m_window->document().effect() == saved);
    }

    void unsavedChangesAreAskedAbout()
    {
        m_window->document().edit(knownParameter("motion.gravity"), 2.0F);
        QVERIFY(m_window->isWindowModified());
        answerNext("unsavedBox", [](QMessageBox& box) { pressButton(box, QMessageBox::Cancel); });
        trigger("file.new");
        QCOMPARE(m_window->document().effect().motion.gravity, 2.0F);
        answerNext("unsavedBox", [](QMessageBox& box) { pressButton(box, QMessageBox::Cancel); });
        QVERIFY(!m_window->close());
        answerNext("unsavedBox", [](QMessageBox& box) { pressButton(box, QMessageBox::Discard); });
        trigger("file.new");
        QVERIFY(m_window->document().effect() == newPreset().scene.effect());
    }

    void savingFromTheQuestionKeepsTheWork()
    {
        const QString path = m_folder.filePath(u"kept.json"_q);
        QVERIFY(m_window->document().save(path).ok());
        m_window->document().edit(knownParameter("motion.gravity"), 3.0F);
        answerNext("unsavedBox", [](QMessageBox& box) { pressButton(box, QMessageBox::Save); });
        trigger("file.new");
        QCOMPARE(readPresetFile(path.toStdString()).value().preset.scene.layers[0].motion.gravity, 3.0F);
    }

    void aFileThatIsSavedWhileItIsOpenedAgainIsOpenedAsItIsThen()
    {
        const QString path = m_folder.filePath(u"again.json"_q);
        QVERIFY(m_window->document().save(path).ok());
        m_window->document().edit(knownParameter("motion.gravity"), 3.0F);
        answerNext("unsavedBox", [](QMessageBox& box) { pressButton(box, QMessageBox::Save); });
        QVERIFY(m_window->files().openFile(path));
        QCOMPARE(m_window->document().effect().motion.gravity, 3.0F);
        QVERIFY(!m_window->isWindowModified());
        QCOMPARE(m_window->document().compareWithDisk(), DiskState::Same);
    }

    void aBrokenFileIsToldAboutAndCostsNothing()
    {
        const QString path = m_folder.filePath(u"broken.json"_q);
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("{\n  \"format\": \"fumage-preset\",\n  \"version\": oops }");
        file.close();
        const Effect before = m_window->document().effect();
        QString told;
        answerNext("errorBox", [&told](QMessageBox& box) {
            told = box.text() + u" "_q + box.informativeText();
            pressButton(box, QMessageBox::Ok);
        });
        QVERIFY(!m_window->files().openFile(path));
        QVERIFY2(told.contains(u"line 3"_q), qPrintable(told));
        QVERIFY(m_window->document().effect() == before);
    }

    void aFolderThatCannotBeWrittenToIsToldAbout()
    {
        const QString path = u"/proc/smoke.json"_q; // not even root writes here
        m_window->document().load(smallPreset(), path);
        m_window->document().edit(knownParameter("motion.gravity"), 2.0F);
        QString told;
        answerNext("errorBox", [&told](QMessageBox& box) {
            told = box.text() + u" "_q + box.informativeText();
            pressButton(box, QMessageBox::Ok);
        });
        QVERIFY(!m_window->files().save());
        QVERIFY2(told.contains(u"/proc"_q), qPrintable(told));
        QVERIFY(m_window->document().isModified());
    }

    void aPresetIsCopiedAndPasted()
    {
        m_window->document().edit(knownParameter("motion.gravity"), 2.0F);
        const Effect copied = m_window->document().effect();
        trigger("edit.copyPreset");
        m_window->document().load(smallPreset(), {});
        trigger("edit.pastePreset");
        QVERIFY(m_window->document().effect() == copied);
        trigger("edit.undo");
        QVERIFY(m_window->document().effect() == smallPreset().scene.effect());
    }

    void savingTheFirstTimeAsksForAFile()
    {
        m_chosenFile = m_folder.filePath(u"first.json"_q);
        m_window->document().edit(*findParameter("motion.gravity"), 2.0F);
        trigger("file.save");
        QCOMPARE(m_fileQuestions.size(), 1);
        QCOMPARE(m_fileQuestions[0].purpose, FileQuestion::Purpose::Save);
        QCOMPARE(QFileInfo(m_fileQuestions[0].start).fileName(), u"Small.json"_q);
        QCOMPARE(gravityIn(m_chosenFile), 2.0F);
        QCOMPARE(m_window->document().filePath(), m_chosenFile);
        QVERIFY(!m_window->isWindowModified());
        // It is the document's own now.
        m_window->document().edit(*findParameter("motion.gravity"), 3.0F);
        trigger("file.save");
        QCOMPARE(m_fileQuestions.size(), 1);
        QCOMPARE(gravityIn(m_chosenFile), 3.0F);
    }

    void saveAsLeavesTheOldFileAndGoesOnWithTheNew()
    {
        const QString old = m_folder.filePath(u"old.json"_q);
        QVERIFY(m_window->document().save(old).ok());
        m_window->document().edit(*findParameter("motion.gravity"), 2.0F);
        m_chosenFile = m_folder.filePath(u"new.json"_q);
        trigger("file.saveAs");
        QCOMPARE(m_fileQuestions.size(), 1);
        QCOMPARE(m_fileQuestions[0].start, old);
        QCOMPARE(m_fileQuestions[0].ending, u"json"_q);
        QCOMPARE(gravityIn(old), smallPreset().scene.layers[0].motion.gravity);
        QCOMPARE(gravityIn(m_chosenFile), 2.0F);
        QVERIFY(m_window->windowTitle().contains(u"new"_q) && !m_window->isWindowModified());
        QCOMPARE(m_session->settings().recentFiles().constFirst(), m_chosenFile);
    }

    void fileDialogsBeginWhereTheUserLastWas()
    {
        m_chosenFile = m_folder.filePath(u"first.json"_q);
        trigger("file.saveAs");
        m_window->document().load(smallPreset(), {}); // has no file
        m_chosenFile.clear();
        trigger("file.open");
        QCOMPARE(m_fileQuestions[1].start, m_folder.path());
        trigger("file.saveAs");
        QCOMPARE(m_fileQuestions[2].start, m_folder.filePath(u"Small.json"_q));
    }

    void nothingIsSavedWhereNoFileIsChosen()
    {
        m_window->document().edit(*findParameter("motion.gravity"), 2.0F);
        trigger("file.saveAs");
        QCOMPARE(m_fileQuestions.size(), 1);
        QVERIFY(m_window->isWindowModified() && m_window->document().filePath().isEmpty());
        // Nor is the work given up that was to be saved first.
        answerNext("unsavedBox", [](QMessageBox& box) { pressButton(box, QMessageBox::Save); });
        trigger("file.new");
        QCOMPARE(m_window->document().effect().motion.gravity, 2.0F);
    }

    void theFileThatIsChosenIsOpened()
    {
        m_chosenFile = m_folder.filePath(u"mine.json"_q);
        QVERIFY(m_window->document().save(m_chosenFile).ok());
        m_window->document().edit(*findParameter("motion.gravity"), 2.0F);
        answerNext("unsavedBox", [](QMessageBox& box) { pressButton(box, QMessageBox::Discard); });
        trigger("file.open");
        QCOMPARE(m_fileQuestions.size(), 1);
        QCOMPARE(m_fileQuestions[0].purpose, FileQuestion::Purpose::Open);
        QCOMPARE(m_fileQuestions[0].start, m_folder.path());
        QVERIFY(m_window->document().effect() == smallPreset().scene.effect());
        m_chosenFile.clear();
        trigger("file.open");
        QVERIFY(!m_window->document().filePath().isEmpty());
    }

    void aNameWithASlashIsOfferedAsOneFile()
    {
        Preset preset = smallPreset();
        preset.name = "Smoke / thin";
        m_window->document().load(preset, {});
        trigger("file.saveAs");
        QCOMPARE(QFileInfo(m_fileQuestions[0].start).fileName(), u"Smoke - thin.json"_q);
    }

    void savingToTheLibraryAddsAPresetToTheBrowser()
    {
        PresetList& list = m_window->findChild<PresetBrowser*>()->list();
        const int before = static_cast<int>(builtinPresets().size());
        QTRY_COMPARE(list.count(), before);
        m_window->document().edit(*findParameter("motion.gravity"), 2.0F);
        nameNext(u"Mine / thin"_q);
        trigger("file.saveToLibrary");
        QCOMPARE(gravityIn(libraryFile(u"Mine - thin"_q)), 2.0F);
        QCOMPARE(m_window->document().filePath(), libraryFile(u"Mine - thin"_q));
        QVERIFY(!m_window->isWindowModified());
        QTRY_COMPARE(list.count(), before + 1);
    }

    void aPresetOfTheLibraryIsNotReplacedUnasked()
    {
        nameNext(u"Mine"_q);
        trigger("file.saveToLibrary");
        m_window->document().load(smallPreset(), {});
        m_window->document().edit(*findParameter("motion.gravity"), 2.0F);
        nameNext(u"Mine"_q);
        answerNext("replaceBox", [](QMessageBox& box) { pressButton(box, QMessageBox::No); });
        trigger("file.saveToLibrary");
        QCOMPARE(gravityIn(libraryFile(u"Mine"_q)), smallPreset().scene.layers[0].motion.gravity);
        QVERIFY(m_window->isWindowModified());
        nameNext(u"Mine"_q);
        answerNext("replaceBox", [](QMessageBox& box) { pressButton(box, QMessageBox::Yes); });
        trigger("file.saveToLibrary");
        QCOMPARE(gravityIn(libraryFile(u"Mine"_q)), 2.0F);
    }

    void aPresetWithoutANameIsNotSavedToTheLibrary()
    {
        nameNext(u"  "_q);
        trigger("file.saveToLibrary");
        answerNext<QInputDialog>("libraryName", [](QInputDialog& dialog) { dialog.reject(); });
        trigger("file.saveToLibrary");
        QVERIFY(QDir(toQString(userPresetFolder().string())).entryList({u"*.json"_q}).isEmpty());
        QVERIFY(m_window->document().filePath().isEmpty());
    }

    void revertGoesBackToWhatIsSavedAndIsUndone()
    {
        QVERIFY(m_window->document().save(m_folder.filePath(u"mine.json"_q)).ok());
        m_window->document().edit(*findParameter("motion.gravity"), 2.0F);
        m_window->document().edit(*findParameter("emitter.speed"), 3.0F);
        trigger("file.revert");
        QVERIFY(m_window->document().effect() == smallPreset().scene.effect());
        trigger("edit.undo");
        QCOMPARE(m_window->document().effect().motion.gravity, 2.0F);
        QCOMPARE(m_window->document().effect().emitter.speed, 3.0F);
    }

    void theDialogOffersANameAndAddsItsEnding()
    {
        const FileQuestion question{
            .purpose = FileQuestion::Purpose::Save,
            .title = u"Save"_q,
            .start = m_folder.filePath(u"offered.json"_q),
            .filter = u"Presets (*.json)"_q,
            .ending = u"json"_q,
        };
        QString offered;
        answerNext<QFileDialog>("fileDialog", [&](QFileDialog& dialog) {
            offered = dialog.selectedFiles().constFirst();
            dialog.findChild<QLineEdit*>(u"fileNameEdit"_q)->setText(u"typed"_q);
            static_cast<QDialog&>(dialog).accept();
        });
        QCOMPARE(askInDialog(m_window, question), m_folder.filePath(u"typed.json"_q));
        QCOMPARE(offered, question.start);
        answerNext<QFileDialog>("fileDialog", [](QFileDialog& dialog) { dialog.reject(); });
        QCOMPARE(askInDialog(m_window, question), QString());
    }

    void aFileOrAPresetIsDroppedOnTheWindow()
    {
        const QString path = m_folder.filePath(u"mine.json"_q);
        m_window->document().edit(*findParameter("motion.gravity"), 2.0F);
        QVERIFY(m_window->document().save(path).ok());
        m_window->document().load(smallPreset(), {});
        QMimeData file;
        file.setUrls({QUrl::fromLocalFile(path)});
        drop(file);
        QTRY_COMPARE(m_window->document().effect().motion.gravity, 2.0F);
        QTRY_VERIFY(m_window->findChild<PresetBrowser*>()->list().count() > 0);
        QMimeData preset;
        preset.setData(PresetList::mimeType(), "campfire");
        drop(preset);
        QTRY_VERIFY(m_window->document().effect() == loadPreset("campfire").value().preset.scene.effect());
    }

    void aPictureOpensAsThePresetThatItCarries()
    {
        Preset preset = smallPreset();
        preset.name = "Of a picture";
        preset.scene.layers[0].motion.gravity = 2.0F;
        const QString path = m_folder.filePath(u"smoke.png"_q);
        ExportPlan plan;
        plan.kind = ExportKind::Picture;
        plan.output = path.toStdString();
        plan.frames = {7, 7, 1};
        plan.project = preset;
        QVERIFY(runExport(preset.scene, plan).ok());
        QMimeData file;
        file.setUrls({QUrl::fromLocalFile(path)});
        drop(file);
        QTRY_VERIFY(m_window->document().effect() == preset.scene.effect());
        QVERIFY(m_window->windowTitle().contains(u"Of a picture"_q));
        QCOMPARE(m_window->player().frame(), 7);
        QVERIFY(!m_window->player().isPlaying());
        // Saving asks for a file: the picture stays a picture.
        QVERIFY(m_window->document().filePath().isEmpty());
    }

    void aPictureThatCarriesNothingIsToldAbout()
    {
        const QString path = m_folder.filePath(u"smoke.png"_q);
        ExportPlan plan;
        plan.kind = ExportKind::Picture;
        plan.output = path.toStdString();
        QVERIFY(runExport(smallPreset().scene.effect(), plan).ok());
        QString seen;
        answerNext("errorBox", [&](QMessageBox& box) {
            seen = box.text();
            pressButton(box, QMessageBox::Ok);
        });
        QVERIFY(!m_window->files().openFile(path));
        QVERIFY2(seen.contains(u"carries no preset"_q), qPrintable(seen));
    }

    void aPresetThatOnlyAnotherProgramKnowsIsDroppedInVain()
    {
        QMimeData preset;
        preset.setData(PresetList::mimeType(), "of another program");
        drop(preset);
        QCoreApplication::processEvents();
        QVERIFY(m_window->document().effect() == smallPreset().scene.effect());
    }

private:
    void drop(const QMimeData& data)
    {
        const QPoint at = m_window->rect().center();
        QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(m_window, &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent event(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(m_window, &event);
    }

    static float gravityIn(const QString& path)
    {
        return readPresetFile(path.toStdString()).value().preset.scene.layers[0].motion.gravity;
    }

    static QString libraryFile(const QString& name)
    {
        return QDir(toQString(userPresetFolder().string())).filePath(name + u".json"_q);
    }

    /// Types a name into the next question for one.
    static void nameNext(const QString& name)
    {
        answerNext<QInputDialog>("libraryName", [name](QInputDialog& dialog) {
            dialog.setTextValue(name);
            dialog.accept();
        });
    }
};

FUMAGE_TEST_MAIN(WindowFilesTest)
#include "window_files_test.moc"
