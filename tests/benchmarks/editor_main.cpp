// How the editor answers: on the offscreen platform, where the compositor paints as it does on a machine without a
// graphics card.
#include "tests/benchmarks/measure.h"

#include "ui/document/document.h"
#include "ui/export/export_worker.h"
#include "ui/shell/main_window.h"
#include "ui/shell/session.h"
#include "ui/viewport/viewport.h"

#include "core/effect/parameter_table.h"
#include "core/preset/library.h"

#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <memory>

#include <QApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTimer>

using namespace fumage;
using namespace fumage::ui;

namespace {

constexpr double kNanosecondsAMillisecond = 1e6;

Preset smokeOf(int particles)
{
    Preset preset;
    preset.scene.layers[0].emitter.count = particles;
    return preset;
}

/// A window on some smoke, at rest at frame 60.
struct Editor {
    Session session;
    MainWindow* window = nullptr;

    explicit Editor(int particles)
        : Editor(smokeOf(particles))
    {
    }

    explicit Editor(const Preset& preset)
    {
        window = session.openWindow();
        window->document().load(preset, {});
        window->player().pause();
        window->player().setFrame(60);
        settle();
        constexpr int kThumbnailsMs = 2500;
        waitFor(kThumbnailsMs);
    }

    static void waitFor(int milliseconds)
    {
        QEventLoop loop;
        QTimer::singleShot(milliseconds, &loop, &QEventLoop::quit);
        loop.exec();
    }

    void settle() const
    {
        while (!window->viewport().isSettled()) {
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        }
    }
};

double cpuSeconds()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double residentMebibytes()
{
    std::ifstream file("/proc/self/statm");
    double total = 0.0;
    double resident = 0.0;
    file >> total >> resident;
    constexpr double kPagesAMebibyte = 256.0;
    return resident / kPagesAMebibyte;
}

/// The longest time in which the GUI thread did not come round.
class Heartbeat : public QObject {
public:
    Heartbeat()
    {
        m_since.start();
        m_timer.setTimerType(Qt::PreciseTimer);
        connect(&m_timer, &QTimer::timeout, this, [this] {
            m_gaps.push_back(static_cast<double>(m_since.nsecsElapsed()) / kNanosecondsAMillisecond - kIntervalMs);
            m_since.start();
        });
        m_timer.start(kIntervalMs);
    }

    [[nodiscard]] double longestMs() const { return *std::max_element(m_gaps.begin(), m_gaps.end()); }
    [[nodiscard]] double percentileMs(double share)
    {
        std::sort(m_gaps.begin(), m_gaps.end());
        return m_gaps[static_cast<std::size_t>(share * static_cast<double>(m_gaps.size() - 1))];
    }

private:
    static constexpr int kIntervalMs = 2;
    QTimer m_timer;
    QElapsedTimer m_since;
    std::vector<double> m_gaps;
};

/// A drag of the buoyancy of the default look in air: the time to the first changed picture, whose air is coarse while
/// the hand moves, and from the end of the drag to the picture of the whole air. Each drag begins with a bake that is
/// whole.
void dragOfAir(benchmark::State& state)
{
    Editor editor(loadPreset("default").value().preset);
    Document& document = editor.window->document();
    const Parameter& parameter = *findParameter("motion.buoyancy");
    double value = 3.0;
    double changedMs = 0.0;
    double drags = 0.0;
    Heartbeat heartbeat;
    for (auto _ : state) {
        constexpr double kStep = 0.25;
        value += kStep;
        const PicturePtr before = editor.window->viewport().picture();
        QElapsedTimer since;
        since.start();
        {
            const Gesture gesture = document.beginGesture();
            document.edit(parameter, static_cast<float>(value), gesture);
            while (editor.window->viewport().picture() == before) {
                QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
            }
            changedMs += static_cast<double>(since.nsecsElapsed()) / kNanosecondsAMillisecond;
        }
        since.start();
        editor.settle();
        state.SetIterationTime(static_cast<double>(since.nsecsElapsed()) / kNanosecondsAMillisecond / 1e3);
        drags += 1.0;
    }
    state.counters["changed ms"] = changedMs / drags;
    state.counters["longest ms"] = heartbeat.longestMs();
}

/// From a slider's move to the changed picture.
void slider(benchmark::State& state, const char* key)
{
    Editor editor(static_cast<int>(state.range(0)));
    Document& document = editor.window->document();
    const Parameter& parameter = *findParameter(key);
    const double low = parameter.soft.low;
    const double high = parameter.soft.high;
    double place = 0.3;
    const Gesture gesture = document.beginGesture();
    for (auto _ : state) {
        place = place > 0.6 ? 0.3 : place + 0.01;
        const PicturePtr before = editor.window->viewport().picture();
        document.edit(parameter, static_cast<float>(low + (high - low) * place), gesture);
        while (editor.window->viewport().picture() == before) {
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        }
    }
    editor.settle();
}

void blockedWhilePlaying(benchmark::State& state)
{
    Editor editor(static_cast<int>(state.range(0)));
    for (auto _ : state) {
        editor.window->player().play();
        Heartbeat heartbeat;
        Editor::waitFor(5000);
        editor.window->player().pause();
        state.counters["longest ms"] = heartbeat.longestMs();
        state.counters["p99 ms"] = heartbeat.percentileMs(0.99);
    }
}

void blockedWhileExporting(benchmark::State& state)
{
    Editor editor(100000);
    QTemporaryDir folder;
    ExportWorker worker;
    for (auto _ : state) {
        ExportPlan plan;
        plan.output = folder.filePath(QStringLiteral("smoke_####.png")).toStdString();
        plan.frames = {0, 10000, 1};
        worker.start(std::make_shared<ExportJob>(ExportJob{"long", {.scene = editor.window->document().scene()}, plan}),
            editor.window->viewport().shelf());
        editor.window->player().play();
        Heartbeat heartbeat;
        Editor::waitFor(5000);
        worker.cancel();
        while (worker.isRunning()) {
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        }
        state.counters["longest ms"] = heartbeat.longestMs();
        state.counters["p99 ms"] = heartbeat.percentileMs(0.99);
    }
}

void idle(benchmark::State& state)
{
    const Editor editor(100000);
    for (auto _ : state) {
        const double before = cpuSeconds();
        Editor::waitFor(4000);
        state.counters["% of a core"] = (cpuSeconds() - before) / 4.0 * 100.0;
    }
}

void memory(benchmark::State& state)
{
    const Editor editor(20000);
    // A document that changes all the time: nothing comes out of the cache.
    editor.window->player().play();
    Editor::waitFor(8000);
    const double before = residentMebibytes();
    for (auto _ : state) {
        Editor::waitFor(45000);
    }
    state.counters["MiB grown"] = residentMebibytes() - before;
}

void start(benchmark::State& state)
{
    for (auto _ : state) {
        Session session;
        MainWindow window(session);
        window.setAttribute(Qt::WA_DeleteOnClose, false);
        window.show();
        while (!window.viewport().picture()) {
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        }
    }
}

} // namespace

