#pragma once

#include "ui/panels/parameter_editor.h"
#include "ui/widgets/file_question.h"

class QToolButton;

namespace fumage::ui {

/// A picture in small, which is chosen by pressing it or by dropping a PNG on it, and a button that removes it. What
/// cannot be read is said, and the picture before stays.
class PictureEditor : public ParameterEditor {
    Q_OBJECT

public:
    /// @param askForFile for the name of the PNG
    PictureEditor(const Parameter& parameter, QWidget* parent, AskForFile askForFile = askInDialog);
    void setValue(const Value& value) override;

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void choose();
    void take(const QString& path);
    void change(const Bitmap& picture);
    void showPicture();

    const AskForFile m_askForFile;
    QToolButton* m_picture;
    QToolButton* m_clear;
    Bitmap m_value;
};

} // namespace fumage::ui
