#pragma once

#include "ui/widgets/file_question.h"

#include "core/effect/track.h"

class QMenu;

namespace fumage::ui {

class Document;

/// Offers to write the key frames of a parameter as CSV, and to read them from it in one undo step.
/// @param track of the document
void addKeyTable(QMenu& menu, Document& document, const Track& track, const AskForFile& askForFile, QWidget* parent);

} // namespace fumage::ui
