#include "ui/document/commands.h"

#include "ui/document/parameter_text.h"

#include "core/effect/value.h"

#include <algorithm>

namespace fumage::ui {

namespace {

enum CommandId {
    kEdit = 1,
    kReplace = 2,
};

} // namespace

EditCommand::EditCommand(SceneHolder& holder, std::vector<Change> changes, const QString& text, Gesture gesture)
    : QUndoCommand(text)
    , m_holder(holder)
    , m_layer(holder.selection().active())
    , m_changes(std::move(changes))
    , m_isNamed(!text.isEmpty())
    , m_gesture(gesture)
{
    describe();
}

void EditCommand::describe()
{
    if (m_isNamed) {
        return;
    }
    QStringList parts;
    for (const Change& change : m_changes) {
        parts += (fullLabelOf(*change.parameter) + QLatin1Char(' ') + valueTextOf(*change.parameter, change.after))
                     .trimmed();
    }
    setText(parts.join(QStringLiteral(", ")));
}

void EditCommand::undo()
{
    write(&Change::before);
}

void EditCommand::redo()
{
    write(&Change::after);
}

void EditCommand::write(Value Change::*value)
{
    Scene scene = m_holder.scene();
    Effect effect = scene.effect(m_layer);
    std::vector<const Parameter*> changed;
    for (const Change& change : m_changes) {
        change.parameter->set(effect, change.*value);
        changed.push_back(change.parameter);
    }
    scene.assign(m_layer, effect);
    const LayerSelection& now = m_holder.selection();
    m_holder.write(scene, now.active() == m_layer ? LayerSelection(now) : LayerSelection(m_layer), std::move(changed));
}

int EditCommand::id() const
{
    return m_gesture.id == 0 ? -1 : kEdit;
}

bool EditCommand::mergeWith(const QUndoCommand* other)
{
    const auto* next = dynamic_cast<const EditCommand*>(other);
    if (next == nullptr || next->m_gesture.id != m_gesture.id || next->m_layer != m_layer) {
        return false;
    }
    for (const Change& change : next->m_changes) {
        const auto mine = std::find_if(
            m_changes.begin(), m_changes.end(), [&](const Change& c) { return c.parameter == change.parameter; });
        if (mine == m_changes.end()) {
            m_changes.push_back(change);
        } else {
            mine->after = change.after;
        }
    }
    describe();
    // A drag back to where it began leaves no trace.
    setObsolete(std::all_of(m_changes.begin(), m_changes.end(), [](const Change& c) { return c.before == c.after; }));
    return true;
}

ReplaceCommand::ReplaceCommand(
    SceneHolder& holder, const Scene& after, LayerSelection selection, const QString& text, Gesture gesture)
    : QUndoCommand(text)
    , m_holder(holder)
    , m_before(holder.scene())
    , m_after(after)
    , m_selectionBefore(holder.selection())
    , m_selectionAfter(std::move(selection))
    , m_gesture(gesture)
{
}

void ReplaceCommand::undo()
{
    show(m_before, m_selectionBefore);
}

void ReplaceCommand::redo()
{
    show(m_after, m_selectionAfter);
}

/// Where both look from the same place the camera stays where it is now: moving it is no undo step.
void ReplaceCommand::show(Scene scene, const LayerSelection& selection)
{
    if (m_before.camera == m_after.camera) {
        scene.camera = m_holder.scene().camera;
    }
    const Effect shown = m_holder.scene().effect(m_holder.selection().active());
    m_holder.write(scene, selection, differences(shown, scene.effect(selection.active())));
}

int ReplaceCommand::id() const
{
    return m_gesture.id == 0 ? -1 : kReplace;
}

bool ReplaceCommand::mergeWith(const QUndoCommand* other)
{
    const auto* next = dynamic_cast<const ReplaceCommand*>(other);
    if (next == nullptr || next->m_gesture.id != m_gesture.id) {
        return false;
    }
    m_after = next->m_after;
    m_selectionAfter = next->m_selectionAfter;
    setObsolete(m_before == m_after);
    return true;
}

} // namespace fumage::ui
