#pragma once

#include "core/effect/parameter.h"
#include "core/preset/preset.h"

#include <QObject>
#include <QString>
#include <QUndoStack>

#include <vector>

namespace fumage::ui {

/// Edits that belong to one gesture of the hand become one undo step: press to release, one typing, one burst of the wheel.
struct Gesture {
    quint64 id = 0; ///< 0: each edit is a step of its own
};

/// A parameter with a value for it.
struct Assignment {
    const Parameter* parameter = nullptr;
    Value value;
};

/// What an edit has changed of the effect.
struct EffectChange {
    std::vector<const Parameter*> parameters;
    Stage stale = Stage::Shade; ///< the first stage of the work that has to be done again
};

/// The effect that is being edited, its file and its undo stack; the only one who writes the effect.
///
/// Panels, gizmos and menus call edit() or replaceEffect(), and follow effectChanged(). Lives on the GUI thread.
class Document : public QObject {
    Q_OBJECT

public:
    explicit Document(QObject* parent = nullptr);

    [[nodiscard]] const Effect& effect() const { return m_preset.effect; }
    [[nodiscard]] const Preset& preset() const { return m_preset; }
    /// The effect as it was loaded or last saved: what "changed" and "reset" are measured by.
    [[nodiscard]] const Effect& reference() const { return m_reference; }
    [[nodiscard]] QUndoStack* undoStack() { return &m_undo; }

    /// Empty while the document has no file of its own: new, from a built-in preset, or recovered.
    [[nodiscard]] const QString& filePath() const { return m_path; }
    /// The file's name, or the preset's.
    [[nodiscard]] QString displayName() const;
    [[nodiscard]] bool isModified() const;

    [[nodiscard]] Gesture beginGesture();

    /// Clamps, compares and pushes one undo step; nothing happens where the value stays what it is.
    void edit(const Parameter& parameter, const Value& value, Gesture gesture = {});
    /// Several parameters in one step.
    /// @param text of the undo step; empty: the parameters' names and their new values
    void edit(const std::vector<Assignment>& assignments, const QString& text, Gesture gesture = {});
    void replaceEffect(const Effect& effect, const QString& text, Gesture gesture = {});
    void reset(const Parameter& parameter);

    /// Shows another preset with an empty undo stack.
    /// @param path its file; empty where it has none, so that saving asks for one
    /// @param modified it is not in any file yet: recovered, or pasted
    void load(const Preset& preset, const QString& path, bool modified = false);
    /// Shows work that was never saved: where its file can be read, as a step after what the file holds, so that it can be undone.
    void loadUnsaved(const Preset& work, const QString& path);
    /// Writes the preset to a file, which becomes the document's own.
    /// @error those of writePresetFile(); nothing has changed then
    [[nodiscard]] Status save(const QString& path);

signals:
    void effectChanged(const fumage::ui::EffectChange& change);
    /// The document shows another preset: views start anew.
    void loaded();
    /// Name, file or modified state.
    void titleChanged();

private:
    friend class EditCommand;
    friend class ReplaceCommand;
    void write(const Effect& effect, std::vector<const Parameter*> changed);
    void announce(std::vector<const Parameter*> changed);
    void rebase();

    Preset m_preset;
    Effect m_reference;
    QString m_path;
    QUndoStack m_undo;
    quint64 m_gestures = 0;
    bool m_unsavedFromStart = false; ///< modified even with an empty undo stack
};

} // namespace fumage::ui
