#pragma once

#include "core/export/sheets/sheet_optimizer.h"

#include <QWidget>

#include <vector>

class QCheckBox;
class QPushButton;
class QToolButton;
class QVBoxLayout;

namespace fumage::ui {

class CurveArea;
class PackRow;
class SheetFinder;

/// What few flipbooks are asked, folded away: which frames they show, sides of powers of two, a budget of memory, and
/// packed pictures.
class FlipbookExtras : public QWidget {
    Q_OBJECT

public:
    explicit FlipbookExtras(QWidget* parent = nullptr);

    /// A loop has no frames to leave out.
    void follow(const Scene& scene);
    /// What is to be written, applyTo() included: a search for a sheet begins with it.
    void followPlan(const Scene& scene, const ExportPlan& plan);
    /// Writes them into a plan, whether they are folded away or not.
    void applyTo(ExportPlan& plan) const;
    /// Shows what a plan that is remembered says.
    void take(const ExportPlan& plan);

signals:
    void changed();
    /// Found for a budget of memory.
    void sheetChosen(const fumage::SheetCandidate& sheet);
    /// It takes more room, or less.
    void resized();

private:
    void build();
    [[nodiscard]] QVBoxLayout* makePacks();
    void setOpen(bool open);
    PackRow* addPack();
    void removePack(PackRow* row);

    QToolButton* m_more;
    QWidget* m_content;
    QCheckBox* m_trim;
    QCheckBox* m_powerOfTwo;
    QCheckBox* m_retimes;
    CurveArea* m_curve;
    SheetFinder* m_finder;
    QVBoxLayout* m_list = nullptr; ///< of packed pictures
    QPushButton* m_add;
    std::vector<PackRow*> m_packs;
    int m_packsEver = 0; ///< so that no two begin with one name
};

} // namespace fumage::ui
