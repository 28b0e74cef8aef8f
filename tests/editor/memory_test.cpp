// Memory that runs out costs what was being made, not the program.
#include "editor_helpers.h"
#include "picture_helpers.h"

#include "ui/export/export_worker.h"
#include "ui/noise_preview/noise_picture.h"
#include "ui/preview/preview_scheduler.h"
#include "ui/shell/guarded_application.h"

#include "core/flow/grid.h"
#include "core/noise/texture.h"

#include <QMessageBox>
#include <QPushButton>
#include <QTimer>

#include <sys/resource.h>
#include <unistd.h>

using namespace fumage;
using namespace fumage::tests;

namespace {

/// While it lives, the program gets little memory beyond what it has.
class MemoryLimit {
public:
    explicit MemoryLimit(rlim_t more)
    {
        getrlimit(RLIMIT_AS, &m_before);
        QFile statm(u"/proc/self/statm"_q);
        const rlim_t pages = statm.open(QIODevice::ReadOnly) ? statm.readAll().split(' ').first().toULongLong() : 0;
        const rlimit tight{pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + more, m_before.rlim_max};
        setrlimit(RLIMIT_AS, &tight);
    }
    ~MemoryLimit() { setrlimit(RLIMIT_AS, &m_before); }
    MemoryLimit(const MemoryLimit&) = delete;
    MemoryLimit& operator=(const MemoryLimit&) = delete;

private:
    rlimit m_before{};
};

constexpr rlim_t kLittle = rlim_t{400} << 20U;

class Explosive : public QObject {
public:
    bool event(QEvent* event) override
    {
        if (event->type() == QEvent::User) {
            throw std::bad_alloc();
        }
        return QObject::event(event);
    }
};

} // namespace

class MemoryTest : public QObject {
    Q_OBJECT

private slots:
    void anExportThatIsTooLargeFailsWithAMessage()
    {
        const QTemporaryDir folder;
        Effect effect = tinyEffect();
        effect.output.width = 8192;
        effect.output.height = 8192;
        ExportPlan plan;
        plan.kind = ExportKind::Picture;
        plan.output = folder.filePath(u"large.png"_q).toStdString();
        ExportWorker worker;
        QSignalSpy failed(&worker, &ExportWorker::failed);
        {
            const MemoryLimit limit(kLittle);
            worker.start(std::make_shared<ExportJob>(ExportJob{"large", {.scene = effect}, plan}), nullptr);
            QTRY_COMPARE_WITH_TIMEOUT(failed.size(), 1, 60000);
        }
        QVERIFY2(failed[0][0].toString().contains(u"memory"_q), qPrintable(failed[0][0].toString()));
        QVERIFY(QDir(folder.path()).isEmpty());
        effect.output.width = 16;
        effect.output.height = 16;
        QSignalSpy finished(&worker, &ExportWorker::finished);
        worker.start(std::make_shared<ExportJob>(ExportJob{"large", {.scene = effect}, plan}), nullptr);
        QTRY_COMPARE_WITH_TIMEOUT(finished.size(), 1, 60000);
    }

    void aPictureThatIsTooLargeIsGivenUpAndTheNextOneComes()
    {
        PreviewScheduler feed;
        feed.setScene(tinyEffect(), 0, DirtyStage::Simulate);
        QSignalSpy exhausted(&feed, &PreviewScheduler::exhausted);
        QSignalSpy ready(&feed, &PreviewScheduler::ready);
        {
            const MemoryLimit limit(kLittle);
            feed.setSize({8000, 8000});
            feed.setSeen(true);
            QTRY_VERIFY_WITH_TIMEOUT(!exhausted.isEmpty(), 60000);
        }
        feed.setSize({64, 48});
        QTRY_VERIFY_WITH_TIMEOUT(feed.isSettled(), 60000);
        QCOMPARE(feed.picture()->image.size(), QSize(64, 48));
    }

    void airThatIsTooFineIsGivenUpAndTheNextOneComes()
    {
        PreviewScheduler feed;
        QSignalSpy exhausted(&feed, &PreviewScheduler::exhausted);
        feed.setSize({64, 48});
        Effect effect = tinyEffect();
        effect.air.enabled = true;
        effect.air.resolution = kMaxAirCells;
        {
            const MemoryLimit limit(rlim_t{64} << 20U);
            feed.setScene(effect, 0, DirtyStage::Simulate);
            feed.setSeen(true);
            QTRY_VERIFY_WITH_TIMEOUT(!exhausted.isEmpty(), 60000);
        }
        effect.air.resolution = kMinAirCells;
        feed.setScene(effect, 0, DirtyStage::Simulate);
        QTRY_VERIFY_WITH_TIMEOUT(feed.isSettled(), 60000);
        QCOMPARE(feed.picture()->image.size(), QSize(64, 48));
    }

    void aTextureThatIsTooLargeIsGivenUpAndTheNextOneComes()
    {
        NoiseWorker worker;
        QSignalSpy exhausted(&worker, &NoiseWorker::exhausted);
        QSignalSpy ready(&worker, &NoiseWorker::ready);
        NoiseRequest request;
        {
            const MemoryLimit limit(rlim_t{48} << 20U);
            request.size = kMaxTextureSize;
            worker.request(request);
            QTRY_COMPARE_WITH_TIMEOUT(exhausted.size(), 1, 60000);
        }
        request.size = 16;
        worker.request(request);
        QTRY_COMPARE_WITH_TIMEOUT(ready.size(), 1, 60000);
    }

    void aJobGoesOnAfterItsMemoryRanOut()
    {
        std::atomic<int> exhausted = 0;
        std::atomic<int> done = 0;
        LatestOnlyWorker<int> job(
            [&](int request, const std::stop_token&) {
                if (request == 1) {
                    throw std::bad_alloc();
                }
                ++done;
            },
            [&](int, const Error& why) { exhausted += why.code == ErrorCode::OutOfMemory ? 1 : 0; },
            [](int) { return false; });
        job.post(1);
        QTRY_COMPARE(exhausted.load(), 1);
        job.post(2);
        QTRY_COMPARE(done.load(), 1);
    }

    void anEventThatExhaustsMemoryIsSaidAndNotTheEnd()
    {
        QString said;
        QTimer answer;
        connect(&answer, &QTimer::timeout, &answer, [&said] {
            if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
                said = box->text();
                box->button(QMessageBox::Ok)->click();
            }
        });
        answer.start(10);
        Explosive explosive;
        QCoreApplication::postEvent(&explosive, new QEvent(QEvent::User));
        QTRY_VERIFY(said.contains(u"memory"_q));
    }
};

int main(int argc, char** argv)
{
    return runTest<MemoryTest, GuardedApplication>(argc, argv);
}
#include "memory_test.moc"
