#pragma once

#include "ui/panels/parameter_row.h"

#include <QWidget>

#include <optional>
#include <vector>

class QToolButton;
class QVBoxLayout;

namespace fumage::ui {

/// The group that shows rows of others once more.
inline const QString kEssentialsName = QStringLiteral("essentials");

/// Which rows are wanted, of all that there are.
struct RowFilter {
    bool changed = false; ///< those that differ from the preset
    bool animated = false; ///< those that have key frames
    [[nodiscard]] bool any() const { return changed || animated; }
};

/// A group of parameters under a heading that folds it.
class ParameterGroup : public QWidget {
    Q_OBJECT

public:
    /// @param name objectName without its "group."
    ParameterGroup(const QString& name, const QString& label, std::vector<ParameterRow*> rows, Document& document,
        QWidget* parent);

    [[nodiscard]] bool isOpen() const;
    void setOpen(bool open);
    void sync();
    /// The rows of some parameters.
    void sync(const std::vector<const Parameter*>& changed);
    [[nodiscard]] QString name() const { return objectName().mid(QStringLiteral("group.").size()); }
    [[nodiscard]] std::size_t size() const { return m_rows.size(); }
    /// Whether a row of it is stored in one of these groups.
    [[nodiscard]] bool holdsAnyOf(const QStringList& stored) const;
    /// Shows the rows that are found and of use as the effect stands, the best first.
    /// @param scores of the rows, see SearchIndex; empty: nothing is searched for
    /// @return the best of those that are wanted; 0: none is
    double filter(const std::vector<double>& scores, RowFilter only);

    /// Whether a row of it belongs to the layer that is edited, or to what all layers share.
    [[nodiscard]] bool has(Scope scope) const;
    /// Shows the rows of one scope alone; none: all of them.
    void setScope(std::optional<Scope> scope) { m_scope = scope; }
    /// Says behind the heading whose parameters these are; empty: nobody asks.
    void setOwner(const QString& owner);

    /// All values as lines of "key=value", on the clipboard.
    void copy() const;
    /// Takes over those lines of the clipboard that are of this group, in one step; without one nothing happens.
    void paste();
    /// Puts all back to what the preset says, in one step.
    void reset();

signals:
    /// Of all groups.
    void foldRequested(bool open);

protected:
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    void showRows();
    void showMark();
    /// Whether a row has a place in the panel as the effect stands.
    [[nodiscard]] bool isOfUse(std::size_t row) const;
    [[nodiscard]] bool isWanted(std::size_t row) const;
    [[nodiscard]] std::vector<Assignment> pasted() const;

    Document& m_document;
    QToolButton* m_heading;
    QWidget* m_content;
    QVBoxLayout* m_list = nullptr;
    std::vector<ParameterRow*> m_rows; ///< in their usual order
    std::vector<double> m_scores; ///< of the rows
    bool m_isSearched = false;
    QString m_label;
    RowFilter m_only;
    std::optional<Scope> m_scope;
    QString m_owner;
};

} // namespace fumage::ui
