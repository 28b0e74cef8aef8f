// Saves or keeps safe the work of a document, or does exports of a queue, until it is killed; see kill_loop.py. Ends
// with 3 where it finds a broken file.

#include "ui/document/document.h"
#include "ui/document/recovery.h"
#include "ui/document/text.h"
#include "ui/export/export_queue.h"

#include "core/effect/known_parameter.h"
#include "core/preset/preset_file.h"

#include <cstdio>
#include <filesystem>

#include <QCoreApplication>
#include <QEventLoop>

namespace {

using namespace fumage;
using namespace fumage::ui;

constexpr int kBroken = 3;

void change(Document& document, int turn)
{
    document.edit(knownParameter("motion.gravity"), static_cast<float>(turn % 100) * 0.1F);
}

int save(const std::string& path)
{
    Document document;
    if (std::filesystem::exists(path)) {
        const Result<PresetReading> reading = readPresetFile(path);
        if (!reading) {
            std::fprintf(stderr, "%s\n", reading.error().text().c_str());
            return kBroken;
        }
        document.load(reading.value().preset, toQString(path));
    }
    for (int turn = 1;; ++turn) {
        change(document, turn);
        if (const Status status = document.save(toQString(path)); !status) {
            std::fprintf(stderr, "%s\n", status.error().text().c_str());
            return 1;
        }
    }
}

int recover(const std::string& path)
{
    const QDir folder(toQString(path));
    const bool leftWork = !folder.entryList({QStringLiteral("*.json")}).isEmpty();
    Document document;
    Recovery recovery(document, folder);
    Recovery::Leftovers left = Recovery::find(folder);
    if (!left.unreadable.isEmpty() || !left.dangerous.isEmpty() || left.works.empty() == leftWork) {
        return kBroken;
    }
    if (leftWork) {
        recovery.adopt(std::move(left.works.front()));
        recovery.markRecovered();
    }
    QEventLoop writing;
    QObject::connect(&recovery, &Recovery::written, &writing, &QEventLoop::quit);
    for (int turn = 1;; ++turn) {
        change(document, turn);
        recovery.save();
        writing.exec();
    }
}

/// A picture that is done in some milliseconds.
ExportJob smallJob(const std::string& folder, int number)
{
    ExportJob job;
    job.name = std::to_string(QCoreApplication::applicationPid()) + "-" + std::to_string(number);
    job.preset.scene.air.enabled = false;
    job.preset.scene.layers[0].emitter.count = 200;
    job.preset.scene.layers[0].noise.slices = 2;
    job.preset.scene.layers[0].noise.resolution = 16;
    job.preset.scene.output.width = job.preset.scene.output.height = 16;
    job.plan.kind = ExportKind::Picture;
    job.plan.output = std::filesystem::path(folder) / (job.name + ".png");
    return job;
}

/// Does what others have left first, and always has some more to do.
int doQueue(const std::string& path)
{
    constexpr int kWaiting = 5;
    ExportQueue queue(QDir(toQString(path + "/lists")));
    if (!queue.takeLeftovers().isEmpty()) {
        return kBroken;
    }
    queue.startHeld();
    int added = 0;
    const auto fill = [&] {
        while (queue.active() < kWaiting && queue.add(smallJob(path, added))) {
            ++added;
        }
    };
    QObject::connect(&queue, &ExportQueue::ended, &queue, fill);
    QObject::connect(&queue, &ExportQueue::notKept, &queue, [](const QString& message) {
        std::fprintf(stderr, "%s\n", qPrintable(message));
        QCoreApplication::exit(1);
    });
    fill();
    return QCoreApplication::exec();
}

} // namespace

int main(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    const std::string what = argc == 3 ? argv[1] : "";
    return what == "save"   ? save(argv[2])
        : what == "recover" ? recover(argv[2])
        : what == "queue"   ? doQueue(argv[2])
                            : 2;
}
