#pragma once

#include "ui/document/document.h"

#include <QWidget>

#include <vector>

namespace fumage::ui {

class TimelineRuler;

/// When each visible layer gives birth, and how much: a strip a layer under the ruler and in line with it. A click
/// edits a layer. It takes no room where one layer emits all the time.
class EmissionStrip : public QWidget {
    Q_OBJECT

public:
    /// @param ruler that says where a frame lies
    EmissionStrip(Document& document, const TimelineRuler& ruler, QWidget* parent);

    /// Births in each frame of a layer, as a share of the most of them.
    struct Strip {
        std::size_t layer = 0;
        std::vector<float> shares;
    };
    [[nodiscard]] const std::vector<Strip>& strips() const { return m_strips; }

    QSize sizeHint() const override;

    static constexpr int kStripHeight = 6; ///< pixels
    static constexpr std::size_t kMaxStrips = 12; ///< of more layers the first are shown

signals:
    /// There are more strips, or fewer.
    void heightChanged();

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;

private:
    void sync();
    void takeRoom();
    [[nodiscard]] const Strip* stripAt(double y) const;

    Document& m_document;
    const TimelineRuler& m_ruler;
    std::vector<Strip> m_strips;
};

} // namespace fumage::ui
