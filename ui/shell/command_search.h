#pragma once

#include "ui/document/search_index.h"
#include "ui/shell/action_table.h"

#include "core/preset/library.h"

#include <QDialog>

#include <functional>
#include <vector>

class QLabel;
class QLineEdit;
class QListWidget;
class QListWidgetItem;

namespace fumage::ui {

/// Finds a command, a choice of a menu, a parameter or a preset by some of its letters and does it, or goes there.
class CommandSearch : public QDialog {
    Q_OBJECT

public:
    CommandSearch(ActionSet& actions, QWidget* parent);

signals:
    void parameterChosen(const QString& key);
    void presetChosen(const fumage::LibraryEntry& entry);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void fill();
    void addCommands();
    void addParameters();
    void addPresets();
    /// @param texts it is found by
    QListWidgetItem* add(const QString& text, const SearchTexts& texts, std::function<void()> act);
    void filter(const QString& text);
    void choose();

    ActionSet& m_actions;
    QLineEdit* m_search;
    QListWidget* m_list;
    QLabel* m_nothing; ///< says that nothing was found
    SearchIndex m_index;
    std::vector<std::function<void()>> m_acts; ///< one an item, in the order in which they were added
};

} // namespace fumage::ui
