// Whatever is thrown, on any thread of the editor or in an event: it is told, and the next work is done.
#include "editor_helpers.h"

#include "ui/shell/guarded_application.h"
#include "ui/concurrency/async_request.h"

#include "core/base/parallel.h"

#include <QMessageBox>
#include <QTimer>

#include <stdexcept>

using namespace fumage;
using namespace fumage::tests;

namespace {

/// What can be thrown, by name.
const QMap<QString, std::function<void()>>& throwers()
{
    static const QMap<QString, std::function<void()>> all{
        {u"length_error"_q, [] { throw std::length_error("cannot create std::vector larger than max_size()"); }},
        {u"runtime_error"_q, [] { throw std::runtime_error("a library says so"); }},
        {u"int"_q, [] { throw 42; }}, // NOLINT(hicpp-exception-baseclass): that is the point
        {u"bad_alloc"_q, [] { throw std::bad_alloc(); }},
        {u"system_error"_q,
            [] { throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again)); }},
        {u"from a parallel loop"_q,
            [] { parallelFor(64, [](std::size_t) { throw std::runtime_error("in a loop"); }); }},
    };
    return all;
}

void addThrowers()
{
    QTest::addColumn<int>("none");
    for (const QString& name : throwers().keys()) {
        QTest::newRow(qPrintable(name)) << 0;
    }
}

void throwWhatTheRowSays()
{
    throwers().value(QString::fromLatin1(QTest::currentDataTag()))();
}

/// Whether an error tells a person what to do, and says more than the exception did.
bool isForPeople(const Error& why)
{
    return !why.message.empty() && !why.remedy.empty()
        && why.text() != "cannot create std::vector larger than max_size()";
}

class Thrower : public QObject {
public:
    bool event(QEvent* event) override
    {
        if (event->type() == QEvent::User) {
            throwWhatTheRowSays();
        }
        return QObject::event(event);
    }
};

} // namespace

class WorkerExceptionsTest : public QObject {
    Q_OBJECT

private slots:
    void aThreadEndsAndSaysWhy_data() { addThrowers(); }
    void aThreadEndsAndSaysWhy()
    {
        std::atomic<int> told = 0;
        {
            const auto work = throwers().value(QString::fromLatin1(QTest::currentDataTag()));
            const GuardedThread thread(
                [&](const std::stop_token&) { work(); }, [&](const Error& why) { told += isForPeople(why) ? 1 : 100; });
        }
        QCOMPARE(told.load(), 1);
    }

    void aJobSaysWhyAndDoesTheNextThing_data() { addThrowers(); }
    void aJobSaysWhyAndDoesTheNextThing()
    {
        std::atomic<int> told = 0;
        std::atomic<int> done = 0;
        const auto work = throwers().value(QString::fromLatin1(QTest::currentDataTag()));
        LatestOnlyWorker<int> job(
            [&](int request, const std::stop_token&) { request == 1 ? work() : static_cast<void>(++done); },
            [&](int request, const Error& why) { told += request == 1 && isForPeople(why) ? 1 : 100; });
        job.post(1);
        QTRY_COMPARE(told.load(), 1);
        job.post(2);
        QTRY_COMPARE(done.load(), 1);
        QCOMPARE(told.load(), 1);
    }

    void aJobWhoseComplaintThrowsTooDoesTheNextThing()
    {
        std::atomic<int> told = 0;
        std::atomic<int> done = 0;
        LatestOnlyWorker<int> job(
            [&](int request, const std::stop_token&) {
                request == 1 ? throw std::bad_alloc() : static_cast<void>(++done);
            },
            [&](int, const Error&) {
                ++told;
                throw std::bad_alloc();
            });
        job.post(1);
        QTRY_COMPARE(told.load(), 1);
        job.post(2);
        QTRY_COMPARE(done.load(), 1);
    }

    void whoAskedHearsOfItOnItsOwnThreadAndOnce_data() { addThrowers(); }
    void whoAskedHearsOfItOnItsOwnThreadAndOnce()
    {
        AsyncRequest job;
        int told = 0;
        int done = 0;
        const auto fail = [&](const Error& why) {
            told += isForPeople(why) && QThread::currentThread() == qApp->thread() ? 1 : 100;
        };
        job.ask([work = throwers().value(QString::fromLatin1(QTest::currentDataTag()))](
                    const AsyncRequest::Report&, const std::stop_token&) { work(); },
            fail);
        QTRY_COMPARE(told, 1);
        job.ask([&](const AsyncRequest::Report& report, const std::stop_token&) { report([&] { ++done; }); }, fail);
        QTRY_COMPARE(done, 1);
        QCOMPARE(told, 1);
    }

    void anEventThatThrowsIsSaidOnceAndNotTheEnd_data() { addThrowers(); }
    void anEventThatThrowsIsSaidOnceAndNotTheEnd()
    {
        int boxes = 0;
        QString said;
        QTimer answer;
        connect(&answer, &QTimer::timeout, &answer, [&] {
            if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
                ++boxes;
                said = box->text();
                box->button(QMessageBox::Ok)->click();
            }
        });
        answer.start(10);
        Thrower thrower;
        QCoreApplication::postEvent(&thrower, new QEvent(QEvent::User));
        QTRY_COMPARE(boxes, 1);
        QVERIFY(said.contains(u"Save your work"_q));
    }
};

int main(int argc, char** argv)
{
    return runTest<WorkerExceptionsTest, GuardedApplication>(argc, argv);
}
#include "worker_exceptions_test.moc"
