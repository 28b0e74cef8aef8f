// Copies of unsaved work: when they come, who has them, and that none is lost on the way.
#include "editor_helpers.h"

#include "ui/document/key_edits.h"
#include "ui/document/recovery.h"

#include "core/effect/known_parameter.h"
#include "core/preset/preset_file.h"

#include <sys/wait.h>
#include <unistd.h>

using namespace fumage;
using namespace fumage::tests;

class RecoveryTest : public QObject {
    Q_OBJECT

private slots:
    void unsavedWorkIsOnDiskAMomentAfterAChange()
    {
        QTemporaryDir folder;
        Document document;
        Recovery recovery(document, QDir(folder.path()));
        document.edit(knownParameter("motion.gravity"), 7.0F);
        QTRY_COMPARE(QDir(folder.path()).entryList({u"*.json"_q}).size(), 1);
        QVERIFY(isNothing(Recovery::find(QDir(folder.path())))); // its program is running
        document.undoStack()->undo();
        QTRY_COMPARE(QDir(folder.path()).entryList({u"*.json"_q}).size(), 0);
    }

    /// Each frame of what changes over time tells of a change; it is none that a copy waits for, or is written for.
    void unsavedWorkIsOnDiskAlsoWhileKeyFramesArePlayed()
    {
        const QTemporaryDir folder;
        Document document;
        Recovery recovery(document, QDir(folder.path()));
        const QSignalSpy written(&recovery, &Recovery::written);
        addKey(document, knownParameter("glow.emission"));
        QTimer frames;
        int frame = 0;
        connect(&frames, &QTimer::timeout, &document, [&] { document.setSeconds(++frame / 30.0); });
        frames.start(30);
        QTRY_COMPARE(written.count(), 1);
        QCOMPARE(QDir(folder.path()).entryList({u"*.json"_q}).size(), 1);
        const int then = frame;
        QTRY_VERIFY_WITH_TIMEOUT(frame > then + 60, 30000); // long enough for another, did it hold anything else
        QCOMPARE(written.count(), 1);
        document.edit(knownParameter("motion.gravity"), 7.0F);
        QTRY_COMPARE(written.count(), 2);
    }

    /// What is not asked for is not taken away: a file in the place of the copy stays.
    void playingWhatIsSavedDoesNotTouchTheDisk()
    {
        const QTemporaryDir folder;
        Preset preset;
        const Parameter& emission = knownParameter("glow.emission");
        preset.scene.layers[0].tracks.set({&emission, {{0.0, 0.0F}, {2.0, 1.0F}}});
        Document document;
        document.load(preset, {});
        Recovery recovery(document, QDir(folder.path()));
        const QStringList locks = QDir(folder.path()).entryList({u"*.lock"_q}, QDir::Files | QDir::Hidden);
        QCOMPARE(locks.size(), 1);
        QFile file(folder.filePath(locks[0].chopped(5) + u".json"_q));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.close();
        const QSignalSpy changes(&document, &Document::effectChanged);
        document.setSeconds(1.0);
        QCOMPARE(changes.size(), 1);
        QVERIFY(file.exists());
        // What is undone before its copy was written leaves none either.
        document.edit(knownParameter("motion.gravity"), 7.0F);
        document.undoStack()->undo();
        QVERIFY(!file.exists());
    }

