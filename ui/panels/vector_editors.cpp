#include "ui/panels/vector_editors.h"

#include "ui/panels/number_field.h"
#include "ui/panels/number_slider.h"

#include <algorithm>
#include <cmath>

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace fumage::ui {

namespace {

const std::array<QString, 3> kNames{QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z")};

NumberScale yawScale()
{
    return {{-360.0, 360.0}, {-180.0, 180.0}, 1.0, false, false, Unit::Degrees};
}

NumberScale pitchScale()
{
    return {{-90.0, 90.0}, {-90.0, 90.0}, 1.0, false, false, Unit::Degrees};
}

QLabel* makeSmallLabel(const QString& text, QWidget* buddy)
{
    auto* label = new QLabel(text, buddy->parentWidget());
    label->setProperty("role", QStringLiteral("secondary"));
    label->setBuddy(buddy);
    return label;
}

} // namespace

glm::vec3 withComponent(const glm::vec3& direction, int index, float value)
{
    value = std::clamp(value, -1.0F, 1.0F);
    glm::vec3 rest = direction;
    rest[index] = 0.0F;
    float length = glm::length(rest);
    if (length <= 0.0F) {
        rest[(index + 1) % 3] = 1.0F;
        length = 1.0F;
    }
    glm::vec3 out = rest * (std::sqrt(1.0F - value * value) / length);
    out[index] = value;
    return out;
}

YawPitch anglesOf(const glm::vec3& direction, double yawWhereVertical)
{
    const double x = static_cast<double>(direction.x);
    const double z = static_cast<double>(direction.z);
    const double level = std::hypot(x, z);
    constexpr double kVertical = 1e-6;
    return {level > kVertical ? glm::degrees(std::atan2(z, x)) : yawWhereVertical,
        glm::degrees(std::atan2(static_cast<double>(direction.y), level))};
}

glm::vec3 directionOf(const YawPitch& angles)
{
    const double yaw = glm::radians(angles.yaw);
    const double pitch = glm::radians(angles.pitch);
    return {static_cast<float>(std::cos(pitch) * std::cos(yaw)), static_cast<float>(std::sin(pitch)),
        static_cast<float>(std::cos(pitch) * std::sin(yaw))};
}

VectorEditor::VectorEditor(const Parameter& parameter, QWidget* parent)
    : ParameterEditor(parameter, parent)
{
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    for (int i = 0; i < 3; ++i) {
        NumberField* field = addField(kNames[static_cast<std::size_t>(i)], kNames[static_cast<std::size_t>(i)]);
        m_fields[static_cast<std::size_t>(i)] = field;
        row->addWidget(field, 1);
        connect(field, &NumberField::edited, this, [this, i](double number, bool finished) {
            m_value[i] = static_cast<float>(number);
            emit edited(m_value, finished);
        });
    }
    setFocusProxy(m_fields[0]);
}

void VectorEditor::setValue(const Value& value)
{
    m_value = std::get<glm::vec3>(value);
    for (int i = 0; i < 3; ++i) {
        m_fields[static_cast<std::size_t>(i)]->setValue(static_cast<double>(m_value[i]));
    }
}

DirectionEditor::DirectionEditor(const Parameter& parameter, QWidget* parent)
    : ParameterEditor(parameter, parent)
{
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(4);
    grid->setColumnStretch(1, 1);
    auto* components = new QHBoxLayout;
    for (int i = 0; i < 3; ++i) {
        NumberField* field = addField(kNames[static_cast<std::size_t>(i)], kNames[static_cast<std::size_t>(i)]);
        m_fields[static_cast<std::size_t>(i)] = field;
        components->addWidget(field, 1);
        connect(field, &NumberField::edited, this,
            [this, i](double number, bool finished) { setComponent(i, number, finished); });
    }
    grid->addLayout(components, 0, 0, 1, 3);
    m_yaw = addAngle(QStringLiteral("yaw"), tr("Yaw"), yawScale(), *grid, 1);
    m_pitch = addAngle(QStringLiteral("pitch"), tr("Pitch"), pitchScale(), *grid, 2);
    const auto turn = [this](bool isYaw) {
        return [this, isYaw](double degrees, bool finished) {
            const YawPitch now = anglesOf(m_value, m_lastYaw);
            setAngles(isYaw ? degrees : now.yaw, isYaw ? now.pitch : degrees, finished);
        };
    };
    for (const bool isYaw : {true, false}) {
        const Angle& angle = isYaw ? m_yaw : m_pitch;
        connect(angle.slider, &NumberSlider::edited, this, turn(isYaw));
        connect(angle.field, &NumberField::edited, this, turn(isYaw));
    }
    setFocusProxy(m_fields[0]);
}

DirectionEditor::Angle DirectionEditor::addAngle(
    const QString& suffix, const QString& label, const NumberScale& scale, QGridLayout& grid, int row)
{
    const Angle angle{new NumberSlider(scale, this), new NumberField(scale, this)};
    name(*angle.slider, suffix + QStringLiteral(".slider"), label);
    name(*angle.field, suffix + QStringLiteral(".field"), label);
    grid.addWidget(makeSmallLabel(label, angle.field), row, 0);
    grid.addWidget(angle.slider, row, 1);
    angle.field->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    grid.addWidget(angle.field, row, 2);
    return angle;
}

void DirectionEditor::setComponent(int index, double number, bool finished)
{
    change(withComponent(m_value, index, static_cast<float>(number)), finished);
}

void DirectionEditor::setAngles(double yaw, double pitch, bool finished)
{
    m_lastYaw = yaw;
    change(directionOf({yaw, pitch}), finished);
}

void DirectionEditor::change(const glm::vec3& value, bool finished)
{
    m_value = value;
    showValue();
    emit edited(m_value, finished);
}

void DirectionEditor::showValue()
{
    for (int i = 0; i < 3; ++i) {
        m_fields[static_cast<std::size_t>(i)]->setValue(std::round(static_cast<double>(m_value[i]) * 1e4) / 1e4);
    }
    const YawPitch angles = anglesOf(m_value, m_lastYaw);
    m_lastYaw = angles.yaw;
    const auto show = [](const Angle& angle, double degrees) {
        const double rounded = std::round(degrees * 100.0) / 100.0;
        angle.slider->setNumber(rounded);
        angle.field->setValue(rounded);
    };
    show(m_yaw, angles.yaw);
    show(m_pitch, angles.pitch);
}

void DirectionEditor::setValue(const Value& value)
{
    const auto& direction = std::get<glm::vec3>(value);
    constexpr float kRounding = 1e-4F;
    if (glm::distance(direction, m_value) > kRounding) {
        m_lastYaw = 0.0; // that of another direction says nothing of a vertical one
    }
    m_value = direction;
    showValue();
}

} // namespace fumage::ui
