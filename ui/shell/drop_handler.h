#pragma once

#include <QObject>

class QDropEvent;
class QWidget;

namespace fumage::ui {

class DocumentFiles;
class PresetList;

/// Opens what is dropped on a window: a file, or a preset that was dragged out of the list.
class DropHandler : public QObject {
    Q_OBJECT

public:
    DropHandler(QWidget& window, DocumentFiles& files, const PresetList& presets);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void drop(QDropEvent& event);

    DocumentFiles& m_files;
    const PresetList& m_presets;
};

} // namespace fumage::ui