    void aCopyThatIsBeingWrittenDoesNotOutliveItsWork()
    {
        const QTemporaryDir folder;
        for (int round = 0; round < 50; ++round) {
            {
                Document document;
                Recovery recovery(document, QDir(folder.path()));
                document.edit(knownParameter("motion.gravity"), 7.0F);
                recovery.save();
                while (round % 2 == 1 && QDir(folder.path()).entryList({u"*.origin"_q}).isEmpty()) {
                    // what is written first is not there yet
                }
                document.undoStack()->undo();
            }
            QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden), QStringList());
        }
    }

    void aCopyStaysUntilTheWorkThatAdoptedItIsSaved()
    {
        const LeftFolder folder;
        Document document;
        {
            Recovery recovery(document, folder.dir());
            Recovery::Leftovers left = Recovery::find(folder.dir());
            QCOMPARE(left.works.size(), std::size_t{1});
            recovery.adopt(std::move(left.works[0]));
            QCOMPARE(document.effect().motion.gravity, 7.0F);
            QVERIFY(document.isModified());
            QVERIFY(isNothing(Recovery::find(folder.dir()))); // its program is running
            QCoreApplication::processEvents();
            QVERIFY(folder.names().contains(u"left.json"_q));
            QVERIFY(document.save(folder.dir().filePath(u"../saved"_q)).ok());
            QVERIFY(!folder.names().contains(u"left.json"_q));
        }
        QVERIFY(folder.names().isEmpty());
    }

    void aProgramThatIsKilledWhileItTakesOverWorkLeavesIt()
    {
        const LeftFolder folder;
        QFile lock(folder.dir().filePath(u"left.lock"_q));
        QVERIFY(lock.open(QIODevice::WriteOnly)); // made, and nothing in it yet
        lock.close();
        QCOMPARE(Recovery::find(folder.dir()).works.size(), std::size_t{1});
    }

    void aProgramThatIsKilledAfterItAdoptedWorkLeavesItAgain()
    {
        const LeftFolder folder;
        adoptAndDie(folder.dir());
        QCOMPARE(Recovery::find(folder.dir()).works.size(), std::size_t{1});
    }

    void workThatEndsProgramsIsNotOpenedAThirdTime()
    {
        const LeftFolder folder;
        adoptAndDie(folder.dir());
        adoptAndDie(folder.dir());
        const Recovery::Leftovers left = Recovery::find(folder.dir());
        QVERIFY(left.works.empty());
        QCOMPARE(left.dangerous, QStringList{folder.dir().filePath(u"left.json"_q)});
        QVERIFY(folder.names().contains(u"left.json"_q));
    }

    void workThatWasShownMayBeOpenedAgain()
    {
        const LeftFolder folder;
        for (int i = 0; i < 3; ++i) {
            adoptAndDie(folder.dir(), true);
        }
        QCOMPARE(Recovery::find(folder.dir()).works.size(), std::size_t{1});
    }

    void copiesAreForTheUserAlone()
    {
        const QTemporaryDir parent;
        const QDir folder(parent.filePath(u"recovery"_q));
        Document document;
        Recovery recovery(document, folder);
        document.edit(knownParameter("motion.gravity"), 7.0F);
        const QSignalSpy written(&recovery, &Recovery::written);
        recovery.save();
        QTRY_COMPARE(written.count(), 1);
        const auto others = QFileDevice::ReadGroup | QFileDevice::WriteGroup | QFileDevice::ExeGroup
            | QFileDevice::ReadOther | QFileDevice::WriteOther | QFileDevice::ExeOther;
        QVERIFY(!(QFile::permissions(folder.path()) & others));
        const QFileInfoList copies = folder.entryInfoList({u"*.json*"_q}, QDir::Files);
        QCOMPARE(copies.size(), 3); // the copy, the path of its document, and the mark of that
        for (const QFileInfo& copy : copies) {
            QVERIFY(!(copy.permissions() & others));
        }
    }

    void aBrokenCopyStaysAndIsMentioned()
    {
        const LeftFolder folder;
        QFile file(folder.dir().filePath(u"left.json"_q));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("{ half a fi");
        file.close();
        const Recovery::Leftovers left = Recovery::find(folder.dir());
        QVERIFY(left.works.empty());
        QCOMPARE(left.unreadable, QStringList{file.fileName()});
        QVERIFY(file.exists());
    }

    void locksOfSessionsThatWereKilledAreClearedAway()
    {
        const QTemporaryDir folder;
        const pid_t session = fork();
        if (session == 0) {
            Document document;
            const Recovery recovery(document, QDir(folder.path()));
            _exit(0);
        }
        waitpid(session, nullptr, 0);
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 1);
        QVERIFY(isNothing(Recovery::find(QDir(folder.path()))));
        QVERIFY(QDir(folder.path()).isEmpty());
    }

    void aCopyIsOnTheDiskAllTheWhileThatItIsAdopted_data() { addOrigins(); }
    void aCopyIsOnTheDiskAllTheWhileThatItIsAdopted()
    {
        const LeftFolder folder(kOrigins.value(QString::fromLatin1(QTest::currentDataTag())));
        Document document;
        Recovery recovery(document, folder.dir());
        int looks = 0;
        int missing = 0;
        const auto look = [&] {
            ++looks;
            missing += folder.names().contains(u"left.json"_q) && folder.names().contains(u"left.json.trial"_q) ? 0 : 1;
        };
        // They hear of it after the recovery has.
        connect(&document, &Document::titleChanged, &document, look);
        connect(&document, &Document::loaded, &document, look);
        connect(&document, &Document::effectChanged, &document, look);
        Recovery::Leftovers left = Recovery::find(folder.dir());
        recovery.adopt(std::move(left.works.at(0)));
        QCOMPARE(document.effect().motion.gravity, 7.0F);
        QVERIFY(document.isModified());
        QVERIFY(looks >= 2);
        QCOMPARE(missing, 0);
        QSignalSpy written(&recovery, &Recovery::written);
        QTRY_COMPARE(written.count(), 1); // the copy is written anew in its place
        look();
        QCOMPARE(missing, 0);
    }

    void aProgramThatIsKilledAsSoonAsItHasAdoptedWorkLeavesIt_data() { addOrigins(); }
    void aProgramThatIsKilledAsSoonAsItHasAdoptedWorkLeavesIt()
    {
        const LeftFolder folder(kOrigins.value(QString::fromLatin1(QTest::currentDataTag())));
        adoptAndDie(folder.dir());
        Recovery::Leftovers left = Recovery::find(folder.dir());
        QCOMPARE(left.works.size(), std::size_t{1});
        QCOMPARE(left.works[0].preset.scene.layers[0].motion.gravity, 7.0F);
        QCOMPARE(left.works[0].originalPath, folder.origin());
        left = {};
        adoptAndDie(folder.dir());
        QCOMPARE(Recovery::find(folder.dir()).dangerous.size(), 1); // it is counted, too
    }

    void workOfAProgramThatIsToldToEndStays()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(u"mine.json"_q);
        QVERIFY(writePresetFile(file.toStdString(), Preset()).ok());
        const QDir copies(folder.filePath(u"recovery"_q));
        FileMark began;
        {
            Document document;
            document.load(Preset(), file);
            began = document.fileMark();
            Recovery recovery(document, copies);
            document.edit(knownParameter("motion.gravity"), 7.0F);
            recovery.leave();
        }
        QVERIFY(copies.entryList({u"*.lock"_q}).isEmpty());
        QVERIFY(writePresetFile(file.toStdString(), presetWith(3.0F)).ok());
        Recovery::Leftovers left = Recovery::find(copies);
        QCOMPARE(left.works.size(), std::size_t{1});
        QCOMPARE(left.works[0].preset.scene.layers[0].motion.gravity, 7.0F);
        QCOMPARE(left.works[0].originalPath, file);
        QVERIFY(!began.isEmpty() && left.works[0].originalMark == began);
        // The file has changed since the work began with it.
        Document document;
        Recovery recovery(document, copies);
        recovery.adopt(std::move(left.works[0]));
        QCOMPARE(document.compareWithDisk(), DiskState::Changed);
    }

    void whatIsKeptForAnEndThatDoesNotComeGoesOnAndGoesAway()
    {
        const QTemporaryDir folder;
        const QDir copies(folder.path());
        const auto kept = [&] { return copies.entryList({u"*.json"_q}).size(); };
        Document document;
        Recovery recovery(document, copies);
        recovery.keep();
        QCOMPARE(kept(), 0);
        document.edit(knownParameter("motion.gravity"), 7.0F);
        recovery.keep(); // at once
        QCOMPARE(kept(), 1);
        QVERIFY(document.save(folder.filePath(u"saved"_q)).ok());
        QCOMPARE(kept(), 0);
        document.edit(knownParameter("motion.gravity"), 8.0F);
        QTRY_COMPARE(kept(), 1);
    }

    void aProgramThatIsToldToEndWithNothingUnsavedLeavesNothing()
    {
        const QTemporaryDir folder;
        {
            Document document;
            Recovery recovery(document, QDir(folder.path()));
            recovery.leave();
        }
        QVERIFY(QDir(folder.path()).isEmpty());
    }

    void whatLayBesideACopyThatIsGoneIsClearedAway()
    {
        const LeftFolder folder(Origin::File);
        QVERIFY(QFile::remove(folder.dir().filePath(u"left.json"_q)));
        QVERIFY(!folder.names().isEmpty());
        QVERIFY(isNothing(Recovery::find(folder.dir())));
        QVERIFY2(folder.names().isEmpty(), qPrintable(folder.names().join(u' ')));
    }

