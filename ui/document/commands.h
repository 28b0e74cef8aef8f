#pragma once

#include "ui/document/document.h"

#include <QUndoCommand>

namespace fumage::ui {

/// Sets one or a few parameters; merges with the one before while the hand has not let go.
class EditCommand : public QUndoCommand {
public:
    struct Change {
        const Parameter* parameter;
        Value before;
        Value after;
    };

    /// @param text empty: names and new values of what is changed
    EditCommand(Document& document, std::vector<Change> changes, const QString& text, Gesture gesture);

    void undo() override;
    void redo() override;
    [[nodiscard]] int id() const override;
    bool mergeWith(const QUndoCommand* other) override;

private:
    void write(Value Change::*value);
    void describe();

    Document& m_document;
    std::vector<Change> m_changes;
    bool m_isNamed; ///< by whoever made it
    Gesture m_gesture;
};

/// Exchanges the whole effect: a reset, a paste, a variation.
class ReplaceCommand : public QUndoCommand {
public:
    ReplaceCommand(Document& document, const Effect& after, const QString& text, Gesture gesture);

    void undo() override;
    void redo() override;
    [[nodiscard]] int id() const override;
    bool mergeWith(const QUndoCommand* other) override;

private:
    void show(Effect effect);

    Document& m_document;
    Effect m_before;
    Effect m_after;
    Gesture m_gesture;
};

} // namespace fumage::ui
