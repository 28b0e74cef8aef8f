#include "ui/panels/gradient_editor.h"

#include "ui/panels/colour_editor.h"
#include "ui/panels/gradient_presets.h"

#include <algorithm>
#include <cmath>

#include <QHBoxLayout>
#include <QIcon>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>

namespace fumage::ui {

namespace {

constexpr double kMargin = 7.0;
constexpr double kBarHeight = 18.0;
constexpr double kHandleHalf = 6.0;

/// Joined in linear light, as the smoke does it, not on the screen.
QImage picturedRow(const Gradient& gradient, int columns)
{
    QImage row(std::max(1, columns), 1, QImage::Format_RGB32);
    for (int x = 0; x < row.width(); ++x) {
        row.setPixelColor(
            x, 0, screenColour(gradient.at((static_cast<float>(x) + 0.5F) / static_cast<float>(row.width()))));
    }
    return row;
}

QIcon iconOf(const Gradient& gradient)
{
    constexpr int kWidth = 48;
    constexpr int kHeight = 16;
    return QPixmap::fromImage(picturedRow(gradient, kWidth).scaled(kWidth, kHeight));
}

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

void GradientBar::replace(const Gradient& gradient)
{
    if (!(gradient == m_gradient)) {
        m_gradient = gradient;
        pointsReplaced();
        emit changed(true);
    }
}

QRectF GradientBar::bar() const
{
    return {kMargin, 3.0, width() - 2.0 * kMargin, kBarHeight};
}

QPointF GradientBar::handle(int stop) const
{
    const QRectF inside = bar();
    return {inside.left() + static_cast<double>(m_gradient.storage[static_cast<std::size_t>(stop)].at) * inside.width(),
        inside.bottom() + kHandleHalf + 2.0};
}

float GradientBar::positionOf(const QPointF& mouse) const
{
    const QRectF inside = bar();
    return std::round(static_cast<float>(std::clamp((mouse.x() - inside.left()) / inside.width(), 0.0, 1.0)) * 1000.0F)
        / 1000.0F;
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
    chooseColour(this, tr("Colour of the stop"), before.storage[static_cast<std::size_t>(stop)].colour,
        [this, stop, before](const glm::vec3& colour, bool finished) {
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
    painter.drawImage(inside, picturedRow(m_gradient, static_cast<int>(inside.width())));
    painter.setPen(QPen(palette().mid().color(), 1.0));
    painter.drawRect(inside);
    for (int i = 0; i < m_gradient.count; ++i) {
        const QPointF at = handle(i);
        const bool marked = isMarked(i);
        painter.setPen(QPen(marked ? palette().highlight().color() : palette().text().color(), marked ? 2.2 : 1.2));
        painter.setBrush(screenColour(m_gradient.storage[static_cast<std::size_t>(i)].colour));
        const QPolygonF drop{{at.x(), at.y() - kHandleHalf - 2.0}, {at.x() + kHandleHalf - 1.0, at.y() - 2.0},
            {at.x() + kHandleHalf - 1.0, at.y() + kHandleHalf}, {at.x() - kHandleHalf + 1.0, at.y() + kHandleHalf},
            {at.x() - kHandleHalf + 1.0, at.y() - 2.0}};
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
    auto* menu = new QMenu(this);
    name(*menu, QStringLiteral("menu"), tr("presets"));
    connect(menu, &QMenu::aboutToShow, this, [this, menu] {
        menu->clear();
        fillMenu(*menu);
    });
    auto* presets = new QToolButton(this);
    name(*presets, QStringLiteral("presets"), tr("presets"));
    presets->setText(tr("Presets"));
    presets->setToolTip(tr("Gradients to begin with, and other hues for all colours of this one"));
    presets->setPopupMode(QToolButton::InstantPopup);
    presets->setMenu(menu);
    auto* below = new QHBoxLayout;
    below->addWidget(makeHint(tr("Click to add, drag to move, double click for the colour, right click for more")), 1);
    below->addWidget(presets, 0, Qt::AlignTop);
    layout->addWidget(m_bar);
    layout->addLayout(below);
    setFocusProxy(m_bar);
    connect(m_bar, &GradientBar::changed, this, [this](bool finished) { emit edited(m_bar->gradient(), finished); });
}

void GradientEditor::addActions(QMenu& menu, const QPoint& global)
{
    m_bar->addActions(menu, global);
    fillMenu(*menu.addMenu(tr("Gradient")));
    menu.addSeparator();
}

void GradientEditor::fillMenu(QMenu& menu)
{
    for (const GradientPreset& preset : gradientPresets()) {
        menu.addAction(
            iconOf(preset.gradient), nameOf(preset), this, [this, &preset] { m_bar->replace(preset.gradient); });
    }
    menu.addSeparator();
    QMenu* hues = menu.addMenu(tr("Other hues"));
    for (const int degrees : {30, 60, 90, 120, 150, 180, -150, -120, -90, -60, -30}) {
        const Gradient turned = hueShifted(m_bar->gradient(), degrees);
        hues->addAction(
            iconOf(turned), QStringLiteral("%1°").arg(degrees), this, [this, turned] { m_bar->replace(turned); });
    }
    menu.addAction(tr("Reverse"), this, [this] { m_bar->replace(reversed(m_bar->gradient())); });
}

void GradientEditor::setValue(const Value& value)
{
    m_bar->setGradient(std::get<Gradient>(value));
}

} // namespace fumage::ui
