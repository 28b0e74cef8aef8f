// The queue of exports and its panel: order, names, what ends in the middle, and what is on the disk meanwhile.
#include "queue_fixture.h"

#include "core/system/file.h"
#include "core/export/jobs/job_file.h"

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include <csignal>

#include <sys/resource.h>

using namespace fumage;
using namespace fumage::tests;

namespace {

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

class QueueTest : public QueueFixture {
    Q_OBJECT

private slots:
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
};

FUMAGE_TEST_MAIN(QueueTest)
#include "queue_test.moc"
