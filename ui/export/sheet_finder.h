#pragma once

#include "ui/export/sheet_search.h"

#include <QWidget>

#include <optional>

class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace fumage::ui {

/// Has columns, rows and the size of cells chosen for a budget of memory, by how well sheets play. Searches only while
/// it is seen.
class SheetFinder : public QWidget {
    Q_OBJECT

public:
    explicit SheetFinder(QWidget* parent = nullptr);

    /// What is to be written; where it becomes another while a sheet is searched for, that ends.
    void follow(const Scene& scene, const ExportPlan& plan);

signals:
    void chosen(const fumage::SheetCandidate& sheet);
    /// It takes more room, or less.
    void resized();

protected:
    void hideEvent(QHideEvent* event) override;

private:
    void build();
    void begin();
    void end(const QString& said);
    void take(const SheetCandidate& best);

    struct Wanted {
        Scene scene;
        ExportPlan plan;
    };
    std::optional<Wanted> m_wanted;
    std::optional<SheetCandidate> m_taken; ///< what was chosen last
    Output m_largest; ///< the size of cells before that
    bool m_isSearching = false;
    QDoubleSpinBox* m_budget;
    QPushButton* m_find;
    QLabel* m_state;
    SheetSearch m_search;
};

} // namespace fumage::ui
