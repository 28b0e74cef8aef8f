#pragma once

#include "ui/document/commands.h"
#include "ui/document/file_mark.h"
#include "ui/document/unknown_places.h"
#include "ui/document/views.h"

#include "core/effect/parameter.h"
#include "core/preset/preset_file.h"

#include <QObject>
#include <QString>
#include <QUndoStack>

#include <optional>
#include <vector>

namespace fumage::ui {

/// A parameter with a value for it.
struct Assignment {
    const Parameter* parameter = nullptr;
    Value value;
};

/// What an edit has changed of the scene.
struct EffectChange {
    std::vector<const Parameter*> parameters; ///< that differ in the layer that is edited, from the one before
    DirtyStage stale = DirtyStage::Shade; ///< the first stage of the work that has to be done again
    bool isOfScene = true; ///< else pictures show the same: another layer is edited, or the markers are others
};

/// How the file of a document stands against what was read from it, or written to it, here.
enum class DiskState {
    Same,
    Changed, ///< by others: it holds something else
    Gone, ///< deleted or moved
};

/// The scene that is being edited, its file and its undo stack; the only one who writes the scene.
///
/// One of its layers is edited at a time: panels, gizmos and menus see it in its surroundings, as an effect, call
/// edit() or replaceEffect(), and follow effectChanged(). Lives on the GUI thread.
class Document : public QObject, private SceneHolder {
    Q_OBJECT

public:
    /// @param first what it shows before it loads anything
    explicit Document(const Preset& first = {}, QObject* parent = nullptr);

    /// The layer that is edited, in its surroundings, as it is at the time that is shown: with the values that
    /// parameters with key frames have then.
    [[nodiscard]] const Effect& effect() const { return m_effect; }
    /// The time that is shown, s: where edits put key frames.
    [[nodiscard]] double seconds() const { return m_seconds; }
    /// Shows another time. That is no undo step, and nothing of the scene.
    void setSeconds(double seconds);
    /// Whether each edit of a parameter that can change over time puts a key frame, also where it has none yet.
    [[nodiscard]] bool autoKey() const { return m_autoKey; }
    void setAutoKey(bool on);
    /// Whether a parameter may be edited: its layer is not locked, or it is of what all layers share.
    [[nodiscard]] bool canEdit(const Parameter& parameter) const;
    /// The key frames that a parameter has once it has a value at the time that is shown.
    [[nodiscard]] Track withKey(const Parameter& parameter, const Value& value) const;
    /// The key frames of a parameter of the layer that is edited, or of what all layers share; null: it does not change
    /// over time.
    [[nodiscard]] const Track* track(const Parameter& parameter) const;
    [[nodiscard]] const Scene& scene() const override { return m_preset.scene; }
    /// The number of the layer that is edited.
    [[nodiscard]] std::size_t layer() const { return m_selection.active(); }
    /// That layer, and others that go with it where something is done to whole layers.
    [[nodiscard]] const LayerSelection& selection() const override { return m_selection; }
    /// Edits another layer, and chooses others with it. That is no undo step.
    void selectLayers(const LayerSelection& selection);
    void selectLayer(std::size_t layer) { selectLayers(layer); }
    [[nodiscard]] const Preset& preset() const { return m_preset; }
    /// The layer that is edited as it was loaded or last saved, by its number: what "changed" and "reset" are measured
    /// by. A layer that was not there is measured by the first.
    [[nodiscard]] const Effect& reference() const { return m_reference; }
    /// The scene as it was loaded or last saved.
    [[nodiscard]] const Scene& referenceScene() const { return m_referenceScene; }
    [[nodiscard]] QUndoStack* undoStack() { return &m_undo; }

    /// Empty while the document has no file of its own: new, from a built-in preset, or recovered.
    [[nodiscard]] const QString& filePath() const { return m_path; }
    /// The file's name, or the preset's.
    [[nodiscard]] QString displayName() const;
    [[nodiscard]] bool isModified() const;

    [[nodiscard]] Gesture beginGesture();

