#include "ui/export/export_summary.h"

#include "ui/document/text.h"
#include "ui/export/export_dialog.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

namespace fumage::ui {

bool isPossible(const ExportPlan& plan)
{
    const bool filled = plan.kind != ExportKind::Flipbook || plan.frames.count() >= plan.columns * plan.rows;
    return !plan.output.empty() && plan.frames.first <= plan.frames.last && filled;
}

QString summaryOf(const ExportPlan& plan, const Effect& effect)
{
    if (plan.output.empty() || plan.frames.first > plan.frames.last) {
        return ExportDialog::tr("Choose a file, and a first frame that comes before the last.");
    }
    if (!isPossible(plan)) {
        return ExportDialog::tr("%1 frames do not fill %2 cells: choose more frames or fewer columns and rows.").arg(plan.frames.count()).arg(plan.columns * plan.rows);
    }
    const QString first = toQString(firstFile(plan).filename().string());
    if (plan.kind == ExportKind::Sequence) {
        return ExportDialog::tr("Files: %1, from %2 to %3").arg(plan.frames.count()).arg(first, toQString(lastFile(plan).filename().string()));
    }
    if (plan.kind == ExportKind::Flipbook) {
        const Output& output = effect.output;
        return ExportDialog::tr("%1, %2 × %3 pixels, and how it is to be played beside it").arg(first).arg(output.width * plan.columns).arg(output.height * plan.rows);
    }
    return first;
}

QString suggestedPath(const ExportPlan& plan, const Document& document)
{
    const QString folder = document.filePath().isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::PicturesLocation) : QFileInfo(document.filePath()).path();
    QString name = fileNameOf(document.displayName()).toLower().replace(QLatin1Char(' '), QLatin1Char('-'));
    switch (plan.kind) {
    case ExportKind::Sequence: name += QStringLiteral("/") + name + QStringLiteral("_####"); break;
    case ExportKind::Flipbook: name += QStringLiteral("-%1x%2").arg(plan.columns).arg(plan.rows); break;
    case ExportKind::Picture: break;
    case ExportKind::NoiseTexture: name += QStringLiteral("-noise"); break;
    case ExportKind::Particles: name += QStringLiteral("-particles"); break;
    }
    return QDir(folder).filePath(name) + toQString(fileEnding(plan));
}

std::optional<int> formatNamedBy(const QString& path, ExportKind kind)
{
    const QString ending = QFileInfo(path).suffix().toLower();
    const bool particles = kind == ExportKind::Particles;
    if (ending == QStringLiteral("png") && !particles) {
        return static_cast<int>(ImageFormat::Png8);
    }
    if (ending == QStringLiteral("exr") && !particles) {
        return static_cast<int>(ImageFormat::ExrHalf);
    }
    if (ending == QStringLiteral("csv") && particles) {
        return static_cast<int>(ParticleFormat::Csv);
    }
    if (ending == QStringLiteral("ply") && particles) {
        return static_cast<int>(ParticleFormat::Ply);
    }
    return std::nullopt;
}

QString withEndingOf(const ExportPlan& plan, const QString& path)
{
    for (const QString& ending : {QStringLiteral(".png"), QStringLiteral(".exr"), QStringLiteral(".csv"), QStringLiteral(".ply")}) {
        if (path.endsWith(ending, Qt::CaseInsensitive)) {
            return path.chopped(ending.size()) + toQString(fileEnding(plan));
        }
    }
    return path;
}

} // namespace fumage::ui
