#include "ui/panels/simple_editors.h"

#include "ui/document/parameter_text.h"
#include "ui/panels/angle_dial.h"
#include "ui/theme/icons.h"
#include "ui/panels/number_field.h"
#include "ui/panels/number_slider.h"

#include <cmath>

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QRandomGenerator>
#include <QSignalBlocker>
#include <QToolButton>

namespace fumage::ui {

namespace {

QHBoxLayout* makeRow(QWidget* parent)
{
    constexpr int kGap = 6;
    auto* row = new QHBoxLayout(parent);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kGap);
    return row;
}

double numberOf(const Value& value)
{
    if (const int* whole = std::get_if<int>(&value)) {
        return *whole;
    }
    if (const std::uint32_t* seed = std::get_if<std::uint32_t>(&value)) {
        return *seed;
    }
    return static_cast<double>(std::get<float>(value));
}

bool goesAllAround(const Parameter& parameter)
{
    constexpr double kFullTurn = 360.0;
    return parameter.unit == Unit::Degrees && parameter.soft.high - parameter.soft.low >= kFullTurn;
}

} // namespace

NumberEditor::NumberEditor(const Parameter& parameter, QWidget* parent)
    : ParameterEditor(parameter, parent)
    , m_slider(new NumberSlider(NumberScale::of(parameter), this))
    , m_field(addField(QStringLiteral("field"), {}))
{
    name(*m_slider, QStringLiteral("slider"), {});
    QHBoxLayout* row = makeRow(this);
    if (goesAllAround(parameter)) {
        m_dial = new AngleDial(this);
        name(*m_dial, QStringLiteral("dial"), {});
        row->addWidget(m_dial);
        connect(m_dial, &AngleDial::edited, this, &NumberEditor::change);
    }
    row->addWidget(m_slider, 1);
    row->addWidget(m_field);
    setFocusProxy(m_field);
    connect(m_slider, &NumberSlider::edited, this, &NumberEditor::change);
    connect(m_field, &NumberField::edited, this, &NumberEditor::change);
}

void NumberEditor::change(double number, bool finished)
{
    showNumber(number);
    if (parameter().kind == Kind::Int) {
        emit edited(static_cast<int>(std::lround(number)), finished);
    } else {
        emit edited(static_cast<float>(number), finished);
    }
}

void NumberEditor::showNumber(double number)
{
    m_slider->setNumber(number);
    m_field->setValue(number);
    if (m_dial != nullptr) {
        m_dial->setAngle(number);
    }
}

void NumberEditor::setValue(const Value& value)
{
    showNumber(numberOf(value));
}

BoolEditor::BoolEditor(const Parameter& parameter, QWidget* parent)
    : ParameterEditor(parameter, parent)
    , m_box(new QCheckBox(this))
{
    name(*m_box, QStringLiteral("box"), {});
    QHBoxLayout* row = makeRow(this);
    row->addWidget(m_box);
    row->addStretch();
    setFocusProxy(m_box);
    connect(m_box, &QCheckBox::toggled, this, [this](bool on) { emit edited(on, true); });
}

void BoolEditor::setValue(const Value& value)
{
    const QSignalBlocker blocker(m_box);
    m_box->setChecked(std::get<bool>(value));
}

ChoiceEditor::ChoiceEditor(const Parameter& parameter, QWidget* parent)
    : ParameterEditor(parameter, parent)
    , m_box(new QComboBox(this))
{
    name(*m_box, QStringLiteral("box"), {});
    for (const std::string_view choice : parameter.choices) {
        m_box->addItem(choiceLabelOf(choice));
    }
    makeRow(this)->addWidget(m_box, 1);
    setFocusProxy(m_box);
    connect(m_box, &QComboBox::currentIndexChanged, this, [this](int index) { emit edited(index, true); });
}

void ChoiceEditor::setValue(const Value& value)
{
    const QSignalBlocker blocker(m_box);
    m_box->setCurrentIndex(std::get<int>(value));
}

SeedEditor::SeedEditor(const Parameter& parameter, QWidget* parent)
    : ParameterEditor(parameter, parent)
    , m_field(addField(QStringLiteral("field"), {}))
{
    auto* dice = new QToolButton(this);
    name(*dice, QStringLiteral("dice"), tr("dice"));
    dice->setIcon(themedIcon(QStringLiteral("dice")));
    dice->setToolTip(tr("New seed: another smoke of the same kind"));
    dice->setAutoRaise(true);
    auto* lock = new QToolButton(this);
    name(*lock, QStringLiteral("lock"), tr("lock"));
    lock->setIcon(themedIcon(QStringLiteral("lock")));
    lock->setToolTip(tr("Lock the seed, so that no slip of the hand changes the smoke"));
    lock->setCheckable(true);
    lock->setAutoRaise(true);
    QHBoxLayout* row = makeRow(this);
    row->addWidget(m_field, 1);
    row->addWidget(dice);
    row->addWidget(lock);
    connect(lock, &QToolButton::toggled, dice, &QWidget::setDisabled);
    connect(lock, &QToolButton::toggled, m_field, &QWidget::setDisabled);
    setFocusProxy(m_field);
    connect(m_field, &NumberField::edited, this,
        [this](double number, bool finished) { emit edited(static_cast<std::uint32_t>(number), finished); });
    connect(dice, &QToolButton::clicked, this,
        [this] { emit edited(static_cast<std::uint32_t>(QRandomGenerator::global()->generate()), true); });
}

void SeedEditor::setValue(const Value& value)
{
    m_field->setValue(numberOf(value));
}

} // namespace fumage::ui
