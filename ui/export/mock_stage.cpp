#include "ui/export/mock_stage.h"

#include <QLinearGradient>
#include <QPainter>
#include <QRadialGradient>

#include <algorithm>
#include <array>

namespace fumage::ui {

namespace {

constexpr int kTick = 33; ///< ms between two pictures
constexpr QSize kUsual(400, 320); ///< px
constexpr double kHorizon = 0.58; ///< share of the height
constexpr double kFoot = 0.86; ///< where the smoke stands, share of the height
constexpr double kTall = 0.82; ///< of the smoke, share of the height

/// The colours of a time of day.
struct SkyColours {
    QRgb top;
    QRgb horizon;
    QRgb ground; ///< in front; towards the horizon it goes over into the sky's
    QRgb line;
};
constexpr std::array<SkyColours, 3> kSkies{{
    {0xff4f86bd, 0xffc7dbe8, 0xff66704f, 0xff59624a},
    {0xff2c3358, 0xffd9926a, 0xff3a3733, 0xff47423c},
    {0xff05070d, 0xff17202e, 0xff14161a, 0xff20252c},
}};

} // namespace

MockStage::MockStage(QWidget* parent)
    : QWidget(parent)
{
    setMinimumSize(kUsual);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("The sheet as it plays in an engine"));
    m_tick.setInterval(kTick);
    connect(&m_tick, &QTimer::timeout, this, &MockStage::step);
}

QSize MockStage::sizeHint() const
{
    return kUsual;
}

void MockStage::setSky(Sky sky)
{
    m_sky = sky;
    update();
}

void MockStage::play(std::shared_ptr<const SheetPreview> sheet)
{
    m_sheet = std::move(sheet);
    m_shown = {};
    m_text.clear();
    wake();
    update();
}

void MockStage::say(const QString& text)
{
    play(nullptr);
    m_text = text;
}

void MockStage::wake()
{
    if (m_sheet == nullptr || !isVisible()) {
        m_tick.stop();
        return;
    }
    m_clock.start();
    m_tick.start();
    step();
}

void MockStage::step()
{
    constexpr double kMillisecondsASecond = 1000.0;
    const CellBlending blending = m_sheet->playback->hasMotion() ? CellBlending::Motion : CellBlending::CrossFade;
    m_shown = m_frame.at(*m_sheet, static_cast<double>(m_clock.elapsed()) / kMillisecondsASecond, blending);
    update();
}

void MockStage::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    wake();
}

void MockStage::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    m_tick.stop();
}

void MockStage::paintGround(QPainter& painter, int horizon) const
{
    const SkyColours& colours = kSkies[static_cast<std::size_t>(m_sky)];
    QLinearGradient sky(0, 0, 0, horizon);
    sky.setColorAt(0.0, QColor::fromRgb(colours.top));
    sky.setColorAt(1.0, QColor::fromRgb(colours.horizon));
    painter.fillRect(QRect(0, 0, width(), horizon), sky);
    QLinearGradient ground(0, horizon, 0, height());
    ground.setColorAt(0.0, QColor::fromRgb(colours.horizon));
    constexpr double kHaze = 0.25; // share of the ground that the air hides
    ground.setColorAt(kHaze, QColor::fromRgb(colours.ground));
    ground.setColorAt(1.0, QColor::fromRgb(colours.ground));
    painter.fillRect(QRect(0, horizon, width(), height() - horizon), ground);

    paintGrid(painter, horizon, QColor::fromRgb(colours.line));
}

/// Lines at equal distances on the ground, which the haze hides before they lie too close.
void MockStage::paintGrid(QPainter& painter, int horizon, const QColor& colour) const
{
    constexpr double kHidden = 0.06; // share of the ground
    constexpr double kClear = 0.4;
    QColor hidden = colour;
    hidden.setAlpha(0);
    QLinearGradient haze(0, horizon, 0, height());
    haze.setColorAt(kHidden, hidden);
    haze.setColorAt(kClear, colour);
    painter.setPen(QPen(QBrush(haze), 1.0));
    constexpr int kAcross = 60; // to each side
    constexpr int kDeep = 16;
    const double middle = width() / 2.0;
    const double apart = width() / 4.0; // in front
    for (int i = -kAcross; i <= kAcross; ++i) {
        painter.drawLine(QPointF(middle, horizon), QPointF(middle + i * apart, height()));
    }
    for (int i = 1; i <= kDeep; ++i) { // their heights go as 1 / distance
        const double y = horizon + (height() - horizon) / static_cast<double>(i);
        painter.drawLine(QPointF(0, y), QPointF(width(), y));
    }
}

void MockStage::paintSmoke(QPainter& painter, int horizon) const
{
    const double tall = kTall * height();
    const QSizeF size = QSizeF(m_shown.size()).scaled(0.9 * width(), tall, Qt::KeepAspectRatio);
    const double foot = std::max(kFoot * height(), static_cast<double>(horizon));
    const QPointF at(width() / 2.0, foot);
    QRadialGradient shadow(QPointF(0, 0), size.width() / 3.0);
    constexpr int kDark = 90;
    shadow.setColorAt(0.0, QColor(0, 0, 0, kDark));
    shadow.setColorAt(1.0, QColor(0, 0, 0, 0));
    constexpr double kFlat = 0.22; // how a circle on the ground is seen
    painter.save();
    painter.translate(at);
    painter.scale(1.0, kFlat);
    painter.setPen(Qt::NoPen);
    painter.setBrush(shadow);
    painter.drawEllipse(QPointF(0, 0), size.width() / 3.0, size.width() / 3.0);
    painter.restore();
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(QRectF(at - QPointF(size.width() / 2.0, size.height()), size), m_shown);
}

void MockStage::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const int horizon = static_cast<int>(kHorizon * height());
    paintGround(painter, horizon);
    if (!m_shown.isNull()) {
        paintSmoke(painter, horizon);
        return;
    }
    painter.setPen(Qt::white);
    constexpr int kMargin = 24;
    painter.drawText(rect().adjusted(kMargin, kMargin, -kMargin, -kMargin),
        static_cast<int>(Qt::AlignCenter) | static_cast<int>(Qt::TextWordWrap), m_text);
}

} // namespace fumage::ui
