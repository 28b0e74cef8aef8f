#pragma once

#include "ui/panels/parameter_editor.h"

class QCheckBox;
class QComboBox;

namespace fumage::ui {

class AngleDial;
class NumberSlider;

/// Float and Int: a slider and a field; angles that go all around have a dial as well.
class NumberEditor : public ParameterEditor {
    Q_OBJECT

public:
    NumberEditor(const Parameter& parameter, QWidget* parent);
    void setValue(const Value& value) override;

private:
    void change(double number, bool finished);
    void showNumber(double number);

    NumberSlider* m_slider;
    NumberField* m_field;
    AngleDial* m_dial = nullptr;
};

class BoolEditor : public ParameterEditor {
    Q_OBJECT

public:
    BoolEditor(const Parameter& parameter, QWidget* parent);
    void setValue(const Value& value) override;

private:
    QCheckBox* m_box;
};

class ChoiceEditor : public ParameterEditor {
    Q_OBJECT

public:
    ChoiceEditor(const Parameter& parameter, QWidget* parent);
    void setValue(const Value& value) override;

private:
    QComboBox* m_box;
};

/// A number whose size means nothing: typed, or thrown with dice.
class SeedEditor : public ParameterEditor {
    Q_OBJECT

public:
    SeedEditor(const Parameter& parameter, QWidget* parent);
    void setValue(const Value& value) override;

private:
    NumberField* m_field;
};

} // namespace fumage::ui
