#include "ui/panels/key_mark.h"

#include "ui/document/parameter_text.h"
#include "ui/document/text.h"
#include "ui/widgets/diamond.h"

namespace fumage::ui {

KeyMark::KeyMark(const Parameter& parameter, Document& document, QWidget* parent)
    : QAbstractButton(parent)
    , m_parameter(parameter)
    , m_document(document)
{
    setObjectName(toQString(parameter.key) + QStringLiteral(".keyMark"));
    setAccessibleName(tr("Key frame of %1").arg(fullLabelOf(parameter)));
    setFixedWidth(kWidth);
    setFocusPolicy(Qt::NoFocus); // the menu of the row has it for keyboards
    connect(this, &QAbstractButton::clicked, this, &KeyMark::toggle);
}

void KeyMark::toggle()
{
    if (m_state == KeyState::Here) {
        removeKey(m_document, m_parameter);
    } else {
        addKey(m_document, m_parameter);
    }
}

void KeyMark::sync()
{
    const KeyState state = keyState(m_document, m_parameter);
    setEnabled(m_document.canEdit(m_parameter));
    if (state != m_state || toolTip().isEmpty()) {
        m_state = state;
        setToolTip(state == KeyState::Here ? tr("Key frame here; click to remove it")
                                           : tr("Click to set a key frame at the time that is shown"));
        update();
    }
}

void KeyMark::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    QColor colour = m_state == KeyState::None ? palette().text().color() : palette().highlight().color();
    constexpr int kFaint = 60;
    constexpr int kUnderHand = 170;
    if (m_state == KeyState::None) {
        colour.setAlpha(underMouse() && isEnabled() ? kUnderHand : kFaint);
    }
    constexpr double kRadius = 4.0;
    painter.setRenderHint(QPainter::Antialiasing);
    paintDiamond(painter, QRectF(rect()).center(), kRadius, colour, m_state == KeyState::Here);
}

void KeyMark::enterEvent(QEnterEvent*)
{
    update();
}

void KeyMark::leaveEvent(QEvent*)
{
    update();
}

} // namespace fumage::ui
