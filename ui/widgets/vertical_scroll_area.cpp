#include "ui/widgets/vertical_scroll_area.h"

#include <QEvent>
#include <QScrollBar>

namespace fumage::ui {

VerticalScrollArea::VerticalScrollArea(QWidget* parent)
    : QScrollArea(parent)
{
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::NoFocus);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
}

QSize VerticalScrollArea::minimumSizeHint() const
{
    constexpr int kMinHeight = 120;
    const int width = widget() == nullptr ? 0 : widget()->minimumSizeHint().width();
    return {width + verticalScrollBar()->sizeHint().width(), kMinHeight};
}

QSize VerticalScrollArea::sizeHint() const
{
    return widget() == nullptr ? minimumSizeHint() : widget()->sizeHint().expandedTo(minimumSizeHint());
}

bool VerticalScrollArea::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == widget() && event->type() == QEvent::LayoutRequest) {
        updateGeometry(); // a group that opens may be wider
    }
    return QScrollArea::eventFilter(watched, event);
}

} // namespace fumage::ui