    /// Clamps, compares and pushes one undo step; nothing happens where the value stays what it is. A parameter that
    /// has key frames gets one at the time that is shown.
    void edit(const Parameter& parameter, const Value& value, Gesture gesture = {});
    /// Several parameters in one step.
    /// @param text of the undo step; empty: the parameters' names and their new values
    void edit(const std::vector<Assignment>& assignments, const QString& text, Gesture gesture = {});
    void replaceEffect(const Effect& effect, const QString& text, Gesture gesture = {});
    /// Other layers, or others in another order.
    /// @param selection that is chosen afterwards, all below their number
    void replaceScene(const Scene& scene, const LayerSelection& selection, const QString& text, Gesture gesture = {});
    /// Says more of layers that have been added than is known here, as a file would. It goes with them and comes with
    /// them, and is no step of its own.
    /// @param said of layers by their places now
    void addUnknown(const std::vector<UnknownMember>& said) { m_unknown.add(m_preset, said); }
    /// Back to what was loaded or last saved, key frames too.
    void reset(const Parameter& parameter);

    /// Looks from somewhere else. That is a change, and no undo step: undoing a colour must not throw the camera away.
    /// It has a history of its own.
    void moveCamera(const Camera& camera, Gesture gesture = {});
    [[nodiscard]] const Views& views() const { return m_views; }
    /// To the view before or after this one; nothing happens where there is none.
    void previousView();
    void nextView();

    /// Shows another preset with an empty undo stack.
    /// @param path its file; empty where it has none, so that saving asks for one
    /// @param modified it is not in any file yet: recovered, or pasted
    /// @param read     the mark of the file when it was read; nothing: as it is now
    void load(const Preset& preset, const QString& path, bool modified = false,
        const std::optional<FileMark>& read = std::nullopt);
    /// Shows work that was never saved: where its file can be read, as a step after what the file holds, so that it can
    /// be undone.
    /// @param read the mark of the file that the work began with; nothing: as it is now
    void loadUnsaved(const Preset& work, const QString& path, const std::optional<FileMark>& read = std::nullopt);
    /// Writes the preset to a file, which becomes the document's own.
    /// @error those of writePresetFile(); nothing has changed then
    [[nodiscard]] Status save(const QString& path);

    /// The mark of the document's file when it was last read or written here; empty: there was none.
    [[nodiscard]] const FileMark& fileMark() const { return m_read; }
    /// Looks at the file again. A document whose file is gone counts as unsaved work until it is back.
    [[nodiscard]] DiskState compareWithDisk();
    /// Takes over what others have written to the file, as an undo step after which the document is as saved.
    /// @error those of readPresetFile(); nothing has changed then
    [[nodiscard]] Result<PresetReading> reload();
    /// This is what the document is to be, whatever others have written: it is unsaved work over what the file holds
    /// now.
    void keepOverDisk();

signals:
    void effectChanged(const fumage::ui::EffectChange& change);
    /// Other layers, or other names or marks of theirs.
    void layersChanged();
    /// Other layers are chosen; comes after layersChanged().
    void selectionChanged();
    /// The document shows another preset: views start anew.
    void loaded();
    /// Name, file or modified state.
    void titleChanged();
    void autoKeyChanged(bool on);
    /// There is another view before or after this one.
    void viewsChanged();

private:
    void write(const Scene& scene, const LayerSelection& selection, std::vector<const Parameter*> changed) override;
    void rebase();
    void setCamera(const Camera& camera);
    /// The layer of the reference that one is measured by.
    [[nodiscard]] std::size_t referenceLayer(std::size_t layer) const
    {
        return layer < m_referenceScene.layers.size() ? layer : 0;
    }
    /// That layer at the time that is shown.
    [[nodiscard]] Effect referenceNow(std::size_t layer) const;
    /// Adds the parameters of a layer that change over time: of any the value at the time that is shown may be another.
    static void addKeyed(const Scene& scene, std::size_t layer, std::vector<const Parameter*>& changed);
    /// Whether an edit of a parameter puts a key frame.
    [[nodiscard]] bool getsKey(const Parameter& parameter) const;
    /// Several parameters in one step, of which some have key frames.
    void editKeys(const std::vector<EditCommand::Change>& changes, const QString& text, Gesture gesture);

    Preset m_preset;
    UnknownPlaces m_unknown; ///< of what the preset's file says beside what is known
    LayerSelection m_selection;
    Effect m_effect; ///< the active layer
    Scene m_referenceScene;
    Effect m_reference; ///< that layer of it
    QString m_path;
    double m_seconds = 0.0;
    bool m_autoKey = false;
    QUndoStack m_undo;
    Views m_views;
    quint64 m_gestures = 0;
    FileMark m_read; ///< of the file
    bool m_fileIsGone = false;
    bool m_unsavedFromStart = false; ///< modified even with an empty undo stack
};

} // namespace fumage::ui
