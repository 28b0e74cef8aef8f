#pragma once

#include "ui/document/layer_selection.h"

#include "core/effect/parameter.h"
#include "core/scene/scene.h"

#include <QUndoCommand>

#include <vector>

namespace fumage::ui {

/// Edits that belong to one gesture of the hand become one undo step: press to release, one typing, one burst of the
/// wheel.
struct Gesture {
    quint64 id = 0; ///< 0: each edit is a step of its own
};

/// What commands read and write.
class SceneHolder {
public:
    [[nodiscard]] virtual const Scene& scene() const = 0;
    /// The layers that are chosen, of which the active one is edited.
    [[nodiscard]] virtual const LayerSelection& selection() const = 0;
    /// @param selection that is chosen from now on
    /// @param changed   all parameters that differ from before
    virtual void write(const Scene& scene, const LayerSelection& selection, std::vector<const Parameter*> changed) = 0;

protected:
    ~SceneHolder() = default;
};

/// Sets one or a few parameters of the layer that is edited, or of what all share; merges with the one before while the
/// hand has not let go.
class EditCommand : public QUndoCommand {
public:
    struct Change {
        const Parameter* parameter;
        Value before;
        Value after;
    };

    /// @param text empty: names and new values of what is changed
    EditCommand(SceneHolder& holder, std::vector<Change> changes, const QString& text, Gesture gesture);

    void undo() override;
    void redo() override;
    [[nodiscard]] int id() const override;
    bool mergeWith(const QUndoCommand* other) override;

private:
    void write(Value Change::*value);
    void describe();

    SceneHolder& m_holder;
    std::size_t m_layer;
    std::vector<Change> m_changes;
    bool m_isNamed; ///< by whoever made it
    Gesture m_gesture;
};

/// Exchanges the whole scene: a reset, a paste, a variation, a layer more or less.
class ReplaceCommand : public QUndoCommand {
public:
    /// @param selection that is chosen afterwards
    ReplaceCommand(
        SceneHolder& holder, const Scene& after, LayerSelection selection, const QString& text, Gesture gesture);

    void undo() override;
    void redo() override;
    [[nodiscard]] int id() const override;
    bool mergeWith(const QUndoCommand* other) override;

private:
    void show(Scene scene, const LayerSelection& selection);

    SceneHolder& m_holder;
    Scene m_before;
    Scene m_after;
    LayerSelection m_selectionBefore;
    LayerSelection m_selectionAfter;
    Gesture m_gesture;
};

} // namespace fumage::ui
