#pragma once

#include "ui/presets/preset_list.h"

#include <QDialog>

class QCheckBox;

namespace fumage::ui {

/// What an empty session shows first: presets to begin with and the files of last time.
class StartDialog : public QDialog {
    Q_OBJECT

public:
    StartDialog(const QStringList& recentFiles, QWidget* parent);

    [[nodiscard]] bool showAgain() const;
    void setShowAgain(bool shows);

signals:
    void presetChosen(const fumage::Preset& preset);
    void fileChosen(const QString& path);
    void openRequested();
    void defaultRequested();

private:
    QCheckBox* m_again;
};

} // namespace fumage::ui
