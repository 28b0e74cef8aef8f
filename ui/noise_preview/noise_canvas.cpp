#include "ui/noise_preview/noise_canvas.h"

#include "ui/document/number_text.h"
#include "ui/widgets/gesture.h"
#include "ui/widgets/input_guard.h"

#include <algorithm>
#include <cmath>

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

namespace fumage::ui {

namespace {

constexpr double kFarthest = 1.0;
constexpr double kNearest = 16.0;
constexpr double kZoomOfNotch = 1.25;
constexpr int kTiles = 3;

} // namespace

NoiseCanvas::NoiseCanvas(QWidget* parent)
    : QWidget(parent)
{
    setObjectName(QStringLiteral("noiseCanvas"));
    setAccessibleName(tr("Noise texture"));
    InputGuard::leaveAllButtons(*this);
    setToolTip(tr(
        "Wheel: zoom. Left button: move the profile line. Middle button: move the picture. Double-click: whole tile."));
}

void NoiseCanvas::show(const NoisePicturePtr& picture)
{
    m_picture = picture;
    update();
}

void NoiseCanvas::setTiled(bool tiled)
{
    m_tiled = tiled;
    update();
}

void NoiseCanvas::setLineShown(bool shown)
{
    m_lineShown = shown;
    update();
}

double NoiseCanvas::tileEdge() const
{
    const double edge = std::min(width(), height());
    return m_zoom * (m_tiled ? edge / kTiles : edge);
}

QPointF NoiseCanvas::corner() const
{
    const double whole = tileEdge() * (m_tiled ? kTiles : 1);
    return QPointF((width() - whole) / 2.0, (height() - whole) / 2.0) + m_offset;
}

void NoiseCanvas::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), palette().base());
    if (!m_picture) {
        return;
    }
    // Near enough, single pixels are what one wants to see.
    const double edge = tileEdge();
    painter.setRenderHint(QPainter::SmoothPixmapTransform, edge < 8.0 * m_picture->image.width());
    const int tiles = m_tiled ? kTiles : 1;
    for (int y = 0; y < tiles; ++y) {
        for (int x = 0; x < tiles; ++x) {
            painter.drawImage(QRectF(corner() + QPointF(x * edge, y * edge), QSizeF(edge, edge)), m_picture->image);
        }
    }
    if (m_lineShown) {
        const double y = corner().y() + m_line * edge;
        painter.setPen(QPen(palette().highlight().color(), 1.5));
        painter.drawLine(QLineF(corner().x(), y, corner().x() + edge, y));
    }
}

void NoiseCanvas::mousePressEvent(QMouseEvent* event)
{
    if (m_button == Qt::NoButton && (event->button() == Qt::LeftButton || event->button() == Qt::MiddleButton)) {
        m_button = event->button();
        m_mouse = event->position();
        m_before = {m_line, m_offset};
        mouseMoveEvent(event);
    }
}

void NoiseCanvas::mouseMoveEvent(QMouseEvent* event)
{
    if (m_button == Qt::LeftButton) {
        const double place = (event->position().y() - corner().y()) / tileEdge();
        m_line = place - std::floor(place);
        emit lineMoved();
    } else if (m_button == Qt::MiddleButton) {
        m_offset += event->position() - m_mouse;
        m_mouse = event->position();
    }
    update();
}

void NoiseCanvas::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == m_button) {
        m_button = Qt::NoButton;
    }
}

bool NoiseCanvas::event(QEvent* event)
{
    if (event->type() == DragCancel::type() && m_button != Qt::NoButton) {
        m_line = m_before.line;
        m_offset = m_before.offset;
        emit lineMoved();
        update();
        event->accept();
        return true;
    }
    return QWidget::event(event);
}

void NoiseCanvas::wheelEvent(QWheelEvent* event)
{
    const double before = m_zoom;
    m_zoom = std::clamp(m_zoom * std::pow(kZoomOfNotch, wheelSteps(*event)), kFarthest, kNearest);
    // What lies under the mouse stays there.
    const QPointF middle(width() / 2.0, height() / 2.0);
    const QPointF way = event->position() - middle;
    m_offset = m_zoom == kFarthest ? QPointF() : way - (way - m_offset) * (m_zoom / before);
    update();
    event->accept();
}

