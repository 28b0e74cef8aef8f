#pragma once

#include <QScrollArea>

namespace fumage::ui {

/// Lets contents be lower than they are, as on a small screen, but not narrower: nothing of them is cut off at the
/// side, where they cannot be scrolled.
class VerticalScrollArea : public QScrollArea {
    Q_OBJECT

public:
    explicit VerticalScrollArea(QWidget* parent = nullptr);

    [[nodiscard]] QSize minimumSizeHint() const override;
    [[nodiscard]] QSize sizeHint() const override;
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace fumage::ui
