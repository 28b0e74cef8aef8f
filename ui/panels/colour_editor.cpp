#include "ui/panels/colour_editor.h"

#include "ui/document/parameter_text.h"
#include "ui/panels/number_field.h"
#include "ui/widgets/gesture.h"

#include "core/rendering/view_transform.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include <QColorDialog>
#include <QHBoxLayout>
#include <QPainter>
#include <QToolButton>

namespace fumage::ui {

/// As many digits as three fields beside one another have room for; a channel of a screen has 256 steps.
static constexpr double kShown = 1e3;

QColor screenColour(const glm::vec3& linear)
{
    const auto channel = [](float value) { return std::clamp(srgbFromLinear(std::max(0.0F, value)), 0.0F, 1.0F); };
    return QColor::fromRgbF(channel(linear.r), channel(linear.g), channel(linear.b));
}

glm::vec3 linearColour(const QColor& screen)
{
    const auto channel = [](float value) { return linearFromSrgb(std::max(0.0F, value)); };
    return {channel(screen.redF()), channel(screen.greenF()), channel(screen.blueF())};
}

QColorDialog& chooseColour(QWidget* parent, const QString& title, const glm::vec3& before,
    const std::function<void(const glm::vec3&, bool)>& changed)
{
    auto* dialog = new QColorDialog(screenColour(before), parent);
    dialog->setObjectName(QStringLiteral("colourDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(title);
    dialog->setOption(QColorDialog::DontUseNativeDialog);
    // What nobody has touched stays as it is, also where a screen does not show it as such.
    const auto isTouched = std::make_shared<bool>(false);
    QObject::connect(dialog, &QColorDialog::currentColorChanged, parent, [changed, isTouched](const QColor& colour) {
        *isTouched = true;
        changed(linearColour(colour), false);
    });
    QObject::connect(dialog, &QColorDialog::colorSelected, parent, [changed, before, isTouched](const QColor& colour) {
        changed(*isTouched ? linearColour(colour) : before, true);
    });
    QObject::connect(dialog, &QColorDialog::rejected, parent, [parent, changed, before, isTouched] {
        if (*isTouched) {
            sendDragCancel(parent); // a key frame of the colour before is one more than there was
            changed(before, true);
        }
    });
    dialog->open();
    return *dialog;
}

ColourEditor::ColourEditor(const Parameter& parameter, QWidget* parent)
    : ParameterEditor(parameter, parent)
    , m_swatch(new QToolButton(this))
{
    name(*m_swatch, QStringLiteral("swatch"), tr("swatch"));
    m_swatch->setToolButtonStyle(Qt::ToolButtonIconOnly);
    m_swatch->setIconSize({22, 16});
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(3); // room for the numbers
    row->addWidget(m_swatch);
    const std::array<QString, 3> names{QStringLiteral("r"), QStringLiteral("g"), QStringLiteral("b")};
    for (std::size_t i = 0; i < names.size(); ++i) {
        m_fields[i] = addField(names[i], names[i]);
        row->addWidget(m_fields[i], 1);
        connect(m_fields[i], &NumberField::edited, this, [this, i](double number, bool finished) {
            m_value[static_cast<int>(i)] = static_cast<float>(number);
            showValue();
            emit edited(m_value, finished);
        });
    }
    setFocusProxy(m_swatch);
    connect(m_swatch, &QToolButton::clicked, this, [this] {
        chooseColour(this, fullLabelOf(this->parameter()), m_value, [this](const glm::vec3& colour, bool finished) {
            m_value = colour;
            showValue();
            emit edited(m_value, finished);
        });
    });
}

void ColourEditor::showValue()
{
    QPixmap swatch(m_swatch->iconSize() * devicePixelRatioF());
    swatch.setDevicePixelRatio(devicePixelRatioF());
    swatch.fill(screenColour(m_value));
    m_swatch->setIcon(swatch);
    for (int i = 0; i < 3; ++i) {
        m_fields[static_cast<std::size_t>(i)]->setValue(std::round(static_cast<double>(m_value[i]) * kShown) / kShown);
    }
}

void ColourEditor::setValue(const Value& value)
{
    m_value = std::get<glm::vec3>(value);
    showValue();
}

} // namespace fumage::ui
