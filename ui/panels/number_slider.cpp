#include "ui/panels/number_slider.h"

#include <algorithm>
#include <cmath>

#include <QMouseEvent>
#include <QSignalBlocker>
#include <QStyle>
#include <QStyleOptionSlider>

namespace fumage::ui {

namespace {

constexpr int kPositions = 1000;

/// One step of a key or a notch: a single one of a short whole range, else a hundredth.
int positionsAStep(const NumberScale& scale)
{
    const double steps = (scale.soft.high - scale.soft.low) / scale.step;
    constexpr double kFewSteps = 100.0;
    return scale.logarithmic || steps > kFewSteps ? kPositions / 100
                                                  : std::max(1, static_cast<int>(std::lround(kPositions / steps)));
}

} // namespace

NumberSlider::NumberSlider(const NumberScale& scale, QWidget* parent)
    : QSlider(Qt::Horizontal, parent)
    , m_scale(scale)
{
    setRange(0, kPositions);
    setSingleStep(positionsAStep(scale));
    setPageStep(singleStep() * 10);
    setFocusPolicy(Qt::StrongFocus);
    connect(&m_burst, &GestureTimer::ended, this, [this] { emit edited(m_number, true); });
    connect(this, &QSlider::valueChanged, this, &NumberSlider::follow);
    connect(this, &QSlider::sliderReleased, this, [this] { emit edited(m_number, true); });
}

void NumberSlider::setNumber(double number)
{
    m_number = number;
    // The hand leads while it holds the slider.
    if (!isSliderDown()) {
        const QSignalBlocker blocker(this);
        setValue(static_cast<int>(std::lround(m_scale.position(number) * kPositions)));
        update();
    }
}

void NumberSlider::follow(int position)
{
    m_number = m_scale.valueAt(static_cast<double>(position) / kPositions);
    if (!isSliderDown() && !m_jumping) {
        m_burst.start();
    }
    emit edited(m_number, false);
}

void NumberSlider::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) {
        return;
    }
    m_burst.end();
    QStyleOptionSlider option;
    initStyleOption(&option);
    const QRect handle = style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this);
    if (!handle.contains(event->position().toPoint())) {
        const int way = static_cast<int>(event->position().x()) - handle.width() / 2;
        // The handle is now under the mouse, and the base class takes it: one gesture until the release.
        m_jumping = true;
        setSliderPosition(QStyle::sliderValueFromPosition(minimum(), maximum(), way, width() - handle.width()));
        m_jumping = false;
    }
    QSlider::mousePressEvent(event);
}

void NumberSlider::wheelEvent(QWheelEvent* event)
{
    if (!hasFocus() || event->angleDelta().y() == 0) {
        event->ignore();
        return;
    }
    setValue(value() + static_cast<int>(std::lround(wheelSteps(*event) * singleStep())));
    event->accept();
}

} // namespace fumage::ui
