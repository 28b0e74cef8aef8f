#include "ui/export/export_summary.h"

#include "core/export/sheets/flipbook_check.h"
#include "core/export/engines/engine_files.h"
#include "core/export/loop.h"
#include "core/export/remarks.h"
#include "core/export/sheets/sheet_playback.h"
#include "ui/document/text.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QStandardPaths>

#include <tuple>

namespace fumage::ui {

namespace {

/// What stands in the way of a flipbook, but for too few frames.
Status checkFlipbook(const ExportPlan& plan, const Scene& scene)
{
    if (Status status = checkEngine(plan.flipbook.engine, plan.passes, plan.format); !status) {
        return status;
    }
    if (Status status = checkLayers(flipbookOf(plan)); !status) {
        return status;
    }
    const Result<Output> cell = outputFor(scene, plan);
    return cell ? checkPacks(plan.flipbook.packs, cell.value().width, cell.value().height) : Status(cell.error());
}

QString flipbookSummary(const ExportPlan& plan, const Scene& scene, const Output& cell)
{
    const std::vector<std::filesystem::path> all = filesOf(scene, plan);
    const QString first = fromPath(all.front().filename());
    const int width = cell.width * plan.flipbook.columns;
    const int height = cell.height * plan.flipbook.rows;
    const auto more = static_cast<int>(all.size()) - 1;
    const QString files = more > 1 ? QCoreApplication::translate("Exports", "%1, %2 × %3 pixels, and %4 more files")
                                         .arg(first)
                                         .arg(width)
                                         .arg(height)
                                         .arg(more)
                                   : QCoreApplication::translate("Exports", "%1, %2 × %3 pixels, and %4")
                                         .arg(first)
                                         .arg(width)
                                         .arg(height)
                                         .arg(fromPath(all.back().filename()));
    const SheetMemory memory = memoryOf(flipbookOf(plan), cell.width, cell.height, writtenLayers(scene).size());
    const QLocale locale;
    return files + QLatin1Char('\n')
        + QCoreApplication::translate("Exports", "On the graphics card: %1 as BC7, %2 uncompressed")
              .arg(locale.formattedDataSize(memory.compressed, 1), locale.formattedDataSize(memory.plain, 1));
}

/// The files of a plan that is possible.
QString filesTold(const ExportPlan& plan, const Scene& scene)
{
    QString first = fromPath(firstFile(scene, plan).filename());
    if (isNumbered(plan.kind) && plan.frames.count() > 1) {
        return QCoreApplication::translate("Exports", "Files: %1, from %2 to %3")
            .arg(plan.frames.count())
            .arg(first, fromPath(lastFile(scene, plan).filename()));
    }
    if (plan.kind == ExportKind::Video) {
        const std::array<int, 2> size = sizeOf(scene.output, plan.video.format);
        const double rate = plan.video.rate.value_or(FrameRate{scene.timeline.frameRate, 1}).perSecond();
        const double seconds = static_cast<double>(plan.frames.count()) * plan.frames.step / rate;
        return QCoreApplication::translate("Exports", "%1, %2 × %3 pixels, %4 s")
            .arg(first)
            .arg(size[0])
            .arg(size[1])
            .arg(QLocale().toString(seconds, 'f', 1));
    }
    if (plan.kind == ExportKind::Flipbook) {
        return flipbookSummary(plan, scene, outputFor(scene, plan).value()); // it is possible
    }
    return first;
}

} // namespace

bool isPossible(const ExportPlan& plan, const Scene& scene)
{
    const bool flipbook = plan.kind != ExportKind::Flipbook
        || (plan.frames.count() >= plan.flipbook.columns * plan.flipbook.rows && checkFlipbook(plan, scene).ok());
    const bool carried = plan.kind != ExportKind::Air || scene.air.enabled;
    return !plan.output.empty() && plan.frames.first <= plan.frames.last && flipbook && carried;
}

QString summaryOf(const ExportPlan& plan, const Scene& scene)
{
    if (plan.output.empty() || plan.frames.first > plan.frames.last) {
        return QCoreApplication::translate("Exports", "Choose a file, and a first frame that comes before the last.");
    }
    if (plan.kind == ExportKind::Flipbook) {
        if (const Status status = checkFlipbook(plan, scene); !status) {
            return translated(status.error());
        }
    }
    if (plan.kind == ExportKind::Air && !scene.air.enabled) {
        return QCoreApplication::translate("Exports", "No air carries this smoke: switch it on in the group Air.");
    }
    if (!isPossible(plan, scene)) {
        return QCoreApplication::translate(
            "Exports", "%1 frames do not fill %2 cells: choose more frames or fewer columns and rows.")
            .arg(plan.frames.count())
            .arg(plan.flipbook.columns * plan.flipbook.rows);
    }
    QString summary = filesTold(plan, scene);
    for (const Message& remark : remarksOn(scene, plan)) {
        const QString text = translated(remark);
        summary += QLatin1Char('\n') + text.left(1).toUpper() + text.mid(1) + QLatin1Char('.');
    }
    return summary;
}

std::optional<ExportOffer> offerFor(const ExportPlan& plan, const Scene& scene)
{
    if (plan.frames.first > plan.frames.last) {
        return std::nullopt;
    }
    const int cells = plan.kind == ExportKind::Flipbook ? plan.flipbook.columns * plan.flipbook.rows : 1;
    if (plan.frames.count() < cells) {
        const auto [columns, rows] =
            gridWithin(plan.frames.count(), plan.flipbook.columns, plan.flipbook.rows, plan.flipbook.powerOfTwo);
        return ExportOffer{QCoreApplication::translate("Exports", "Use %1 × %2 cells").arg(columns).arg(rows),
            plan.frames, columns, rows};
    }
    const std::optional<FrameRange> whole = closedInstead(scene.timeline, plan.frames, cells);
    if (!whole || remarksOn(scene, plan).empty()) {
        return std::nullopt;
    }
    return ExportOffer{QCoreApplication::translate("Exports", "Use frames %1").arg(toQString(textOf(*whole))), *whole,
        plan.flipbook.columns, plan.flipbook.rows};
}

bool haveSameCells(const ExportPlan& a, const ExportPlan& b)
{
    const auto ofCells = [](const ExportPlan& plan) {
        return std::tuple(plan.frames.first, plan.frames.last, plan.frames.step, plan.flipbook.columns,
            plan.flipbook.rows, plan.format, plan.fitCamera, plan.outlierPercent, plan.flipbook.powerOfTwo,
            plan.flipbook.trim, plan.flipbook.retime, plan.passes.has(Pass::Motion));
    };
    return ofCells(a) == ofCells(b);
}

QString suggestedPath(const ExportPlan& plan, const Document& document)
{
    const QString folder = document.filePath().isEmpty()
        ? QStandardPaths::writableLocation(QStandardPaths::PicturesLocation)
        : QFileInfo(document.filePath()).path();
    QString name = fileNameOf(document.displayName()).toLower().replace(QLatin1Char(' '), QLatin1Char('-'));
    switch (plan.kind) {
    case ExportKind::Sequence: name += QStringLiteral("/") + name + QStringLiteral("_####"); break;
    case ExportKind::Flipbook:
        name += QStringLiteral("_%1x%2").arg(plan.flipbook.columns).arg(plan.flipbook.rows);
        break;
    case ExportKind::Video:
    case ExportKind::Picture: break;
    case ExportKind::NoiseTexture: name += QStringLiteral("-noise"); break;
    case ExportKind::Particles: name += QStringLiteral("-particles/") + name + QStringLiteral("_####"); break;
    case ExportKind::Volumes: name += QStringLiteral("-volumes/") + name + QStringLiteral("_####"); break;
    case ExportKind::Air: name += QStringLiteral("-air/") + name + QStringLiteral("_####"); break;
    }
    return QDir(folder).filePath(name) + toQString(fileEnding(plan));
}

} // namespace fumage::ui
