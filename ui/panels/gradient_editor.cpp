#include "ui/panels/gradient_editor.h"

#include "ui/panels/colour_editor.h"

#include <algorithm>
#include <cmath>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QVBoxLayout>

namespace fumage::ui {

namespace {

constexpr double kMargin = 7.0;
constexpr double kBarHeight = 18.0;
constexpr double kHandleHalf = 6.0;
constexpr float kStep = 0.01F;

} // namespace

GradientBar::GradientBar(QWidget* parent)
    : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setFixedHeight(sizeHint().height());
}

void GradientBar::setGradient(const Gradient& gradient)
{
    if (!m_dragging) {
        m_gradient = gradient;
        m_selected = std::clamp(m_selected, 0, std::max(0, gradient.count - 1));
        update();
    }
}

QRectF GradientBar::bar() const
{
    return {kMargin, 3.0, width() - 2.0 * kMargin, kBarHeight};
}

QPointF GradientBar::handle(int stop) const
{
    const QRectF inside = bar();
    return {inside.left() + static_cast<double>(m_gradient.storage[static_cast<std::size_t>(stop)].at) * inside.width(), inside.bottom() + kHandleHalf + 2.0};
}

float GradientBar::positionOf(const QPointF& at) const
{
    const QRectF inside = bar();
    return std::round(static_cast<float>(std::clamp((at.x() - inside.left()) / inside.width(), 0.0, 1.0)) * 1000.0F) / 1000.0F;
}

int GradientBar::stopAt(const QPointF& at) const
{
    for (int i = m_gradient.count - 1; i >= 0; --i) {
        if (std::abs(handle(i).x() - at.x()) <= kHandleHalf && at.y() > bar().bottom() - 4.0) {
            return i;
        }
    }
    return -1;
}

void GradientBar::insert(float at)
{
    if (m_gradient.count == kMaxControlPoints) {
        return;
    }
    const GradientStop stop{at, m_gradient.at(at)};
    const auto begin = m_gradient.storage.begin();
    const auto end = begin + m_gradient.count;
    const auto place = std::upper_bound(begin, end, stop, [](const GradientStop& a, const GradientStop& b) { return a.at < b.at; });
    m_selected = static_cast<int>(place - begin);
    std::copy_backward(place, end, end + 1);
    *place = stop;
    ++m_gradient.count;
    update();
    emit edited(m_gradient, false);
}

void GradientBar::remove(int stop)
{
    if (m_gradient.count < 2 || stop < 0) {
        return;
    }
    const auto at = m_gradient.storage.begin() + stop;
    std::copy(at + 1, m_gradient.storage.begin() + m_gradient.count, at);
    --m_gradient.count;
    m_gradient.storage[static_cast<std::size_t>(m_gradient.count)] = {};
    m_selected = std::clamp(stop, 0, m_gradient.count - 1);
    update();
    emit edited(m_gradient, true);
}

void GradientBar::moveStop(int stop, float at)
{
    const auto place = [&](int i) -> GradientStop& { return m_gradient.storage[static_cast<std::size_t>(i)]; };
    const float low = stop > 0 ? place(stop - 1).at : 0.0F;
    const float high = stop + 1 < m_gradient.count ? place(stop + 1).at : 1.0F;
    place(stop).at = std::clamp(at, low, high);
    update();
    emit edited(m_gradient, false);
}

void GradientBar::colourStop(int stop)
{
    const Gradient before = m_gradient;
    chooseColour(this, tr("Colour of the stop"), before.storage[static_cast<std::size_t>(stop)].colour, [this, stop, before](const glm::vec3& colour, bool finished) {
        m_gradient = before;
        m_gradient.storage[static_cast<std::size_t>(stop)].colour = colour;
        update();
        emit edited(m_gradient, finished);
    });
}

void GradientBar::mousePressEvent(QMouseEvent* event)
{
    const int stop = stopAt(event->position());
    if (event->button() == Qt::RightButton) {
        remove(stop);
        return;
    }
    m_dragging = true;
    if (stop < 0) {
        insert(positionOf(event->position()));
    } else {
        m_selected = stop;
        update();
    }
}

void GradientBar::mouseMoveEvent(QMouseEvent* event)
{
    if (m_dragging) {
        moveStop(m_selected, positionOf(event->position()));
    }
}

void GradientBar::mouseReleaseEvent(QMouseEvent*)
{
    if (m_dragging) {
        m_dragging = false;
        emit edited(m_gradient, true);
    }
}

void GradientBar::mouseDoubleClickEvent(QMouseEvent* event)
{
    const int stop = stopAt(event->position());
    if (stop >= 0) {
        m_dragging = false;
        colourStop(stop);
    }
}

void GradientBar::keyPressEvent(QKeyEvent* event)
{
    const float at = m_gradient.storage[static_cast<std::size_t>(m_selected)].at;
    switch (event->key()) {
    case Qt::Key_Delete:
    case Qt::Key_Backspace: remove(m_selected); return;
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
        m_selected = std::clamp(m_selected + (event->key() == Qt::Key_PageDown ? 1 : -1), 0, m_gradient.count - 1);
        update();
        return;
    case Qt::Key_Return:
    case Qt::Key_Enter: colourStop(m_selected); return;
    case Qt::Key_Insert: insert(std::min(1.0F, at + 0.1F)); break;
    case Qt::Key_Left: moveStop(m_selected, at - kStep); break;
    case Qt::Key_Right: moveStop(m_selected, at + kStep); break;
    default: QWidget::keyPressEvent(event); return;
    }
    emit edited(m_gradient, true);
}

void GradientBar::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF inside = bar();
    // Joined in linear light, as the smoke does it, not on the screen.
    const int columns = static_cast<int>(inside.width());
    QImage row(std::max(1, columns), 1, QImage::Format_RGB32);
    for (int x = 0; x < row.width(); ++x) {
        row.setPixelColor(x, 0, screenColour(m_gradient.at((static_cast<float>(x) + 0.5F) / static_cast<float>(row.width()))));
    }
    painter.drawImage(inside, row);
    painter.setPen(QPen(palette().mid().color(), 1.0));
    painter.drawRect(inside);
    for (int i = 0; i < m_gradient.count; ++i) {
        const QPointF at = handle(i);
        const bool selected = i == m_selected && hasFocus();
        painter.setPen(QPen(selected ? palette().highlight().color() : palette().text().color(), selected ? 2.2 : 1.2));
        painter.setBrush(screenColour(m_gradient.storage[static_cast<std::size_t>(i)].colour));
        const QPolygonF drop{{at.x(), at.y() - kHandleHalf - 2.0}, {at.x() + kHandleHalf - 1.0, at.y() - 2.0}, {at.x() + kHandleHalf - 1.0, at.y() + kHandleHalf}, {at.x() - kHandleHalf + 1.0, at.y() + kHandleHalf}, {at.x() - kHandleHalf + 1.0, at.y() - 2.0}};
        painter.drawPolygon(drop);
    }
}

GradientEditor::GradientEditor(const Parameter& parameter, QWidget* parent)
    : ParameterEditor(parameter, parent)
    , m_bar(new GradientBar(this))
{
    name(*m_bar, QStringLiteral("bar"), {});
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_bar);
    setFocusProxy(m_bar);
    connect(m_bar, &GradientBar::edited, this, [this](const Gradient& gradient, bool finished) { emit edited(gradient, finished); });
}

void GradientEditor::setValue(const Value& value)
{
    m_bar->setGradient(std::get<Gradient>(value));
}

} // namespace fumage::ui
