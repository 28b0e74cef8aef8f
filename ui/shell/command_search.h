#pragma once

#include "ui/shell/action_table.h"

#include <QDialog>

class QLineEdit;
class QListWidget;

namespace fumage::ui {

/// Finds a command or a parameter by some of its letters and does it, or goes there.
class CommandSearch : public QDialog {
    Q_OBJECT

public:
    CommandSearch(ActionSet& actions, QWidget* parent);

signals:
    void parameterChosen(const QString& key);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void fill();
    void filter(const QString& text);
    void choose();

    ActionSet& m_actions;
    QLineEdit* m_search;
    QListWidget* m_list;
};

} // namespace fumage::ui