void NoiseCanvas::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) {
        return;
    }
    m_zoom = kFarthest;
    m_offset = {};
    update();
}

NoisePlots::NoisePlots(QWidget* parent)
    : QWidget(parent)
{
    setObjectName(QStringLiteral("noisePlots"));
    setAccessibleName(tr("Profile and histogram of the noise"));
}

void NoisePlots::show(const NoisePicturePtr& picture, double line, double wavelength)
{
    m_picture = picture;
    m_line = line;
    m_wavelength = wavelength;
    update();
}

void NoisePlots::setProfileShown(bool shown)
{
    m_profileShown = shown;
    update();
}

void NoisePlots::paintProfile(QPainter& painter, const QRectF& area) const
{
    const NoiseTile& tile = m_picture->tile;
    const int row = std::clamp(tile.size - 1 - static_cast<int>(m_line * tile.size), 0, tile.size - 1);
    QPainterPath path;
    float low = 1.0F;
    float high = 0.0F;
    for (int x = 0; x < tile.size; ++x) {
        const float value = tile.at(x, row);
        low = std::min(low, value);
        high = std::max(high, value);
        const QPointF at(area.left() + area.width() * x / std::max(1, tile.size - 1),
            area.bottom() - area.height() * static_cast<double>(value));
        x == 0 ? path.moveTo(at) : path.lineTo(at);
    }
    painter.setPen(QPen(palette().highlight().color(), 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(path);

    const QColor mark = palette().link().color();
    painter.setPen(QPen(mark, 1.0, Qt::DashLine));
    const double top = area.bottom() - area.height() * static_cast<double>(high);
    const double bottom = area.bottom() - area.height() * static_cast<double>(low);
    painter.drawLine(QLineF(area.left(), top, area.right(), top));
    painter.drawLine(QLineF(area.left(), bottom, area.right(), bottom));
    const double across = area.width() * std::min(1.0, m_wavelength);
    painter.setPen(QPen(mark, 1.5));
    painter.drawLine(QLineF(area.left() + 1.0, area.bottom() - 2.0, area.left() + across, area.bottom() - 2.0));
    painter.setPen(palette().text().color());
    painter.drawText(area.adjusted(4.0, 2.0, -4.0, -4.0), Qt::AlignTop | Qt::AlignRight,
        tr("amplitude %1").arg(formatFixed(static_cast<double>(high - low), 2)));
    painter.drawText(area.adjusted(4.0, 2.0, -4.0, -4.0), Qt::AlignBottom | Qt::AlignLeft,
        tr("λ %1").arg(formatNumber(std::round(m_wavelength * 1000.0) / 1000.0)));
}

void NoisePlots::paintHistogram(QPainter& painter, const QRectF& area) const
{
    const auto& bins = m_picture->histogram;
    const int most = std::max(1, *std::max_element(bins.begin(), bins.end()));
    const double width = area.width() / static_cast<double>(bins.size());
    QColor bar = palette().text().color();
    bar.setAlpha(150);
    for (std::size_t i = 0; i < bins.size(); ++i) {
        const double height = area.height() * bins[i] / most;
        painter.fillRect(QRectF(area.left() + width * static_cast<double>(i), area.bottom() - height,
                             std::max(1.0, width - 0.5), height),
            bar);
    }
}

void NoisePlots::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    constexpr double kGap = 8.0;
    const double histogramWidth = m_profileShown ? width() * 0.34 : width();
    const QRectF right(width() - histogramWidth, 0.0, histogramWidth, height());
    const QRectF left(0.0, 0.0, width() - histogramWidth - kGap, height());
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().base());
    painter.drawRoundedRect(right, 4.0, 4.0);
    if (m_profileShown) {
        painter.drawRoundedRect(left, 4.0, 4.0);
    }
    if (!m_picture) {
        return;
    }
    if (m_profileShown) {
        paintProfile(painter, left.adjusted(3.0, 3.0, -3.0, -3.0));
    }
    paintHistogram(painter, right.adjusted(3.0, 3.0, -3.0, 0.0));
}

} // namespace fumage::ui
