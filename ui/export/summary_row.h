#pragma once

#include "ui/export/export_summary.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace fumage::ui {

/// Says what a plan writes, or what stands in its way, with buttons for the ways out where there are any.
class SummaryRow : public QWidget {
    Q_OBJECT

public:
    /// @param document whose key frames may be mended
    SummaryRow(Document& document, QWidget* parent);

    /// @param solo whether the viewport shows some of the layers alone
    void follow(const ExportPlan& plan, const Scene& scene, bool solo);

signals:
    /// The way out is taken.
    void taken(const fumage::ui::ExportOffer& offer);

private:
    QLabel* m_files;
    QLabel* m_solo; ///< says what is exported while the viewport shows less
    QPushButton* m_offer;
    QPushButton* m_mendKeys;
    std::optional<ExportOffer> m_offered;
};

} // namespace fumage::ui
