#include "ui/shell/edit_actions.h"

#include "ui/document/key_edits.h"
#include "ui/widgets/gesture.h"
#include "ui/widgets/plain_text.h"
#include "ui/shell/action_table.h"

#include "core/effect/parameter_table.h"
#include "core/effect/variation.h"

#include <QRandomGenerator>

namespace fumage::ui {

namespace {

/// How far one throw of the dice goes, as a share of the soft range: a little less than the variations begin with.
constexpr float kALittle = 0.06F;

} // namespace

EditActions::EditActions(const ActionSet& actions, Document& document, const Locks& locks)
    : m_actions(actions)
    , m_document(document)
    , m_locks(locks)
{
    connectUndo();
    m_actions.on("edit.randomise", this, &EditActions::randomise);
    m_actions.on("edit.resetAll", this, [this] {
        std::vector<const Parameter*> all;
        for (const Parameter& parameter : parameterTable()) {
            all.push_back(&parameter);
        }
        resetParameters(m_document, all, tr("Reset all parameters"));
    });
}

void EditActions::connectUndo()
{
    QUndoStack* stack = m_document.undoStack();
    connect(stack, &QUndoStack::indexChanged, this, &EditActions::nameUndo);
    nameUndo();
    // In the middle of a drag the step before it may be the layer that is dragged in.
    m_actions.on("edit.undo", stack, [stack] {
        if (!takeDragBack()) {
            stack->undo();
        }
    });
    m_actions.on("edit.redo", stack, [stack] {
        if (!takeDragBack()) {
            stack->redo();
        }
    });
}

void EditActions::nameUndo()
{
    const QUndoStack& stack = *m_document.undoStack();
    m_actions.get("edit.undo").setEnabled(stack.canUndo());
    m_actions.get("edit.redo").setEnabled(stack.canRedo());
    m_actions.get("edit.undo")
        .setText(stack.canUndo() ? tr("&Undo %1").arg(plainMenuText(stack.undoText())) : tr("&Undo"));
    m_actions.get("edit.redo")
        .setText(stack.canRedo() ? tr("&Redo %1").arg(plainMenuText(stack.redoText())) : tr("&Redo"));
}

void EditActions::randomise()
{
    const auto mayVary = [this](const Parameter& parameter) { return m_locks.mayVary(parameter); };
    m_document.replaceEffect(
        vary(m_document.effect(), kALittle, QRandomGenerator::global()->generate(), mayVary), tr("Randomise slightly"));
}

} // namespace fumage::ui
