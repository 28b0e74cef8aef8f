#pragma once

#include "ui/document/document.h"
#include "ui/document/locks.h"
#include "ui/panels/parameter_editor.h"

#include "core/effect/shown_table.h"

#include <QLabel>

#include <optional>

class QMenu;
class QToolButton;

namespace fumage::ui {

class KeyMark;

/// One parameter in a panel: its label, a mark where it differs from the preset, and its editor, bound to the document.
class ParameterRow : public QWidget {
    Q_OBJECT

public:
    ParameterRow(const Parameter& parameter, Document& document, Locks& locks, QWidget* parent);

    static constexpr int kLabelWidth = 136; ///< pixels; other rows may line up with it

    [[nodiscard]] const Parameter& parameter() const { return m_editor->parameter(); }
    /// The one that the effect holds; another where this one is derived.
    [[nodiscard]] const Parameter& stored() const { return storedParameter(parameter()); }
    [[nodiscard]] ParameterEditor& editor() const { return *m_editor; }

    /// Shows what the document holds.
    void sync();
    /// Another name than the parameter's, where it means something of its own; empty: the parameter's.
    void setName(const QString& name);
    /// Puts something before all objectNames, where the same parameter has another row elsewhere.
    void prefixNames(const QString& prefix);
    /// Whether the document differs from the preset here.
    [[nodiscard]] bool isChanged() const { return m_state.changed; }
    /// Whether the parameter has key frames; one that is derived has none of its own.
    [[nodiscard]] bool isAnimated() const { return m_document.track(parameter()) != nullptr; }

protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    /// What the label tells beside the name.
    struct State {
        bool changed = false;
        bool locked = false;
        friend bool operator==(const State&, const State&) = default;
    };
    void edit(const Value& value, bool finished);
    /// Value and key frames are as they were before the gesture.
    void takeBack();
    void showState();
    void showName();
    void showLock(bool locked);
    void copy(bool asAssignment) const;
    void paste();
    void addKeyActions(QMenu& menu);

    Document& m_document;
    Locks& m_locks;
    QString m_name; ///< what the label says
    QLabel* m_label;
    QToolButton* m_lock = nullptr; ///< the mark of a lock, inside the label; null until there was one
    ParameterEditor* m_editor;
    KeyMark* m_key = nullptr; ///< null: the parameter cannot change over time
    Gesture m_gesture; ///< of the edits since the last finished one
    Value m_before; ///< the gesture
    std::optional<Track> m_trackBefore; ///< the gesture; nothing: it had no key frames
    bool m_isTakenBack = false; ///< the gesture ends where it began
    Value m_shown;
    State m_state;
    bool m_hasShown = false;
};

} // namespace fumage::ui
