// Files that others change, take away or put back while a document is open.
#include "editor_helpers.h"

#include "ui/document/file_watch.h"

#include "core/system/file.h"
#include "core/effect/known_parameter.h"
#include "core/preset/preset_file.h"

using namespace fumage;
using namespace fumage::tests;

class FileWatchTest : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        QVERIFY(write(m_path, 1.0F));
        m_document.load(readPresetFile(m_path.toStdString()).value().preset, m_path);
    }

    void whatIsWrittenHereIsNoChange()
    {
        FileWatch watch(m_document);
        QSignalSpy changed(&watch, &FileWatch::changed);
        for (const float gravity : {2.0F, 3.0F}) {
            m_document.edit(knownParameter("motion.gravity"), gravity);
            QVERIFY(m_document.save(m_path).ok());
            QCOMPARE(watch.look(), DiskState::Same);
        }
        QCOMPARE(changed.count(), 0);
    }

    void aFileThatIsTouchedIsNoChange()
    {
        FileWatch watch(m_document);
        QSignalSpy changed(&watch, &FileWatch::changed);
        const std::string text = readFile(m_path.toStdString(), kMaxPresetBytes).value();
        QVERIFY(writeFileAtomically(m_path.toStdString(), text).ok()); // another file, another time, the same contents
        QCOMPARE(watch.look(), DiskState::Same);
        QCOMPARE(changed.count(), 0);
    }

    void aChangeByAnotherIsHeardOfUnasked()
    {
        FileWatch watch(m_document);
        QVERIFY(write(m_path, 5.0F)); // put in its place, as most programs do
        QTRY_COMPARE(watch.state(), DiskState::Changed);
        QVERIFY(!m_document.isModified());
        m_document.keepOverDisk();
        QCOMPARE(watch.state(), DiskState::Same);
        QVERIFY(m_document.isModified());
        QFile file(m_path); // written in place, as some do
        QVERIFY(file.open(QIODevice::Append) && file.write("\n") == 1);
        file.close();
        QTRY_COMPARE(watch.state(), DiskState::Changed);
    }

    void whatWasReloadedCanBeUndone()
    {
        m_document.edit(knownParameter("motion.gravity"), 3.0F);
        QVERIFY(write(m_path, 5.0F));
        QCOMPARE(m_document.compareWithDisk(), DiskState::Changed);
        QVERIFY(m_document.reload().ok());
        QCOMPARE(m_document.effect().motion.gravity, 5.0F);
        QCOMPARE(m_document.reference().motion.gravity, 5.0F);
        QVERIFY(!m_document.isModified());
        QCOMPARE(m_document.compareWithDisk(), DiskState::Same);
        m_document.undoStack()->undo();
        QCOMPARE(m_document.effect().motion.gravity, 3.0F);
        QVERIFY(m_document.isModified());
        m_document.undoStack()->redo();
        QVERIFY(!m_document.isModified());
    }

    void aFileThatCannotBeReadAgainChangesNothing()
    {
        QVERIFY(writeFileAtomically(m_path.toStdString(), std::string_view("{ half a fi")).ok());
        QCOMPARE(m_document.compareWithDisk(), DiskState::Changed);
        QVERIFY(!m_document.reload().ok());
        QCOMPARE(m_document.effect().motion.gravity, 1.0F);
        QCOMPARE(m_document.compareWithDisk(), DiskState::Changed);
    }

    void aDocumentWhoseFileIsGoneIsUnsavedUntilItIsBack()
    {
        FileWatch watch(m_document);
        const QString away = m_path + u".away"_q;
        QVERIFY(QFile::rename(m_path, away));
        QTRY_COMPARE(watch.state(), DiskState::Gone);
        QVERIFY(m_document.isModified());
        QVERIFY(QFile::rename(away, m_path));
        QTRY_COMPARE(watch.state(), DiskState::Same);
        QVERIFY(!m_document.isModified());
        QVERIFY(QFile::remove(m_path));
        QCOMPARE(watch.look(), DiskState::Gone);
        QVERIFY(m_document.save(m_path).ok());
        QCOMPARE(watch.state(), DiskState::Same);
        QVERIFY(!m_document.isModified());
    }

    void aFileThatWasNotThereAndIsNowIsAChange()
    {
        const QString later = m_folder.filePath(u"later.json"_q);
        m_document.load(Preset(), later);
        QCOMPARE(m_document.compareWithDisk(), DiskState::Same);
        QVERIFY(write(later, 2.0F));
        QCOMPARE(m_document.compareWithDisk(), DiskState::Changed);
        QVERIFY(QFile::remove(later));
    }

    void whatChangedBetweenReadingAndLoadingIsAChange()
    {
        const FileMark read = markOfFile(m_path);
        const Preset preset = readPresetFile(m_path.toStdString()).value().preset;
        QVERIFY(write(m_path, 5.0F));
        m_document.load(preset, m_path, false, read);
        QCOMPARE(m_document.compareWithDisk(), DiskState::Changed);
    }

private:
    [[nodiscard]] static bool write(const QString& path, float gravity)
    {
        Preset preset;
        preset.scene.layers[0].motion.gravity = gravity;
        return writePresetFile(path.toStdString(), preset).ok();
    }

    QTemporaryDir m_folder;
    QString m_path = m_folder.filePath(u"mine.json"_q);
    Document m_document;
};

FUMAGE_TEST_MAIN(FileWatchTest)
#include "file_watch_test.moc"
