#pragma once

#include "core/effect/parameter.h"

#include <QUndoCommand>

#include <vector>

namespace fumage::ui {

/// Edits that belong to one gesture of the hand become one undo step: press to release, one typing, one burst of the
/// wheel.
struct Gesture {
    quint64 id = 0; ///< 0: each edit is a step of its own
};

/// What commands read and write.
class EffectHolder {
public:
    [[nodiscard]] virtual const Effect& effect() const = 0;
    /// @param changed all parameters that differ from before
    virtual void write(const Effect& effect, std::vector<const Parameter*> changed) = 0;

protected:
    ~EffectHolder() = default;
};

/// Sets one or a few parameters; merges with the one before while the hand has not let go.
class EditCommand : public QUndoCommand {
public:
    struct Change {
        const Parameter* parameter;
        Value before;
        Value after;
    };

    /// @param text empty: names and new values of what is changed
    EditCommand(EffectHolder& holder, std::vector<Change> changes, const QString& text, Gesture gesture);

    void undo() override;
    void redo() override;
    [[nodiscard]] int id() const override;
    bool mergeWith(const QUndoCommand* other) override;

private:
    void write(Value Change::*value);
    void describe();

    EffectHolder& m_holder;
    std::vector<Change> m_changes;
    bool m_isNamed; ///< by whoever made it
    Gesture m_gesture;
};

/// Exchanges the whole effect: a reset, a paste, a variation.
class ReplaceCommand : public QUndoCommand {
public:
    ReplaceCommand(EffectHolder& holder, const Effect& after, const QString& text, Gesture gesture);

    void undo() override;
    void redo() override;
    [[nodiscard]] int id() const override;
    bool mergeWith(const QUndoCommand* other) override;

private:
    void show(Effect effect);

    EffectHolder& m_holder;
    Effect m_before;
    Effect m_after;
    Gesture m_gesture;
};

} // namespace fumage::ui