private:
    static Preset presetWith(float gravity)
    {
        Preset preset;
        preset.scene.layers[0].motion.gravity = gravity;
        return preset;
    }

    /// Where the work came from that a copy was made of.
    enum class Origin {
        None,
        File,
        GoneFile
    };
    inline static const QMap<QString, Origin> kOrigins{{u"without a file"_q, Origin::None},
        {u"with a file"_q, Origin::File}, {u"with a file that is gone"_q, Origin::GoneFile}};
    static void addOrigins()
    {
        QTest::addColumn<int>("none");
        for (const QString& name : kOrigins.keys()) {
            QTest::newRow(qPrintable(name)) << 0;
        }
    }

    /// A folder with a copy that has no program.
    class LeftFolder {
    public:
        explicit LeftFolder(Origin origin = Origin::None)
        {
            Preset preset;
            if (origin == Origin::File) {
                static_cast<void>(writePresetFile(m_parent.filePath(u"mine.json"_q).toStdString(), preset));
            }
            m_origin = origin == Origin::None ? QString() : m_parent.filePath(u"mine.json"_q);
            preset.scene.layers[0].motion.gravity = 7.0F;
            dir().mkpath(u"."_q);
            static_cast<void>(writePresetFile(dir().filePath(u"left.json"_q).toStdString(), preset));
            QFile file(dir().filePath(u"left.json.origin"_q));
            if (file.open(QIODevice::WriteOnly)) {
                file.write(m_origin.toUtf8());
            }
        }
        [[nodiscard]] QDir dir() const { return QDir(m_parent.filePath(u"recovery"_q)); }
        /// The path of the work's document; empty: it had none.
        [[nodiscard]] QString origin() const { return m_origin; }
        [[nodiscard]] QStringList names() const { return dir().entryList(QDir::Files | QDir::Hidden); }

    private:
        QTemporaryDir m_parent;
        QString m_origin;
    };

    static bool isNothing(const Recovery::Leftovers& left)
    {
        return left.works.empty() && left.unreadable.isEmpty() && left.dangerous.isEmpty();
    }

    static void adoptAndDie(const QDir& folder, bool shown = false)
    {
        const pid_t program = fork();
        if (program == 0) {
            Document document;
            Recovery recovery(document, folder);
            Recovery::Leftovers left = Recovery::find(folder);
            recovery.adopt(std::move(left.works.at(0)));
            if (shown) {
                recovery.markRecovered();
            }
            _exit(0);
        }
        waitpid(program, nullptr, 0);
    }
};

FUMAGE_TEST_MAIN(RecoveryTest)
#include "recovery_test.moc"
