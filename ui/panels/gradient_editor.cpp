#include "ui/panels/gradient_editor.h"

#include "ui/panels/colour_editor.h"

#include <algorithm>
#include <cmath>

#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QVBoxLayout>

namespace fumage::ui {

namespace {

constexpr double kMargin = 7.0;
constexpr double kBarHeight = 18.0;
constexpr double kHandleHalf = 6.0;

} // namespace

GradientBar::GradientBar(QWidget* parent)
    : PointStrip(parent)
{
    setFixedHeight(sizeHint().height());
}

void GradientBar::setGradient(const Gradient& gradient)
{
    if (isFree()) {
        m_gradient = gradient;
        pointsReplaced();
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

float GradientBar::positionOf(const QPointF& mouse) const
{
    const QRectF inside = bar();
    return std::round(static_cast<float>(std::clamp((mouse.x() - inside.left()) / inside.width(), 0.0, 1.0)) * 1000.0F) / 1000.0F;
}

int GradientBar::pointAt(const QPointF& mouse) const
{
    for (int i = m_gradient.count - 1; i >= 0; --i) {
        if (std::abs(handle(i).x() - mouse.x()) <= kHandleHalf && mouse.y() > bar().bottom() - 4.0) {
            return i;
        }
    }
    return -1;
}

int GradientBar::insertAfter(int index)
{
    return insert(std::min(1.0F, m_gradient.storage[static_cast<std::size_t>(index)].at + kBeside));
}

bool GradientBar::step(int index, int right, int up)
{
    if (up != 0) {
        return false;
    }
    place(index, m_gradient.storage[static_cast<std::size_t>(index)].at + static_cast<float>(right) * kStep);
    return true;
}

void GradientBar::place(int index, float at)
{
    const auto stop = [&](int i) -> GradientStop& { return m_gradient.storage[static_cast<std::size_t>(i)]; };
    const float low = index > 0 ? stop(index - 1).at : 0.0F;
    const float high = index + 1 < m_gradient.count ? stop(index + 1).at : 1.0F;
    stop(index).at = std::clamp(at, low, high);
}

void GradientBar::colourStop(int stop)
{
    const Gradient before = m_gradient;
    chooseColour(this, tr("Colour of the stop"), before.storage[static_cast<std::size_t>(stop)].colour, [this, stop, before](const glm::vec3& colour, bool finished) {
        m_gradient = before;
        m_gradient.storage[static_cast<std::size_t>(stop)].colour = colour;
        update();
        emit changed(finished);
    });
}

void GradientBar::addPointActions(QMenu& menu, int index)
{
    menu.addAction(tr("Colour of the stop"), this, [this, index] { colourStop(index); });
}

void GradientBar::mouseDoubleClickEvent(QMouseEvent* event)
{
    const int stop = pointAt(event->position());
    if (stop >= 0) {
        letGo();
        colourStop(stop);
    }
}

void GradientBar::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        colourStop(selected());
    } else {
        PointStrip::keyPressEvent(event);
    }
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
        const bool marked = isMarked(i);
        painter.setPen(QPen(marked ? palette().highlight().color() : palette().text().color(), marked ? 2.2 : 1.2));
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
    layout->setSpacing(0);
    layout->addWidget(m_bar);
    layout->addWidget(makeHint(tr("Press to add, drag to move, double click for the colour, right click for more")));
    setFocusProxy(m_bar);
    connect(m_bar, &GradientBar::changed, this, [this](bool finished) { emit edited(m_bar->gradient(), finished); });
}

void GradientEditor::setValue(const Value& value)
{
    m_bar->setGradient(std::get<Gradient>(value));
}

} // namespace fumage::ui
