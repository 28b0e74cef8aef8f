#pragma once

#include "ui/document/document.h"

#include "core/export/plan.h"

#include <array>

#include <QStringList>

namespace fumage::ui {

/// The engines that most artists have, in the order in which they are offered. The export dialog has all.
inline constexpr std::array kOfferedEngines{
    Engine::Unity, Engine::Unreal, Engine::Godot, Engine::Web, Engine::Effekseer};

/// The longer side of a sheet, pixels: what is offered, and what is meant where nobody chooses.
inline constexpr std::array kSheetEdges{1024, 2048, 4096};
inline constexpr int kUsualSheetEdge = 2048;

/// What was chosen last.
struct EngineChoice {
    Engine engine = Engine::Unity; ///< one of kOfferedEngines
    int edge = kUsualSheetEdge; ///< one of kSheetEdges
    QString folder{}; ///< empty: usualEngineFolder()
};
/// As it is remembered, and back; what is missing, or is none of what is offered, is as where nobody chooses.
[[nodiscard]] QStringList textsOf(const EngineChoice& choice);
[[nodiscard]] EngineChoice engineChoiceOf(const QStringList& texts);

/// Where files for engines go at first.
[[nodiscard]] QString usualEngineFolder();

/// What people call an engine.
[[nodiscard]] QString engineTitle(Engine engine);

/// The flipbook that an engine is best given of a document: its passes, signs and channels, as many cells as its frames
/// fill, 8 x 8 at most, the whole animation without a jump where it loops, and all smoke in sight.
/// @param folder for its files, which are named after the document
[[nodiscard]] ExportPlan recommendedPlan(Engine engine, const Document& document, const QString& folder);

/// Width and height of the cells of a plan's sheet whose longer side is no longer than an edge, in the ratio of the
/// output; the output's own where that fits.
[[nodiscard]] std::array<int, 2> cellsWithin(int edge, const ExportPlan& plan, const Output& output);

/// What is done in the engine once the files are there, in three steps. Plain text.
[[nodiscard]] QStringList engineSteps(const ExportPlan& plan);

} // namespace fumage::ui
