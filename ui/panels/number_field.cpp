#include "ui/panels/number_field.h"

#include "ui/document/number_text.h"
#include "ui/document/text.h"
#include "ui/widgets/field_keys.h"
#include "ui/widgets/plain_text.h"

#include <algorithm>
#include <cmath>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QStyleOptionFrame>
#include <QToolTip>

namespace fumage::ui {

namespace {

constexpr double kDragThreshold = 3.0; ///< pixels
constexpr double kFine = 0.1;
constexpr double kCoarse = 10.0;
constexpr double kThousand = 1000.0; ///< a field that cannot hold it has no thousands to part

} // namespace

NumberField::NumberField(const NumberScale& scale, QWidget* parent)
    : QLineEdit(parent)
    , m_scale(scale)
{
    setAlignment(Qt::AlignRight);
    setCursor(Qt::SizeHorCursor);
    // A press may become a drag: the release of a click gives the focus.
    setFocusPolicy(Qt::TabFocus);
    setContextMenuPolicy(Qt::NoContextMenu); // the row has one
    connect(&m_burst, &GestureTimer::ended, this, [this] { emit edited(m_value, true); });
    showValue();
}

QSize NumberField::sizeHint() const
{
    constexpr int kPadding = 18;
    const int width = fontMetrics().horizontalAdvance(QStringLiteral("-0.0000 m/s²")) + kPadding;
    return {width, QLineEdit::sizeHint().height()};
}

void NumberField::setValue(double value)
{
    m_value = value;
    if (!(hasFocus() && isModified())) {
        showValue();
    }
}

/// With as many digits as there is room for while it is only looked at, and then without the unit: a number that is cut
/// off would be another one.
QString NumberField::fittingText() const
{
    const QMargins margins = textMargins();
    const QStyleOptionFrame option = [this] {
        QStyleOptionFrame made;
        initStyleOption(&made);
        return made;
    }();
    constexpr int kPadding = 4; // of QLineEdit, to both sides
    const int room = style()->subElementRect(QStyle::SE_LineEditContents, &option, this).width() - margins.left()
        - margins.right() - kPadding;
    QString whole = formatNumber(m_value, m_scale.unit);
    if (hasFocus() || room <= 0) {
        return whole;
    }
    const auto fits = [&](const QString& text) { return fontMetrics().horizontalAdvance(text) <= room; };
    constexpr int kMinDigits = 3;
    for (const Unit unit : {m_scale.unit, Unit::None}) {
        for (int digits = kShownDigits; digits >= kMinDigits; --digits) {
            if (QString text = formatNumber(m_value, unit, digits); fits(text)) {
                return text;
            }
        }
    }
    return formatNumber(m_value, kMinDigits);
}

void NumberField::resizeEvent(QResizeEvent* event)
{
    QLineEdit::resizeEvent(event);
    if (!hasFocus()) {
        showValue();
    }
}

void NumberField::showValue()
{
    setText(fittingText());
    setCursorPosition(0);
    if (hasFocus()) {
        selectAll();
    }
    setModified(false);
}

void NumberField::commitText()
{
    if (!isModified()) {
        return;
    }
    const std::optional<double> number =
        parseNumber(text(), m_scale.unit, m_scale.whole && m_scale.hard.high >= kThousand);
    setModified(false);
    if (!number) {
        const QString unit = toQString(unitSymbol(m_scale.unit));
        QToolTip::showText(mapToGlobal(QPoint(0, height())),
            plainToolTip(unit.isEmpty() ? tr("“%1” is not a number.").arg(shortened(text()))
                                        : tr("“%1” is not a number in %2.").arg(shortened(text()), unit)),
            this);
        showValue();
        return;
    }
    const double inside = std::clamp(*number, m_scale.hard.low, m_scale.hard.high);
    m_value = m_scale.whole ? std::round(inside) : inside;
    showValue();
    if (inside != *number) {
        QToolTip::showText(mapToGlobal(QPoint(0, height())),
            plainToolTip((inside < *number ? tr("%1 is the largest.") : tr("%1 is the smallest."))
                             .arg(formatNumber(m_value, m_scale.unit))),
            this);
    }
    emit edited(m_value, true);
}

void NumberField::stepBy(double steps)
{
    commitText();
    m_value = m_scale.stepped(m_value, steps);
    showValue();
    m_burst.start();
    emit edited(m_value, false);
}

void NumberField::mousePressEvent(QMouseEvent* event)
{
    if (hasFocus() || event->button() != Qt::LeftButton) {
        QLineEdit::mousePressEvent(event);
        return;
    }
    m_pressed = true;
    m_dragged = false;
    m_way.begin(*event);
    m_valueAtPress = m_value;
}

void NumberField::mouseMoveEvent(QMouseEvent* event)
{
    if (!m_pressed) {
        QLineEdit::mouseMoveEvent(event);
        return;
    }
    const double way = m_way.to(*event).x();
    if (!m_dragged && std::abs(way) < kDragThreshold) {
        return;
    }
    m_dragged = true;
    const double steps = event->modifiers().testFlag(Qt::ShiftModifier) ? way * kFine : way;
    double value = m_scale.stepped(m_valueAtPress, steps);
    if (event->modifiers().testFlag(Qt::ControlModifier)) {
        const double grid = m_scale.step * kCoarse;
        value = m_scale.settled(std::round(value / grid) * grid);
    }
    if (value != m_value) {
        m_value = value;
        showValue();
        emit edited(value, false);
    }
}

void NumberField::mouseReleaseEvent(QMouseEvent* event)
{
    if (!m_pressed || event->button() != Qt::LeftButton) {
        QLineEdit::mouseReleaseEvent(event);
        return;
    }
    m_pressed = false;
    if (m_dragged) {
        emit edited(m_value, true);
    } else {
        setFocus(Qt::MouseFocusReason);
        selectAll();
    }
}

void NumberField::wheelEvent(QWheelEvent* event)
{
    // Without the focus the wheel belongs to the panel that scrolls.
    if (!hasFocus() || event->angleDelta().y() == 0) {
        event->ignore();
        return;
    }
    stepBy(wheelSteps(*event) * (event->modifiers().testFlag(Qt::ShiftModifier) ? kFine : 1.0));
    event->accept();
}

void NumberField::keyPressEvent(QKeyEvent* event)
{
    switch (event->key()) {
    case Qt::Key_Up: stepBy(1.0); return;
    case Qt::Key_Down: stepBy(-1.0); return;
    case Qt::Key_PageUp: stepBy(kCoarse); return;
    case Qt::Key_PageDown: stepBy(-kCoarse); return;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        commitText();
        selectAll();
        leaveField(*this);
        return;
    case Qt::Key_Escape:
        if (isModified() || isInMainWindow(*this)) {
            showValue();
            leaveField(*this);
            return;
        }
        break;
    default: break;
    }
    QLineEdit::keyPressEvent(event);
}

void NumberField::focusInEvent(QFocusEvent* event)
{
    QLineEdit::focusInEvent(event);
    showValue(); // all of it
    setCursor(Qt::IBeamCursor);
    selectAll();
}

void NumberField::focusOutEvent(QFocusEvent* event)
{
    commitText();
    m_burst.end();
    setCursor(Qt::SizeHorCursor);
    QLineEdit::focusOutEvent(event);
    showValue();
    deselect();
    setCursorPosition(0);
}

} // namespace fumage::ui
