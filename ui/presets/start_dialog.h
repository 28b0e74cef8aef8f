#pragma once

#include "ui/presets/preset_list.h"

#include <QDialog>

class QCheckBox;

namespace fumage::ui {

class SceneCard;

/// What an empty session shows first: presets to begin with and the files of last time.
class StartDialog : public QDialog {
    Q_OBJECT

public:
    StartDialog(const QStringList& recentFiles, QWidget* parent);

    [[nodiscard]] bool showAgain() const;
    void setShowAgain(bool shows);
    /// Whether what is first moves by itself, and the others under the pointer.
    void setPlays(bool plays);

signals:
    void presetChosen(const fumage::Preset& preset);
    void fileChosen(const QString& path);
    void openRequested();
    void defaultRequested();

private:
    void connectScenes();
    void choose(const Preset& preset);

    PresetList* m_list;
    SceneCard* m_card;
    QCheckBox* m_again;
};

} // namespace fumage::ui
