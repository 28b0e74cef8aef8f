#pragma once

#include <QString>
#include <QStringList>

#include <functional>

class QWidget;

namespace fumage::ui {

/// A question with a few answers.
struct ChoiceQuestion {
    QString name; ///< objectName of the box
    QString title;
    QString text;
    QStringList answers; ///< on the buttons: the first is that of Return, the last that of Escape
};

/// Asks a person to choose.
/// @return the index of the answer
using AskForChoice = std::function<int(QWidget* parent, const ChoiceQuestion& question)>;

/// Asks in a box.
[[nodiscard]] int askInBox(QWidget* parent, const ChoiceQuestion& question);

} // namespace fumage::ui
