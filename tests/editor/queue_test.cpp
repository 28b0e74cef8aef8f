// The queue of exports and its panel: order, names, what ends in the middle, and what is on the disk meanwhile.
#include "editor_helpers.h"

#include "ui/export/file_conflict.h"
#include "ui/export/queue_panel.h"
#include "ui/theme/theme.h"

#include "core/system/file.h"
#include "core/export/jobs/job_file.h"

#include <QAction>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>

#include <csignal>

#include <sys/resource.h>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr int kEndMs = 60000;

Preset tinyPreset()
{
    Preset preset;
    preset.scene.layers[0].emitter.count = 200;
    preset.scene.layers[0].noise.resolution = 16;
    preset.scene.layers[0].noise.slices = 2;
    preset.scene.light.resolution = 16;
    preset.scene.output.width = 24;
    preset.scene.output.height = 16;
    return preset;
}

/// Files may have so many bytes while it is there, as on a disk that is nearly full.
class FileLimit {
public:
    explicit FileLimit(rlim_t bytes)
    {
        getrlimit(RLIMIT_FSIZE, &m_before);
        rlimit tight = m_before;
        tight.rlim_cur = bytes;
        std::signal(SIGXFSZ, SIG_IGN); // as the program has it
        setrlimit(RLIMIT_FSIZE, &tight);
    }
    ~FileLimit() { setrlimit(RLIMIT_FSIZE, &m_before); }
    FileLimit(const FileLimit&) = delete;
    FileLimit& operator=(const FileLimit&) = delete;

private:
    rlimit m_before{};
};

} // namespace

