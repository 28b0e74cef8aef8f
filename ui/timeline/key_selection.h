#pragma once

#include "ui/document/key_edits.h"

#include <QObject>

#include <vector>

namespace fumage::ui {

/// Which key frames are selected, and of which parameters the graph shows the curves: the same for lanes and graph.
///
/// Looks at the layer that is edited and at what all layers share. Key frames that go are selected no more.
class KeySelection : public QObject {
    Q_OBJECT

public:
    explicit KeySelection(Document& document, QObject* parent = nullptr);

    /// What changes over time, in the order of the table.
    [[nodiscard]] const std::vector<Track>& tracks() const { return m_tracks; }
    /// @return null: the parameter does not change over time
    [[nodiscard]] const Track* track(const Parameter& parameter) const;
    [[nodiscard]] const std::vector<KeyPlace>& keys() const { return m_keys; }
    [[nodiscard]] bool contains(const KeyPlace& key) const;
    /// Selects other key frames, of those that are there, each once. Where any are, the graph shows their parameters.
    void select(const std::vector<KeyPlace>& keys);
    /// A key frame is pressed: it is selected alone, or too with Shift or Ctrl; Ctrl leaves out one that was.
    void press(const KeyPlace& key, Qt::KeyboardModifiers modifiers);

    /// Those whose curves are shown; the first track where none has been chosen.
    [[nodiscard]] std::vector<const Parameter*> shown() const;
    [[nodiscard]] bool isShown(const Parameter& parameter) const;
    /// Shows the curve of a parameter alone, or that too, or it no more where it was.
    void show(const Parameter& parameter, bool toggles);

signals:
    /// Other key frames are there.
    void tracksChanged();
    /// Others are selected, or other curves shown.
    void changed();

private:
    void sync();
    [[nodiscard]] bool isThere(const KeyPlace& key) const;

    Document& m_document;
    std::vector<Track> m_tracks;
    std::vector<KeyPlace> m_keys;
    std::vector<const Parameter*> m_shown; ///< as they were chosen, those that have no track any more too
};

} // namespace fumage::ui
