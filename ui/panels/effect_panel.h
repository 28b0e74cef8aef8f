#pragma once

#include "ui/panels/parameter_row.h"

#include <QScrollArea>

#include <vector>

class QLabel;
class QLineEdit;
class QToolButton;

namespace fumage::ui {

/// A group of parameters under a heading that folds it.
class ParameterGroup : public QWidget {
    Q_OBJECT

public:
    /// @param name objectName without its "group."
    ParameterGroup(const QString& name, const QString& label, std::vector<ParameterRow*> rows, Document& document, QWidget* parent);

    [[nodiscard]] bool isOpen() const;
    void setOpen(bool open);
    void sync();
    /// The rows of some parameters.
    void sync(const std::vector<const Parameter*>& changed);
    /// Shows the rows that match and are of use as the effect stands. @return whether there is one
    bool filter(const QStringList& words, bool onlyChanged);

    /// All values as lines of "key=value", on the clipboard.
    void copy() const;
    /// Takes over those lines of the clipboard that are of this group, in one step; without one nothing happens.
    void paste();
    /// Puts all back to what the preset says, in one step.
    void reset();

protected:
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    void showRows();
    void showMark();
    [[nodiscard]] bool isWanted(const ParameterRow& row) const;
    [[nodiscard]] std::vector<Assignment> pasted() const;

    Document& m_document;
    QToolButton* m_heading;
    QWidget* m_content;
    std::vector<ParameterRow*> m_rows;
    QString m_label;
    QStringList m_words;
    bool m_onlyChanged = false;
};

/// All parameters of the effect, generated from the parameter table: a search field above groups that fold. On top those that an artist needs
/// first stand once more.
class EffectPanel : public QWidget {
    Q_OBJECT

public:
    EffectPanel(Document& document, Locks& locks, QWidget* parent = nullptr);

    /// Scrolls to a group and opens it.
    void showGroup(std::string_view group);
    /// Opens the group of a parameter, scrolls to it and gives it the focus.
    void showParameter(const QString& key);
    /// Puts the cursor into the search field.
    void search();
    [[nodiscard]] QStringList openGroups() const;
    void setOpenGroups(const QStringList& groups);
    /// Those that are open as long as nobody says otherwise.
    [[nodiscard]] static QStringList usualGroups();

    QSize sizeHint() const override { return {372, 700}; }

private:
    void sync();
    void follow(const EffectChange& change);
    void filter();
    [[nodiscard]] QWidget* makeGroups(Locks& locks);

    Document& m_document;
    QLineEdit* m_search;
    QToolButton* m_onlyChanged;
    QLabel* m_nothing; ///< says that nothing was found
    QScrollArea* m_scroll;
    std::vector<ParameterGroup*> m_groups;
};

} // namespace fumage::ui
