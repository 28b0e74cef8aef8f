#pragma once

#include <QObject>
#include <QString>

namespace fumage::ui {

// Qt takes what looks like HTML for HTML and loads what it names, and names, paths and messages come from files that
// may hold anything. So all texts that are not literals of the program go through these; tests/layering holds tool tips
// to that.

/// A tool tip that shows a text as it is.
[[nodiscard]] QString plainToolTip(const QString& text);

/// A tool tip that shows two texts as they are, the first in bold above the other.
[[nodiscard]] QString titledToolTip(const QString& title, const QString& text);

/// A text of a menu or a button that shows a name as it is: neither a letter to press nor a shortcut is made of it.
[[nodiscard]] QString plainMenuText(const QString& text);

/// A title of a window that shows a name as it is: the mark of unsaved changes is not made of it.
[[nodiscard]] QString plainTitle(const QString& text);

/// Sees to it that labels of the whole application, Qt's own dialogs included, show their texts as they are, but where
/// they were told to show HTML; and that Qt's file dialog has no tool tips, which would be made of paths.
class PlainLabels : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace fumage::ui
