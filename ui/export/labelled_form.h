#pragma once

#include "ui/panels/parameter_row.h"

#include <QFormLayout>
#include <QLabel>
#include <QScrollArea>

namespace fumage::ui {

/// A form whose labels are as wide as those of parameters, so that fields of both stand below one another.
class LabelledForm : public QFormLayout {
public:
    /// @param parent without layout; null: the form becomes part of another one
    explicit LabelledForm(QWidget* parent = nullptr)
        : QFormLayout(parent)
    {
        setLabelAlignment(Qt::AlignLeft);
        setHorizontalSpacing(kGap);
    }

    static constexpr int kGap = 4; ///< between a label and its field, pixels
    static constexpr int kFieldLeft = ParameterRow::kLabelWidth + kGap; ///< where fields begin

    /// @param content a widget or a layout
    /// @return the label
    template <class Content>
    QLabel* add(const QString& text, Content* content)
    {
        auto* label = new QLabel(text);
        label->setFixedWidth(ParameterRow::kLabelWidth);
        addRow(label, content);
        return label;
    }
};

/// For tests, and for those who cannot see it.
inline void nameWidget(QWidget& widget, const QString& name, const QString& spoken)
{
    widget.setObjectName(name);
    widget.setAccessibleName(spoken);
}

/// How much room a form in a scroll area needs.
[[nodiscard]] inline QSize contentSizeOf(const QScrollArea& area)
{
    const QWidget& content = *area.widget();
    content.layout()->invalidate(); // what rows inside of its parts have become, it hears of too late
    content.layout()->activate();
    return {content.minimumSizeHint().width(), content.sizeHint().height()};
}

} // namespace fumage::ui
