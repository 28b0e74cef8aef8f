#include "ui/export/preview_canvas.h"

#include <QPainter>

namespace fumage::ui {

namespace {

constexpr int kEdge = 256; ///< px
constexpr int kSquare = 8; ///< px, of the checkerboard
constexpr QRgb kDark = 0xff1d2126;
constexpr QRgb kLight = 0xffe6e6e4;
constexpr QRgb kCheckerDark = 0xff5a5a5a;
constexpr QRgb kCheckerLight = 0xff7d7d7d;

} // namespace

PreviewCanvas::PreviewCanvas(QWidget* parent)
    : QWidget(parent)
{
    setMinimumSize(kEdge, kEdge);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setAccessibleName(tr("Preview of the flipbook"));
}

QSize PreviewCanvas::sizeHint() const
{
    return {kEdge, kEdge};
}

void PreviewCanvas::setBackdrop(Backdrop backdrop)
{
    m_backdrop = backdrop;
    update();
}

void PreviewCanvas::setImage(const QImage& image)
{
    m_image = image;
    m_text.clear();
    update();
}

void PreviewCanvas::say(const QString& text)
{
    m_image = {};
    m_text = text;
    update();
}

void PreviewCanvas::paintBackdrop(QPainter& painter, const QRect& area) const
{
    switch (m_backdrop) {
    case Backdrop::Dark: painter.fillRect(area, QColor::fromRgb(kDark)); return;
    case Backdrop::Light: painter.fillRect(area, QColor::fromRgb(kLight)); return;
    case Backdrop::Checker: break;
    }
    for (int y = 0; y < area.height(); y += kSquare) {
        for (int x = 0; x < area.width(); x += kSquare) {
            const bool isDark = (x / kSquare + y / kSquare) % 2 == 0;
            const QRect square = QRect(area.left() + x, area.top() + y, kSquare, kSquare) & area;
            painter.fillRect(square, QColor::fromRgb(isDark ? kCheckerDark : kCheckerLight));
        }
    }
}

void PreviewCanvas::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    QRect area = rect();
    if (!m_image.isNull()) {
        const QSize shown = m_image.size().scaled(size(), Qt::KeepAspectRatio);
        area = QRect({(width() - shown.width()) / 2, (height() - shown.height()) / 2}, shown);
    }
    paintBackdrop(painter, area);
    if (!m_image.isNull()) {
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(area, m_image);
        return;
    }
    painter.setPen(m_backdrop == Backdrop::Light ? Qt::black : Qt::white);
    constexpr int kMargin = 12;
    painter.drawText(area.adjusted(kMargin, kMargin, -kMargin, -kMargin),
        static_cast<int>(Qt::AlignCenter) | static_cast<int>(Qt::TextWordWrap), m_text);
}

} // namespace fumage::ui
