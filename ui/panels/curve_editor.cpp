#include "ui/panels/curve_editor.h"

#include <algorithm>
#include <cmath>

#include <QLineF>
#include <QPainter>
#include <QPainterPath>
#include <QVBoxLayout>

namespace fumage::ui {

namespace {

constexpr double kMargin = 7.0;
constexpr double kReach = 9.0;
constexpr float kMinGap = 0.005F; ///< between the x of neighbours

} // namespace

CurveArea::CurveArea(QWidget* parent)
    : PointStrip(parent)
{
    setFixedHeight(sizeHint().height());
}

void CurveArea::setCurve(const Curve& curve)
{
    if (isFree()) {
        m_curve = curve;
        pointsReplaced();
    }
}

QRectF CurveArea::area() const
{
    return QRectF(rect()).adjusted(kMargin, kMargin, -kMargin, -kMargin);
}

QPointF CurveArea::toScreen(const CurvePoint& point) const
{
    const QRectF inside = area();
    return {inside.left() + static_cast<double>(point.x) * inside.width(),
        inside.bottom() - static_cast<double>(point.y) * inside.height()};
}

CurvePoint CurveArea::fromScreen(const QPointF& at) const
{
    const QRectF inside = area();
    const auto share = [](double value) { return static_cast<float>(std::clamp(value, 0.0, 1.0)); };
    return {share((at.x() - inside.left()) / inside.width()), share((inside.bottom() - at.y()) / inside.height())};
}

int CurveArea::pointAt(const QPointF& mouse) const
{
    for (int i = 0; i < m_curve.count; ++i) {
        if (QLineF(mouse, toScreen(m_curve.storage[static_cast<std::size_t>(i)])).length() < kReach) {
            return i;
        }
    }
    return -1;
}

int CurveArea::insert(const CurvePoint& point)
{
    const int index = insertPoint(m_curve, point);
    if (index >= 0) {
        place(index, point);
    }
    return index;
}

int CurveArea::insertAfter(int index)
{
    const CurvePoint& before = m_curve.storage[static_cast<std::size_t>(index)];
    return insert({std::min(1.0F, before.x + kBeside), before.y});
}

bool CurveArea::step(int index, int right, int up)
{
    const CurvePoint& from = m_curve.storage[static_cast<std::size_t>(index)];
    place(index, {from.x + static_cast<float>(right) * kStep, from.y + static_cast<float>(up) * kStep});
    return true;
}

void CurveArea::place(int index, CurvePoint to)
{
    const auto at = [&](int i) -> CurvePoint& { return m_curve.storage[static_cast<std::size_t>(i)]; };
    const float low = index > 0 ? at(index - 1).x + kMinGap : 0.0F;
    const float high = index + 1 < m_curve.count ? at(index + 1).x - kMinGap : 1.0F;
    to.x = std::round(std::clamp(to.x, std::min(low, high), high) * 1000.0F) / 1000.0F;
    to.y = std::round(std::clamp(to.y, 0.0F, 1.0F) * 1000.0F) / 1000.0F;
    at(index) = to;
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
        const bool selected = isMarked(i);
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
    layout->setSpacing(0);
    layout->addWidget(m_area);
    layout->addWidget(makeHint(tr("Click to add, drag to move, Delete or right click to remove")));
    setFocusProxy(m_area);
    connect(m_area, &CurveArea::changed, this, [this](bool finished) { emit edited(m_area->curve(), finished); });
}

void CurveEditor::setValue(const Value& value)
{
    m_area->setCurve(std::get<Curve>(value));
}

} // namespace fumage::ui
