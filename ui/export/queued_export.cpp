#include "ui/export/queued_export.h"

#include "ui/document/text.h"
#include "ui/export/export_formats.h"

#include "core/export/manifest/manifest_parts.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

namespace fumage::ui {

namespace {

/// A folder as people call it: "~/smoke".
QString folderName(const QString& folder)
{
    const QString home = QDir::homePath();
    const bool isInHome = folder == home || folder.startsWith(home + QLatin1Char('/'));
    return QDir::toNativeSeparators(isInHome ? QLatin1Char('~') + folder.mid(home.size()) : folder);
}

} // namespace

bool QueuedExport::canBeChecked() const
{
    return state == ExportState::Done && !isChecked() && !manifestOf(job->plan).empty();
}

/// What comes first is seen where there is little room.
QString placeOf(const ExportPlan& plan)
{
    const QFileInfo file(fromPath(plan.output));
    return QStringLiteral("%1 · %2 · %3").arg(kindName(plan.kind), file.fileName(), folderName(file.path()));
}

QString usualText(ExportState state)
{
    switch (state) {
    case ExportState::Held: return QCoreApplication::translate("Exports", "Interrupted");
    case ExportState::Starting:
    case ExportState::Waiting: return QCoreApplication::translate("Exports", "Waiting");
    case ExportState::Running: return QCoreApplication::translate("Exports", "Begun");
    case ExportState::Done: return QCoreApplication::translate("Exports", "Done");
    case ExportState::Failed: return QCoreApplication::translate("Exports", "Failed");
    case ExportState::Cancelled:
        return QCoreApplication::translate("Exports", "Cancelled. Files that were complete are kept.");
    }
    return {};
}

QString lineOf(const QueuedExport& one)
{
    return one.check.state == CheckState::None ? one.told : one.check.told;
}

QString wholeTextOf(const QueuedExport& one, const QString& between)
{
    return one.check.state == CheckState::None ? one.told : one.told + between + one.check.told;
}

QString tipOf(const QueuedExport& one)
{
    const QString place = QDir::toNativeSeparators(fromPath(one.job->plan.output));
    return QStringLiteral("%1\n%2").arg(place, wholeTextOf(one, QStringLiteral("\n")));
}

double shareOf(const QueuedExport& one)
{
    const int done = one.isChecked() ? one.check.done : one.done;
    const int total = one.isChecked() ? one.check.total : one.total;
    return total > 0 ? static_cast<double>(done) / total : -1.0;
}

bool mayShareFiles(const ExportPlan& one, const ExportPlan& other)
{
    if (manifestBeside(one.output) != manifestBeside(other.output)) {
        return false;
    }
    const bool areNumbered = isNumbered(one.kind) && isNumbered(other.kind);
    return !areNumbered || (one.frames.first <= other.frames.last && other.frames.first <= one.frames.last);
}

} // namespace fumage::ui
