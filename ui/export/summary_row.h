#pragma once

#include "ui/export/export_summary.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace fumage::ui {

/// Says what a plan writes, or what stands in its way, with a button for the way out where there is one.
class SummaryRow : public QWidget {
    Q_OBJECT

public:
    explicit SummaryRow(QWidget* parent);

    void follow(const ExportPlan& plan, const Scene& scene);

signals:
    /// The way out is taken.
    void taken(const fumage::ui::ExportOffer& offer);

private:
    QLabel* m_files;
    QPushButton* m_offer;
    std::optional<ExportOffer> m_offered;
};

} // namespace fumage::ui
