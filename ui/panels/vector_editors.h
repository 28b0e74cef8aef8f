#pragma once

#include "ui/panels/parameter_editor.h"

#include <array>

class QGridLayout;

namespace fumage::ui {

class NumberSlider;
struct NumberScale;

/// Three components in a row.
class VectorEditor : public ParameterEditor {
    Q_OBJECT

public:
    VectorEditor(const Parameter& parameter, QWidget* parent);
    void setValue(const Value& value) override;

private:
    std::array<NumberField*, 3> m_fields{};
    glm::vec3 m_value{0.0F};
};

/// A direction as x, y, z that stay a unit vector, and as yaw and pitch with sliders.
class DirectionEditor : public ParameterEditor {
    Q_OBJECT

public:
    DirectionEditor(const Parameter& parameter, QWidget* parent);
    void setValue(const Value& value) override;

private:
    /// An angle with its slider and field.
    struct Angle {
        NumberSlider* slider;
        NumberField* field;
    };
    [[nodiscard]] Angle addAngle(
        const QString& suffix, const QString& label, const NumberScale& scale, QGridLayout& grid, int row);
    void setComponent(int index, double number, bool finished);
    void setAngles(double yaw, double pitch, bool finished);
    void change(const glm::vec3& value, bool finished);
    void showValue();

    std::array<NumberField*, 3> m_fields{};
    Angle m_yaw{};
    Angle m_pitch{};
    double m_lastYaw = 0.0; ///< kept where the direction is vertical and has none
    glm::vec3 m_value{0.0F, 1.0F, 0.0F};
};

/// The unit vector with one component set and the others scaled to fit.
[[nodiscard]] glm::vec3 withComponent(const glm::vec3& direction, int index, float value);

/// Yaw (0 along +X, 90 along +Z) and pitch (90 is up) of a direction in degrees, and back.
struct YawPitch {
    double yaw = 0.0;
    double pitch = 0.0;
};
[[nodiscard]] YawPitch anglesOf(const glm::vec3& direction, double yawWhereVertical);
[[nodiscard]] glm::vec3 directionOf(const YawPitch& angles);

} // namespace fumage::ui
