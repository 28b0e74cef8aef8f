#include "ui/timeline/timeline_ruler.h"

#include "ui/widgets/field_keys.h"
#include "ui/widgets/gesture.h"

#include <algorithm>
#include <cmath>

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

namespace fumage::ui {

namespace {

constexpr double kMargin = 12.0;
constexpr double kGripReach = 7.0;
constexpr double kRangeTop = 2.0; ///< of the strip that holds the range
constexpr double kRangeHeight = 8.0;
constexpr double kMinTickGap = 52.0;
constexpr int kMaxStep = 100'000'000; ///< of ticks, where a ruler has no width

} // namespace

TimelineRuler::TimelineRuler(Player& player, QWidget* parent)
    : QWidget(parent)
    , m_player(player)
{
    setObjectName(QStringLiteral("timelineRuler"));
    setAccessibleName(tr("Timeline"));
    setToolTip(tr("Drag to go to any frame; drag the ends of the bar to play a part"));
    setFixedHeight(sizeHint().height());
    connect(&player, &Player::frameChanged, this, qOverload<>(&QWidget::update));
    connect(&player, &Player::settingsChanged, this, qOverload<>(&QWidget::update));
}

void TimelineRuler::setCached(const QList<int>& frames)
{
    m_cached = frames;
    update();
}

void TimelineRuler::setBaking(double share)
{
    if (share != m_baking) {
        m_baking = share;
        update();
    }
}

double TimelineRuler::xOf(double frame) const
{
    return kMargin + (width() - 2.0 * kMargin) * frame / std::max(1, m_player.length() - 1);
}

int TimelineRuler::tickStep() const
{
    for (int power = 1;; power *= 10) {
        for (const int factor : {1, 2, 5}) {
            if (power * factor * (xOf(1.0) - xOf(0.0)) >= kMinTickGap || power >= kMaxStep) {
                return power * factor;
            }
        }
    }
}

int TimelineRuler::frameAt(double x) const
{
    return static_cast<int>(
        std::lround((x - kMargin) / (width() - 2.0 * kMargin) * std::max(1, m_player.length() - 1)));
}

void TimelineRuler::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || m_grip != Grip::None) {
        return;
    }
    leaveField(*this); // keys are shortcuts again
    const QPointF at = event->position();
    m_grip = Grip::Cursor;
    m_before = {m_player.frame(), m_player.first(), m_player.last()};
    if (at.y() <= kRangeTop + kRangeHeight + 2.0) {
        if (std::abs(at.x() - xOf(m_player.first())) < kGripReach) {
            m_grip = Grip::First;
        } else if (std::abs(at.x() - xOf(m_player.last())) < kGripReach) {
            m_grip = Grip::Last;
        }
    }
    m_wasPlaying = m_player.isPlaying() && m_grip == Grip::Cursor;
    if (m_wasPlaying) {
        m_player.pause();
    }
    mouseMoveEvent(event);
}

void TimelineRuler::mouseMoveEvent(QMouseEvent* event)
{
    const int frame = frameAt(event->position().x());
    switch (m_grip) {
    case Grip::None: break;
    case Grip::Cursor: m_player.setFrame(frame); break;
    case Grip::First: m_player.setRange(std::min(frame, m_player.last()), m_player.last()); break;
    case Grip::Last: m_player.setRange(m_player.first(), std::max(frame, m_player.first())); break;
    }
}

bool TimelineRuler::event(QEvent* event)
{
    if (event->type() == DragCancel::type() && m_grip != Grip::None) {
        m_player.setRange(m_before.first, m_before.last);
        m_player.setFrame(m_before.frame);
        event->accept();
        return true;
    }
    return QWidget::event(event);
}

void TimelineRuler::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) {
        return;
    }
    m_grip = Grip::None;
    if (m_wasPlaying) {
        m_wasPlaying = false;
        m_player.play();
    }
}

void TimelineRuler::paintTicks(QPainter& painter) const
{
    const int step = tickStep();
    QColor colour = palette().text().color();
    colour.setAlpha(150);
    painter.setPen(colour);
    for (int frame = 0; frame < m_player.length(); frame += step) {
        const double x = xOf(frame);
        painter.drawLine(QLineF(x, 14.0, x, 20.0));
        painter.drawText(QRectF(x - 30.0, 20.0, 60.0, 16.0), Qt::AlignHCenter | Qt::AlignTop, QString::number(frame));
    }
}

void TimelineRuler::paintBaking(QPainter& painter) const
{
    const QColor warm(0xe0, 0x90, 0x40);
    painter.fillRect(QRectF(kMargin, height() - 3.0, (width() - 2.0 * kMargin) * m_baking, 3.0), warm);
    const QString text = tr("air %1 %").arg(static_cast<int>(100.0 * m_baking));
    const double wide = painter.fontMetrics().horizontalAdvance(text) + 8.0;
    const QRectF place(width() - kMargin - wide, 18.0, wide, 18.0);
    painter.fillRect(place, palette().base());
    painter.setPen(warm);
    painter.drawText(place, Qt::AlignCenter, text);
}

void TimelineRuler::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().base());
    QColor range = palette().highlight().color();
    range.setAlpha(110);
    painter.setPen(Qt::NoPen);
    painter.setBrush(range);
    painter.drawRoundedRect(QRectF(QPointF(xOf(m_player.first()) - 4.0, kRangeTop),
                                QPointF(xOf(m_player.last()) + 4.0, kRangeTop + kRangeHeight)),
        3.0, 3.0);
    const double half = std::max(0.5, (xOf(1) - xOf(0)) / 2.0);
    for (const int frame : m_cached) {
        painter.fillRect(
            QRectF(xOf(frame) - half, kRangeTop + kRangeHeight + 1.0, 2.0 * half + 0.5, 2.5), QColor(86, 170, 110));
    }
    paintTicks(painter);
    if (m_baking < 1.0) {
        paintBaking(painter);
    }
    const double x = xOf(m_player.frame());
    painter.setPen(QPen(palette().highlight().color(), 2.0));
    painter.drawLine(QLineF(x, 0.0, x, height()));
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().highlight());
    painter.drawPolygon(QPolygonF{{x - 6.0, 0.0}, {x + 6.0, 0.0}, {x, 9.0}});
}

} // namespace fumage::ui