int main(int argc, char** argv)
{
    const QTemporaryDir home;
    for (const char* variable : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_RUNTIME_DIR"}) {
        qputenv(variable, home.path().toLocal8Bit());
    }
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QApplication application(argc, argv);
    std::vector<fumage::benchmarks::Claim> claims;
    const auto add = [&](const char* name, auto* function) {
        return benchmark::RegisterBenchmark(name, function)->Unit(benchmark::kMillisecond)->UseRealTime();
    };
    add(
        "slider/gravity", +[](benchmark::State& state) { slider(state, "motion.gravity"); })
        ->Arg(5000)
        ->Arg(100000)
        ->Arg(1000000);
    add(
        "slider/opacity", +[](benchmark::State& state) { slider(state, "look.opacity"); })
        ->Arg(5000)
        ->Arg(100000)
        ->Arg(1000000);
    benchmark::RegisterBenchmark("drag/air", dragOfAir)->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(8);
    add("blocked/playing", blockedWhilePlaying)->Arg(100000)->Arg(1000000)->Iterations(1);
    add("blocked/exporting", blockedWhileExporting)->Iterations(1);
    add("idle", idle)->Iterations(1);
    add("memory", memory)->Iterations(1);
    add("start", start);
    for (const char* key : {"gravity", "opacity"}) {
        const std::string name = std::string("slider/") + key;
        claims.push_back({name + ", 5000 particles, to the changed picture", name + "/5000", "", "", 33.0, true});
        const double most = std::string_view(key) == "opacity" ? 16.0 : 100.0;
        claims.push_back({name + ", 100 000 particles", name + "/100000", "", "", most, true});
        claims.push_back({name + ", 1 000 000 particles", name + "/1000000", "", "", 0.0, true});
    }
    claims.push_back({"drag of the buoyancy in air, default look, to the changed picture", "drag/air", "", "changed ms",
        100.0, true});
    claims.push_back({"  from its end to the whole air", "drag/air", "", "", 1500.0, true});
    claims.push_back({"  GUI thread blocked, longest", "drag/air", "", "longest ms", 16.0, true});
    claims.push_back({"GUI thread blocked, playing 100 000 particles, longest", "blocked/playing/100000", "",
        "longest ms", 16.0, true});
    claims.push_back({"GUI thread blocked, playing 1 000 000 particles, longest", "blocked/playing/1000000", "",
        "longest ms", 16.0, true});
    claims.push_back(
        {"GUI thread blocked, playing during an export, longest", "blocked/exporting", "", "longest ms", 16.0, true});
    claims.push_back({"processor while paused", "idle", "", "% of a core", 0.5, true});
    claims.push_back({"memory grown in 45 s of play", "memory", "", "MiB grown", 8.0, true});
    claims.push_back({"a new window to its first picture", "start", "", "", 500.0, true});
    return fumage::benchmarks::runAndReport(argc, argv, claims);
}
