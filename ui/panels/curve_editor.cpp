#include "ui/panels/curve_editor.h"

#include <algorithm>
#include <cmath>

#include <QKeyEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QVBoxLayout>

namespace fumage::ui {

namespace {

constexpr double kMargin = 7.0;
constexpr double kReach = 9.0;
constexpr float kStep = 0.01F;
constexpr float kLeastGap = 0.005F; ///< between the x of neighbours

} // namespace

CurveArea::CurveArea(QWidget* parent)
    : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setFixedHeight(sizeHint().height());
}

void CurveArea::setCurve(const Curve& curve)
{
    if (!m_dragging) {
        m_curve = curve;
        m_selected = std::clamp(m_selected, 0, curve.count - 1);
        update();
    }
}

QRectF CurveArea::area() const
{
    return QRectF(rect()).adjusted(kMargin, kMargin, -kMargin, -kMargin);
}

QPointF CurveArea::toScreen(const CurvePoint& point) const
{
    const QRectF inside = area();
    return {inside.left() + static_cast<double>(point.x) * inside.width(), inside.bottom() - static_cast<double>(point.y) * inside.height()};
}

CurvePoint CurveArea::fromScreen(const QPointF& at) const
{
    const QRectF inside = area();
    const auto share = [](double value) { return static_cast<float>(std::clamp(value, 0.0, 1.0)); };
    return {share((at.x() - inside.left()) / inside.width()), share((inside.bottom() - at.y()) / inside.height())};
}

int CurveArea::pointAt(const QPointF& at) const
{
    for (int i = 0; i < m_curve.count; ++i) {
        if (QLineF(at, toScreen(m_curve.storage[static_cast<std::size_t>(i)])).length() < kReach) {
            return i;
        }
    }
    return -1;
}

void CurveArea::insert(const CurvePoint& point)
{
    if (m_curve.count == kMaxControlPoints) {
        return;
    }
    const auto begin = m_curve.storage.begin();
    const auto end = begin + m_curve.count;
    const auto at = std::upper_bound(begin, end, point, [](const CurvePoint& a, const CurvePoint& b) { return a.x < b.x; });
    m_selected = static_cast<int>(at - begin);
    std::copy_backward(at, end, end + 1);
    *at = point;
    ++m_curve.count;
    movePoint(m_selected, point);
}

void CurveArea::remove(int index)
{
    if (m_curve.count < 2 || index < 0) {
        return;
    }
    const auto at = m_curve.storage.begin() + index;
    std::copy(at + 1, m_curve.storage.begin() + m_curve.count, at);
    --m_curve.count;
    m_curve.storage[static_cast<std::size_t>(m_curve.count)] = {};
    m_selected = std::clamp(index, 0, m_curve.count - 1);
    update();
    emit edited(m_curve, true);
}

void CurveArea::movePoint(int index, CurvePoint to)
{
    const auto at = [&](int i) -> CurvePoint& { return m_curve.storage[static_cast<std::size_t>(i)]; };
    const float low = index > 0 ? at(index - 1).x + kLeastGap : 0.0F;
    const float high = index + 1 < m_curve.count ? at(index + 1).x - kLeastGap : 1.0F;
    to.x = std::round(std::clamp(to.x, std::min(low, high), high) * 1000.0F) / 1000.0F;
    to.y = std::round(std::clamp(to.y, 0.0F, 1.0F) * 1000.0F) / 1000.0F;
    at(index) = to;
    update();
    emit edited(m_curve, false);
}

void CurveArea::mousePressEvent(QMouseEvent* event)
{
    const int index = pointAt(event->position());
    if (event->button() == Qt::RightButton) {
        remove(index);
        return;
    }
    m_dragging = true;
    if (index < 0) {
        insert(fromScreen(event->position()));
    } else {
        m_selected = index;
        update();
    }
}

void CurveArea::mouseMoveEvent(QMouseEvent* event)
{
    if (m_dragging) {
        movePoint(m_selected, fromScreen(event->position()));
    }
}

void CurveArea::mouseReleaseEvent(QMouseEvent*)
{
    if (m_dragging) {
        m_dragging = false;
        emit edited(m_curve, true);
    }
}

void CurveArea::keyPressEvent(QKeyEvent* event)
{
    CurvePoint point = m_curve.storage[static_cast<std::size_t>(m_selected)];
    switch (event->key()) {
    case Qt::Key_Delete:
    case Qt::Key_Backspace: remove(m_selected); return;
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
        m_selected = std::clamp(m_selected + (event->key() == Qt::Key_PageDown ? 1 : -1), 0, m_curve.count - 1);
        update();
        return;
    case Qt::Key_Insert: insert({std::min(1.0F, point.x + 0.1F), point.y}); break;
    case Qt::Key_Left: movePoint(m_selected, {point.x - kStep, point.y}); break;
    case Qt::Key_Right: movePoint(m_selected, {point.x + kStep, point.y}); break;
    case Qt::Key_Up: movePoint(m_selected, {point.x, point.y + kStep}); break;
    case Qt::Key_Down: movePoint(m_selected, {point.x, point.y - kStep}); break;
    default: QWidget::keyPressEvent(event); return;
    }
    emit edited(m_curve, true);
}

void CurveArea::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF inside = area();
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().base());
    painter.drawRoundedRect(rect(), 4.0, 4.0);
    QColor line = palette().mid().color();
    painter.setPen(QPen(line, 1.0));
    for (int i = 0; i <= 4; ++i) {
        const double x = inside.left() + inside.width() * i / 4.0;
        const double y = inside.top() + inside.height() * i / 4.0;
        painter.drawLine(QLineF(x, inside.top(), x, inside.bottom()));
        painter.drawLine(QLineF(inside.left(), y, inside.right(), y));
    }
    QPainterPath path;
    const int steps = static_cast<int>(inside.width());
    for (int i = 0; i <= steps; ++i) {
        const float x = static_cast<float>(i) / static_cast<float>(std::max(1, steps));
        const QPointF at = toScreen({x, m_curve.at(x)});
        i == 0 ? path.moveTo(at) : path.lineTo(at);
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(palette().highlight().color(), 2.0));
    painter.drawPath(path);
    for (int i = 0; i < m_curve.count; ++i) {
        const bool selected = i == m_selected && hasFocus();
        painter.setPen(QPen(palette().text().color(), selected ? 2.0 : 1.2));
        painter.setBrush(selected ? palette().highlight() : palette().base());
        painter.drawEllipse(toScreen(m_curve.storage[static_cast<std::size_t>(i)]), 4.0, 4.0);
    }
}

CurveEditor::CurveEditor(const Parameter& parameter, QWidget* parent)
    : ParameterEditor(parameter, parent)
    , m_area(new CurveArea(this))
{
    name(*m_area, QStringLiteral("area"), {});
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_area);
    setFocusProxy(m_area);
    connect(m_area, &CurveArea::edited, this, [this](const Curve& curve, bool finished) { emit edited(curve, finished); });
}

void CurveEditor::setValue(const Value& value)
{
    m_area->setCurve(std::get<Curve>(value));
}

} // namespace fumage::ui
