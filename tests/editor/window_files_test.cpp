// Files of a document: saving, opening, giving up, and what is asked and told on the way.
#include "window_fixture.h"

#include "core/effect/known_parameter.h"
#include "core/preset/preset.h"

#include <QMenu>

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
        QVERIFY(m_window->document().effect() == Effect());
    }

    void savingFromTheQuestionKeepsTheWork()
    {
        const QString path = m_folder.filePath(u"kept.json"_q);
        QVERIFY(m_window->document().save(path).ok());
        m_window->document().edit(knownParameter("motion.gravity"), 3.0F);
        answerNext("unsavedBox", [](QMessageBox& box) { pressButton(box, QMessageBox::Save); });
        trigger("file.new");
        QCOMPARE(readPresetFile(path.toStdString()).value().preset.effect.motion.gravity, 3.0F);
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
        QVERIFY(m_window->document().effect() == smallPreset().effect);
    }
};

FUMAGE_TEST_MAIN(WindowFilesTest)
#include "window_files_test.moc"
