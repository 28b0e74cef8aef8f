#include "ui/export/engine_plan.h"

#include "ui/document/text.h"
#include "ui/export/export_summary.h"

#include "core/export/loop.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

namespace fumage::ui {

namespace {

constexpr int kCellsAlong = 8;

QString text(const char* key)
{
    return QCoreApplication::translate("Engines", key);
}

} // namespace

QStringList textsOf(const EngineChoice& choice)
{
    return {toQString(nameOf(choice.engine)), QString::number(choice.edge), choice.folder};
}

EngineChoice engineChoiceOf(const QStringList& texts)
{
    EngineChoice choice;
    const auto engine =
        std::ranges::find_if(kOfferedEngines, [&](Engine each) { return toQString(nameOf(each)) == texts.value(0); });
    if (engine != kOfferedEngines.end()) {
        choice.engine = *engine;
    }
    if (const auto edge = std::ranges::find(kSheetEdges, texts.value(1).toInt()); edge != kSheetEdges.end()) {
        choice.edge = *edge;
    }
    choice.folder = QDir::isAbsolutePath(texts.value(2)) ? texts.value(2) : QString();
    return choice;
}

QString usualEngineFolder()
{
    return QDir(QStandardPaths::writableLocation(QStandardPaths::PicturesLocation)).filePath(QStringLiteral("Fumage"));
}

QString engineTitle(Engine engine)
{
    switch (engine) {
    case Engine::Generic: return text(QT_TRANSLATE_NOOP("Engines", "Any engine"));
    case Engine::Web: return text(QT_TRANSLATE_NOOP("Engines", "Web page"));
    default: return toQString(titleOf(engine));
    }
}

ExportPlan recommendedPlan(Engine engine, const Document& document, const QString& folder)
{
    const Timeline& timeline = document.scene().timeline;
    ExportPlan plan;
    plan.kind = ExportKind::Flipbook;
    plan.flipbook.engine = engine;
    plan.flipbook.powerOfTwo = true;
    plan.passes = passesFor(engine);
    plan.style = styleFor(engine, plan.format);
    plan.fitCamera = true;
    plan.frames = {0, std::max(0, timeline.length - 1), 1};
    auto [columns, rows] = gridWithin(plan.frames.count(), kCellsAlong, kCellsAlong, true);
    if (engine == Engine::Unreal) { // its function for blended cells finds them in square grids alone
        columns = rows = std::min(columns, rows);
    }
    plan.flipbook.columns = columns;
    plan.flipbook.rows = rows;
    plan.frames = closedInstead(timeline, plan.frames, columns * rows).value_or(plan.frames);
    plan.source = toPath(document.filePath());
    plan.project = document.preset();
    plan.output = toPath(QDir(folder).filePath(QFileInfo(suggestedPath(plan, document)).fileName()));
    return plan;
}

std::array<int, 2> cellsWithin(int edge, const ExportPlan& plan, const Output& output)
{
    const int longest = std::max(plan.flipbook.columns * output.width, plan.flipbook.rows * output.height);
    if (longest <= edge) {
        return {output.width, output.height};
    }
    const auto scaled = [&](int side) {
        return std::max(1, static_cast<int>(std::lround(static_cast<double>(side) * edge / longest)));
    };
    return {scaled(output.width), scaled(output.height)};
}

QStringList engineSteps(const ExportPlan& plan)
{
    const QString folder = QDir::toNativeSeparators(fromPath(plan.output.parent_path()));
    const QString sheet = fromPath(plan.output.stem());
    switch (plan.flipbook.engine) {
    case Engine::Unity:
        return {text(QT_TRANSLATE_NOOP("Engines", "Put the folder %1 into Assets of your project, if it is not there."))
                    .arg(folder),
            text(QT_TRANSLATE_NOOP(
                "Engines", "Let Unity import it: the script in the folder Editor gives each texture its settings.")),
            text(QT_TRANSLATE_NOOP("Engines",
                     "Choose Assets, Fumage, %1: it makes a particle system that plays the sheet, and a prefab of it."))
                .arg(sheet)};
    case Engine::Unreal:
        return {text(QT_TRANSLATE_NOOP("Engines", "In Unreal switch on the Python Editor Script Plugin.")),
            text(QT_TRANSLATE_NOOP("Engines",
                     "Choose Tools, Execute Python Script, and the script in %1: the textures are then in "
                     "/Game/Fumage, with the right settings."))
                .arg(folder),
            text(QT_TRANSLATE_NOOP("Engines",
                "Use FlipBook_MotionVectors in a material, with the numbers that the log says, and the material in a "
                "Niagara sprite emitter."))};
    case Engine::Godot:
    case Engine::Godot3:
        return {
            text(QT_TRANSLATE_NOOP("Engines", "Put the folder %1 into your project, if it is not there.")).arg(folder),
            text(QT_TRANSLATE_NOOP("Engines", "Let Godot import the textures: the .import files beside them say how.")),
            text(QT_TRANSLATE_NOOP("Engines", "Drag the scene %1 into yours. Its shader blends the cells."))
                .arg(sheet + QStringLiteral(".tscn"))};
    case Engine::Web:
        return {text(QT_TRANSLATE_NOOP("Engines", "Open %1 in a browser: it plays the sheet by itself."))
                    .arg(sheet + QStringLiteral(".html")),
            text(QT_TRANSLATE_NOOP("Engines", "Put the file on your server: the pictures are in it.")),
            text(QT_TRANSLATE_NOOP("Engines", "Show it in an iframe, or copy its script into your page."))};
    case Engine::Effekseer:
        return {text(QT_TRANSLATE_NOOP("Engines", "Open %1 in Effekseer."))
                    .arg(QDir::toNativeSeparators(
                        QDir(fromPath(plan.output.parent_path())).filePath(sheet + QStringLiteral(".efkproj")))),
            text(QT_TRANSLATE_NOOP("Engines", "Press Play: the node has the texture, the cells and their speed.")),
            text(QT_TRANSLATE_NOOP("Engines", "Export it for your game, with the pictures beside it."))};
    default:
        return {text(QT_TRANSLATE_NOOP("Engines", "Take the pictures in %1 into your project.")).arg(folder),
            text(QT_TRANSLATE_NOOP(
                "Engines", "Import the colours as sRGB, and light maps and motion vectors as numbers, not colours.")),
            text(QT_TRANSLATE_NOOP("Engines", "Play the cells as %1 says."))
                .arg(sheet + QStringLiteral(".flipbook.json"))};
    }
}

} // namespace fumage::ui