class QueueTest : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_queue = std::make_unique<ExportQueue>(queueFolder());
        m_panel =
            std::make_unique<QueuePanel>(*m_queue, [this](QWidget*, const FileQuestion&) { return m_chosenFile; });
        m_panel->resize(320, 400);
        m_panel->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_panel.get()));
    }
    void cleanup()
    {
        m_panel.reset();
        m_queue.reset();
        m_folder.reset();
    }

    void exportsAreDoneOneAfterTheOther()
    {
        QList<quint64> ended;
        connect(m_queue.get(), &ExportQueue::ended, this, [&](quint64 id) {
            ended += id;
            QVERIFY(
                m_queue->active() == 0 || m_queue->at(static_cast<int>(ended.size())).state == ExportState::Running);
        });
        const QList<quint64> added{add("a"), add("b"), add("c")};
        QCOMPARE(stateOf(0), ExportState::Running);
        QCOMPARE(stateOf(1), ExportState::Waiting);
        QTRY_COMPARE_WITH_TIMEOUT(m_queue->active(), 0, kEndMs);
        QCOMPARE(ended, added);
        QCOMPARE(filesWritten(), (QStringList{u"a.png"_q, u"b.png"_q, u"c.png"_q}));
    }

    void whatWaitsIsPutInAnotherOrder()
    {
        addLong();
        add("b");
        add("c");
        choose(2);
        action("queue.up")->trigger();
        QCOMPARE(names(), (QStringList{u"long"_q, u"c"_q, u"b"_q}));
        QCOMPARE(list()->currentIndex().row(), 1); // what is chosen stays so
        QVERIFY(m_queue->moveRow({}, 2, {}, 0)); // as the list does where one is dropped
        QCOMPARE(names(), (QStringList{u"b"_q, u"long"_q, u"c"_q}));
        choose(0);
        QVERIFY(!action("queue.up")->isEnabled());
        action("queue.down")->trigger();
        QCOMPARE(names(), (QStringList{u"long"_q, u"b"_q, u"c"_q}));
        m_queue->moveRow({}, 2, {}, 1);
        QTRY_COMPARE(namesOnDisk(), (QStringList{u"long"_q, u"c"_q, u"b"_q}));
        QStringList ended;
        connect(m_queue.get(), &ExportQueue::ended, this,
            [&](quint64 id) { ended += toQString(m_queue->find(id)->job->name); });
        m_queue->cancel(0);
        QTRY_COMPARE_WITH_TIMEOUT(ended, (QStringList{u"long"_q, u"c"_q, u"b"_q}), kEndMs);
    }

    void anExportIsRenamedWhereItStands()
    {
        addLong();
        choose(0);
        action("queue.rename")->trigger();
        auto* field = list()->findChild<QLineEdit*>();
        QVERIFY(field != nullptr);
        field->selectAll();
        QTest::keyClicks(field, u"  Night run  "_q);
        QTest::keyClick(field, Qt::Key_Return);
        QTRY_COMPARE(names(), QStringList{u"Night run"_q});
        QTRY_COMPARE(namesOnDisk(), QStringList{u"Night run"_q});
        QVERIFY(!m_queue->setData(m_queue->index(0), u"   "_q, Qt::EditRole));
        QCOMPARE(names(), QStringList{u"Night run"_q});
    }

    void cancellingKeepsWhatIsCompleteAndTheNextOneBegins()
    {
        addLong();
        add("b");
        add("c");
        QTRY_VERIFY(!filesWritten().isEmpty());
        choose(1);
        QCOMPARE(action("queue.stop")->text(), u"Cancel"_q);
        QTest::keyClick(list(), Qt::Key_Delete);
        QCOMPARE(stateOf(1), ExportState::Cancelled);
        QCOMPARE(action("queue.stop")->text(), u"Remove"_q);
        choose(0);
        action("queue.stop")->trigger();
        QTRY_COMPARE_WITH_TIMEOUT(stateOf(0), ExportState::Cancelled, kEndMs);
        QTRY_COMPARE_WITH_TIMEOUT(stateOf(2), ExportState::Done, kEndMs);
        QVERIFY(!filesWritten().contains(u"b.png"_q));
        action("queue.stop")->trigger();
        QCOMPARE(names(), (QStringList{u"b"_q, u"c"_q}));
        action("queue.clear")->trigger();
        QCOMPARE(m_queue->rowCount(), 0);
    }

    void oneThatFailsSaysWhyAndTheOthersAreDone()
    {
        add("a");
        static_cast<void>(m_queue->add(jobFor("b", "/proc/nowhere/b.png")));
        ExportJob large = jobFor("large", at("large.png"));
        large.preset.scene.output.width = large.preset.scene.output.height = 600;
        large.plan.format = ImageFormat::ExrFloat;
        large.plan.output = at("large.exr");
        static_cast<void>(m_queue->add(std::move(large)));
        add("d");
        {
            const FileLimit limit(100'000);
            QTRY_COMPARE_WITH_TIMEOUT(m_queue->active(), 0, kEndMs);
        }
        QCOMPARE((QList<ExportState>{stateOf(0), stateOf(1), stateOf(2), stateOf(3)}),
            (QList<ExportState>{ExportState::Done, ExportState::Failed, ExportState::Failed, ExportState::Done}));
        QVERIFY2(m_queue->at(1).told.contains(u"/proc/nowhere"_q), qPrintable(m_queue->at(1).told));
        QVERIFY2(m_queue->at(2).told.contains(u"large.exr"_q), qPrintable(m_queue->at(2).told));
        QCOMPARE(filesWritten(), (QStringList{u"a.png"_q, u"d.png"_q}));
        // With room on the disk it is done as it was asked for.
        choose(2);
        action("queue.start")->trigger();
        QTRY_COMPARE_WITH_TIMEOUT(stateOf(2), ExportState::Done, kEndMs);
    }

    void twoExportsNeverWriteOneFile()
    {
        addLong();
        add("b");
        QStringList asked;
        int answer = 1;
        const auto ask = [&](QWidget*, const ChoiceQuestion& question) {
            asked += question.text;
            return answer;
        };
        std::optional<ConflictPolicy> answered;
        const ExportPlan plan = jobFor("again", at("b.png")).plan;
        QVERIFY(!settled(nullptr, ask, findClash({{}, {}, plan}, m_queue->activeJobs()), plan, answered)); // given up
        QVERIFY2(asked.size() == 1 && asked[0].contains(u"b.png"_q), qPrintable(asked.join(u' ')));
        answer = 0;
        const std::optional<ExportPlan> other =
            settled(nullptr, ask, findClash({{}, {}, plan}, m_queue->activeJobs()), plan, answered);
        QVERIFY(other.has_value());
        QCOMPARE(other->output.filename().string(), std::string("b-2.png"));
        // Once that has been answered it is not asked again.
        QCOMPARE(m_queue->add({"c", tinyPreset(), *other}).ok(), true);
        const std::optional<ExportPlan> third =
            settled(nullptr, ask, findClash({{}, {}, plan}, m_queue->activeJobs()), plan, answered);
        QCOMPARE(third->output.filename().string(), std::string("b-3.png"));
        QCOMPARE(asked.size(), 2);
        // Nor does one that was cancelled come back over the one that took its name.
        m_queue->cancel(1);
        add("b");
        m_queue->start(1);
        QCOMPARE(stateOf(1), ExportState::Starting); // the disk is not waited for
        QTRY_COMPARE(stateOf(1), ExportState::Failed);
        QVERIFY(m_queue->at(1).told.contains(u"would write over"_q));
    }

    void ofTwoThatAreStartedForOneFileTheFirstIsDone()
    {
        for (const char* name : {"one", "two"}) { // each left by a program that is gone
            const ExportJob job = jobFor(name, at("one.png"));
            QVERIFY(writeJobsFile((queueFolder().filePath(QLatin1String(name)) + u".json"_q).toStdString(), {&job, 1})
                        .ok());
        }
        QVERIFY(m_queue->takeLeftovers().isEmpty());
        QCOMPARE(m_queue->held(), 2);
        m_queue->startHeld();
        QCOMPARE(m_queue->active(), 2);
        QTRY_COMPARE_WITH_TIMEOUT(m_queue->active(), 0, kEndMs);
        QCOMPARE(
            (QList<ExportState>{stateOf(0), stateOf(1)}), (QList<ExportState>{ExportState::Done, ExportState::Failed}));
        QVERIFY(m_queue->at(1).told.contains(u"would write over"_q));
    }

    void whatIsToBeStartedIsGivenUp()
    {
        const std::vector<ExportJob> jobs{jobFor("a", at("a.png")), jobFor("b", at("b.png")), jobFor("c", at("c.png"))};
        QVERIFY(writeJobsFile(queueFolder().filePath(u"left.json"_q).toStdString(), jobs).ok());
        QVERIFY(m_queue->takeLeftovers().isEmpty());
        m_queue->startHeld();
        choose(0);
        action("queue.stop")->trigger();
        QCOMPARE(stateOf(0), ExportState::Cancelled);
        m_queue->cancel(1);
        m_queue->remove(1);
        QTRY_COMPARE_WITH_TIMEOUT(stateOf(1), ExportState::Done, kEndMs);
        QCOMPARE(filesWritten(), QStringList{u"c.png"_q});
        // One that was cancelled may be started again before the answer has come.
        m_queue->start(0);
        m_queue->cancel(0);
        m_queue->start(0);
        QTRY_COMPARE_WITH_TIMEOUT(stateOf(0), ExportState::Done, kEndMs);
    }

    void whatIsNotDoneIsOnTheDisk()
    {
        addLong();
        add("b");
        QTRY_COMPARE(namesOnDisk(), (QStringList{u"long"_q, u"b"_q}));
        const QFileInfo file = listFiles().constFirst();
        QCOMPARE(file.permissions() & (QFileDevice::ReadGroup | QFileDevice::ReadOther), QFileDevice::Permissions());
        // Another program that is started now leaves them alone.
        ExportQueue other(queueFolder());
        QVERIFY(other.takeLeftovers().isEmpty());
        QCOMPARE(other.rowCount(), 0);
        m_queue->stopAll();
        QTRY_VERIFY(listFiles().isEmpty());
        QTRY_COMPARE_WITH_TIMEOUT(stateOf(0), ExportState::Cancelled, kEndMs);
    }

    void whatAProgramThatIsGoneHasLeftIsOfferedAndNotBegun()
    {
        const std::vector<ExportJob> jobs{jobFor("one", at("one.png")), jobFor("two", at("two.png"))};
        QVERIFY(writeJobsFile(queueFolder().filePath(u"left.json"_q).toStdString(), jobs).ok());
        QVERIFY(
            writeFileAtomically(queueFolder().filePath(u"torn.json"_q).toStdString(), std::string_view("{ half a li"))
                .ok());
        const auto* notice = m_panel->findChild<QWidget*>(u"queue.notice"_q);
        QVERIFY(!notice->isVisible());
        const QStringList unreadable = m_queue->takeLeftovers();
        QCOMPARE(unreadable, QStringList{queueFolder().filePath(u"torn.json"_q)});
        QCOMPARE(
            (QList<ExportState>{stateOf(0), stateOf(1)}), (QList<ExportState>{ExportState::Held, ExportState::Held}));
        QVERIFY(notice->isVisible());
        QVERIFY(m_panel->findChild<QLabel*>(u"queue.left"_q)->text().endsWith(u"2"_q));
        QVERIFY(!QFile::exists(queueFolder().filePath(u"left.json"_q))); // its jobs are in the list of this program
        QCOMPARE(namesOnDisk(), (QStringList{u"one"_q, u"two"_q}));
        add("three"); // goes before them, since they wait for somebody
        QTRY_COMPARE_WITH_TIMEOUT(stateOf(2), ExportState::Done, kEndMs);
        QCOMPARE(stateOf(0), ExportState::Held);
        QTest::mouseClick(m_panel->findChild<QPushButton*>(u"queue.startLeft"_q), Qt::LeftButton);
        QVERIFY(!notice->isVisible());
        QTRY_COMPARE_WITH_TIMEOUT(filesWritten(), (QStringList{u"one.png"_q, u"three.png"_q, u"two.png"_q}), kEndMs);
        QTRY_COMPARE_WITH_TIMEOUT(m_queue->active(), 0, kEndMs);
        QTRY_VERIFY(namesOnDisk().isEmpty());
    }

    void whatWasLeftAndHasNoRoomStaysOnTheDiskForTheNextProgram()
    {
        constexpr std::size_t kEach = kMaxJobs / 2 + 1; // two lists are one too many
        for (const char* name : {"one", "two"}) {
            const std::vector<ExportJob> jobs(kEach, jobFor(name, at("a.png")));
            QVERIFY(writeJobsFile((queueFolder().filePath(QLatin1String(name)) + u".json"_q).toStdString(), jobs).ok());
        }
        QVERIFY(m_queue->takeLeftovers().isEmpty());
        QCOMPARE(m_queue->held(), static_cast<int>(kEach)); // no list is torn apart
        QCOMPARE(m_queue->crowdedOut(), static_cast<int>(kEach));
        const QStringList both = namesOnDisk();
        QCOMPARE(both.count(u"one"_q), static_cast<qsizetype>(kEach));
        QCOMPARE(both.count(u"two"_q), static_cast<qsizetype>(kEach));
        const QString first = m_queue->index(0).data().toString();
        ExportQueue next(queueFolder()); // another program, with nothing to do
        QVERIFY(next.takeLeftovers().isEmpty());
        QCOMPARE(next.held(), static_cast<int>(kEach));
        QCOMPARE(next.crowdedOut(), 0);
        QVERIFY(next.index(0).data().toString() != first);
        QCOMPARE(namesOnDisk().size(), static_cast<qsizetype>(2 * kEach));
    }

    void whatWasLeftStaysWhereItIsUntilTheDiskTakesIt()
    {
        const ExportJob job = jobFor("one", at("one.png"));
        const QString left = queueFolder().filePath(u"left.json"_q);
        QVERIFY(writeJobsFile(left.toStdString(), {&job, 1}).ok());
        {
            const FileLimit limit(1000); // the disk is full
            QVERIFY(m_queue->takeLeftovers().isEmpty());
        }
        QCOMPARE(m_queue->held(), 1);
        QVERIFY(QFile::exists(left));
        ExportQueue other(queueFolder()); // another program that is started now
        QVERIFY(other.takeLeftovers().isEmpty());
        QCOMPARE(other.rowCount(), 0);
        QVERIFY(m_queue->setData(m_queue->index(0), u"One"_q, Qt::EditRole)); // there is room again
        QTRY_VERIFY(!QFile::exists(left));
        QCOMPARE(namesOnDisk(), QStringList{u"One"_q});
    }

    void aQueueThatEndsWithItsProgramLeavesItsList()
    {
        addLong();
        add("b");
        m_panel.reset();
        m_queue.reset(); // as where the session is ended by the system
        QCOMPARE(namesOnDisk(), (QStringList{u"long"_q, u"b"_q}));
        m_queue = std::make_unique<ExportQueue>(queueFolder());
        QVERIFY(m_queue->takeLeftovers().isEmpty());
        QCOMPARE(m_queue->held(), 2);
    }

    void theListIsSavedForTheCommandLine()
    {
        addLong();
        add("b");
        m_chosenFile = m_folder->filePath(u"tonight.json"_q);
        action("queue.save")->trigger();
        const Result<JobsReading> reading = readJobsFile(m_chosenFile.toStdString());
        QVERIFY(reading.ok());
        QCOMPARE(reading.value().jobs.size(), std::size_t{2});
        QCOMPARE(reading.value().jobs[1].name, std::string("b"));
    }

    void theListSaysWhatIsWrittenAndWhere()
    {
        ExportJob job = jobFor("a", "/proc/nowhere/fire_##.png");
        job.plan.kind = ExportKind::Sequence;
        static_cast<void>(m_queue->add(job));
        job.plan.output = (QDir::homePath() + u"/fire/b.png"_q).toStdString();
        job.plan.kind = ExportKind::Flipbook;
        static_cast<void>(m_queue->add(job));
        QCOMPARE(m_queue->index(0).data(ExportQueue::PlaceRole).toString(),
            u"Image sequence · fire_##.png · /proc/nowhere"_q);
        QCOMPARE(m_queue->index(1).data(ExportQueue::PlaceRole).toString(), u"Flipbook · b.png · ~/fire"_q);
        QTRY_COMPARE_WITH_TIMEOUT(m_queue->active(), 0, kEndMs);
    }

    void anExportWithAManifestIsVerified()
    {
        addRecorded("a", 6);
        QStringList heard;
        connect(m_queue.get(), &QAbstractItemModel::dataChanged, this,
            [&](const QModelIndex& index) { heard += index.data(ExportQueue::ToldRole).toString(); });
        verify(0);
        QCOMPARE(checkOf(0), CheckState::Running); // nothing is waited for
        QVERIFY(!action("queue.verify")->isEnabled());
        QTRY_COMPARE_WITH_TIMEOUT(checkOf(0), CheckState::Same, kEndMs);
        QVERIFY2(heard.contains(u"Verifying: 1 of 6"_q), qPrintable(heard.join(u' ')));
        QCOMPARE(saidOf(0), u"Verified: 6 files are as they were written"_q);
        QVERIFY(m_queue->index(0).data(Qt::AccessibleTextRole).toString().contains(u"Verified: 6"_q));
        QVERIFY(m_queue->index(0).data(Qt::ToolTipRole).toString().contains(u"Verified: 6"_q));
        QVERIFY(greenIn(0)); // the mark
        QVERIFY(action("queue.verify")->isEnabled());
    }

    void whatIsNotAsItWasWrittenIsNamed()
    {
        addRecorded("a", 8);
        QVERIFY(QFile::remove(m_folder->filePath(u"out/a_02.png"_q)));
        QVERIFY(QFile::remove(m_folder->filePath(u"out/a_05.png"_q)));
        QVERIFY(QFile::copy(m_folder->filePath(u"out/a_07.png"_q), m_folder->filePath(u"out/a_05.png"_q)));
        verify(0);
        QTRY_COMPARE_WITH_TIMEOUT(checkOf(0), CheckState::Failed, kEndMs);
        QCOMPARE(saidOf(0), u"2 of 8 files are not as they were written: a_02.png is missing, a_05.png is different"_q);
        QVERIFY(!greenIn(0));
        // The names have room of their own.
        addRecorded("b", 1);
        QTRY_VERIFY(list()->visualRect(m_queue->index(0)).height() > list()->visualRect(m_queue->index(1)).height());
        for (const char16_t* frame : {u"0", u"1", u"3"}) {
            QVERIFY(QFile::remove(m_folder->filePath(u"out/a_0%1.png"_q.arg(QString::fromUtf16(frame)))));
        }
        verify(0);
        QTRY_VERIFY_WITH_TIMEOUT(saidOf(0).startsWith(u"5 of 8"_q), kEndMs);
        QVERIFY2(saidOf(0).endsWith(u"a_00.png is missing, a_01.png is missing, a_02.png is missing, 2 more"_q),
            qPrintable(saidOf(0)));
    }

    void oneFileThatIsNotAsItWasWrittenIsNamed()
    {
        addRecorded("100%1 %2", 2);
        QVERIFY(QFile::remove(m_folder->filePath(u"out/100%1 %2_01.png"_q)));
        verify(0);
        QTRY_COMPARE_WITH_TIMEOUT(
            saidOf(0), u"1 of 2 files is not as it was written: 100%1 %2_01.png is missing"_q, kEndMs);
    }

    void verifyingIsGivenUp()
    {
        addRecorded("a", 4);
        addRecorded("b", 3);
        verify(0);
        verify(1);
        QCOMPARE(checkOf(1), CheckState::Running);
        choose(0);
        QCOMPARE(action("queue.stop")->text(), u"Cancel"_q);
        action("queue.stop")->trigger();
        QCOMPARE(checkOf(0), CheckState::None);
        QCOMPARE(m_queue->rowCount(), 2);
        QCOMPARE(action("queue.stop")->text(), u"Remove"_q);
        QTRY_COMPARE_WITH_TIMEOUT(checkOf(1), CheckState::Same, kEndMs);
        QCOMPARE(checkOf(0), CheckState::None); // nothing more has come of it
        QCOMPARE(saidOf(0), u"Done"_q);
        QVERIFY(action("queue.verify")->isEnabled());
        // Those that are not looked at yet are given up, too, and those that leave the list.
        verify(0);
        verify(1);
        m_queue->cancel(1);
        m_queue->remove(0);
        QCOMPARE(checkOf(0), CheckState::None);
        verify(0);
        QTRY_COMPARE_WITH_TIMEOUT(saidOf(0), u"Verified: 3 files are as they were written"_q, kEndMs);
    }

    void aManifestThatCannotBeReadIsTold()
    {
        addRecorded("a", 2);
        QVERIFY(QFile::remove(m_folder->filePath(u"out/a.0-1.manifest.json"_q)));
        verify(0);
        QTRY_COMPARE_WITH_TIMEOUT(checkOf(0), CheckState::Failed, kEndMs);
        QVERIFY2(saidOf(0).contains(u"a.0-1.manifest.json"_q), qPrintable(saidOf(0)));
        QVERIFY(writeFileAtomically(at("a.0-1.manifest.json"), std::string_view("{ half a mani")).ok());
        verify(0);
        QTRY_VERIFY_WITH_TIMEOUT(saidOf(0).contains(u"line 1"_q), kEndMs);
    }

    void aMarkGoesWhereTheExportIsDoneAgain()
    {
        addRecorded("a", 3);
        addRecorded("other", 3);
        for (int row = 0; row < 2; ++row) {
            verify(row);
            QTRY_COMPARE_WITH_TIMEOUT(checkOf(row), CheckState::Same, kEndMs);
        }
        addRecorded("a", 2);
        QCOMPARE(checkOf(0), CheckState::None);
        QCOMPARE(saidOf(0), u"Done"_q);
        QCOMPARE(checkOf(1), CheckState::Same);
        QCOMPARE(checkOf(2), CheckState::None);
    }

    void onlyWhatIsDoneAndHasAManifestIsVerified()
    {
        addLong();
        add("b");
        QVERIFY(!action("queue.verify")->isEnabled()); // none is chosen
        choose(0);
        QVERIFY(!action("queue.verify")->isEnabled());
        m_queue->cancel(0);
        QTRY_COMPARE_WITH_TIMEOUT(stateOf(1), ExportState::Done, kEndMs);
        choose(1);
        QVERIFY(!action("queue.verify")->isEnabled()); // it has no manifest
        m_queue->verify(1);
        QCOMPARE(checkOf(1), CheckState::None);
        addRecorded("c", 1);
        choose(2);
        QVERIFY(action("queue.verify")->isEnabled());
    }

    void aManifestIsAskedForAgainAfterACrash()
    {
        addLong();
        ExportJob job = jobFor("a", at("a_##.png"));
        job.plan.recording.manifest = at("a.manifest.json");
        QVERIFY(m_queue->add(std::move(job)).ok());
        m_panel.reset();
        m_queue.reset();
        m_queue = std::make_unique<ExportQueue>(queueFolder());
        QVERIFY(m_queue->takeLeftovers().isEmpty());
        QCOMPARE(m_queue->at(1).job->plan.recording.manifest.string(), at("a.manifest.json"));
    }

    void aQueueThatIsFullSaysSo()
    {
        addLong();
        for (std::size_t i = 1; i < kMaxJobs; ++i) {
            add(("job" + std::to_string(i)).c_str());
        }
        const Result<quint64> more = m_queue->add(jobFor("more", at("more.png")));
        QVERIFY(!more.ok());
        QVERIFY(toQString(more.error().text()).contains(u"256"_q));
        m_queue->stopAll();
    }

private:
    [[nodiscard]] QDir queueFolder() const { return QDir(m_folder->filePath(u"queue"_q)); }
    [[nodiscard]] std::string at(const std::string& name) const
    {
        return (m_folder->path() + u"/out/"_q).toStdString() + name;
    }
    [[nodiscard]] QStringList filesWritten() const
    {
        return QDir(m_folder->filePath(u"out"_q)).entryList({u"*.png"_q}, QDir::Files, QDir::Name);
    }
    [[nodiscard]] QFileInfoList listFiles() const { return queueFolder().entryInfoList({u"*.json"_q}, QDir::Files); }
    [[nodiscard]] ExportState stateOf(int row) const { return m_queue->at(row).state; }
    [[nodiscard]] QListView* list() const { return m_panel->findChild<QListView*>(u"queue.list"_q); }
    [[nodiscard]] QAction* action(const char* name) const { return m_panel->findChild<QAction*>(QLatin1String(name)); }
    void choose(int row) { list()->setCurrentIndex(m_queue->index(row)); }

    [[nodiscard]] QStringList names() const
    {
        QStringList names;
        for (int row = 0; row < m_queue->rowCount(); ++row) {
            names += m_queue->index(row).data().toString();
        }
        return names;
    }

    [[nodiscard]] QStringList namesOnDisk() const
    {
        QStringList names;
        for (const QFileInfo& file : listFiles()) {
            const Result<JobsReading> reading = readJobsFile(file.filePath().toStdString());
            for (const ExportJob& job : reading ? reading.value().jobs : std::vector<ExportJob>()) {
                names += toQString(job.name);
            }
        }
        return names;
    }

    [[nodiscard]] static ExportJob jobFor(const std::string& name, const std::string& output)
    {
        ExportJob job{name, tinyPreset(), {}};
        job.plan.kind = ExportKind::Picture;
        job.plan.output = output;
        return job;
    }

    quint64 add(const char* name) { return m_queue->add(jobFor(name, at(std::string(name) + ".png"))).value(); }

    /// Frames with a manifest, when they are done.
    void addRecorded(const std::string& name, int frames)
    {
        ExportJob job = jobFor(name, at(name + "_##.png"));
        job.plan.kind = ExportKind::Sequence;
        job.plan.frames = {0, frames - 1, 1};
        job.plan.recording.manifest = at(name + ".manifest.json");
        QVERIFY(m_queue->add(std::move(job)).ok());
        QTRY_COMPARE_WITH_TIMEOUT(stateOf(m_queue->rowCount() - 1), ExportState::Done, kEndMs);
    }

    void verify(int row)
    {
        choose(row);
        QVERIFY(action("queue.verify")->isEnabled());
        action("queue.verify")->trigger();
    }
    [[nodiscard]] CheckState checkOf(int row) const { return m_queue->at(row).check.state; }
    [[nodiscard]] QString saidOf(int row) const { return m_queue->index(row).data(ExportQueue::ToldRole).toString(); }

    /// Whether a row that is not selected shows the colour of what is right.
    [[nodiscard]] bool greenIn(int row) const
    {
        list()->clearSelection();
        const QImage seen = list()->grab(list()->visualRect(m_queue->index(row))).toImage();
        const QRgb good = themeColours(isDark(list()->palette())).good;
        for (int y = 0; y < seen.height(); ++y) {
            for (int x = 0; x < seen.width(); ++x) {
                if (seen.pixel(x, y) == good) {
                    return true;
                }
            }
        }
        return false;
    }

    /// One that does not end by itself.
    void addLong()
    {
        ExportJob job = jobFor("long", at("long_######.png"));
        job.plan.kind = ExportKind::Sequence;
        job.plan.frames = {0, 20'000, 1};
        QVERIFY(m_queue->add(std::move(job)).ok());
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_chosenFile;
    std::unique_ptr<ExportQueue> m_queue;
    std::unique_ptr<QueuePanel> m_panel;
};

FUMAGE_TEST_MAIN(QueueTest)
#include "queue_test.moc"
