// The queue verifies what it has written with a manifest.
#include "queue_fixture.h"

#include "ui/theme/theme.h"

#include "core/system/file.h"

using namespace fumage;
using namespace fumage::tests;

class QueueVerifyTest : public QueueFixture {
    Q_OBJECT

private slots:
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

private:
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
};

FUMAGE_TEST_MAIN(QueueVerifyTest)
#include "queue_verify_test.moc"
