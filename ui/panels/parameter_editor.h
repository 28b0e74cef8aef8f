#pragma once

#include "core/effect/parameter.h"

#include <QWidget>

class QMenu;

namespace fumage::ui {

class NumberField;

/// The widget that shows and changes one parameter; knows nothing of the document. Its objectName is the parameter's
/// key.
class ParameterEditor : public QWidget {
    Q_OBJECT

public:
    ParameterEditor(const Parameter& parameter, QWidget* parent);

    [[nodiscard]] const Parameter& parameter() const { return m_parameter; }

    /// Shows a value without telling anybody.
    virtual void setValue(const Value& value) = 0;
    /// What the menu of the parameter offers besides at a place on the screen.
    virtual void addActions(QMenu&, const QPoint& /*global*/) { }

signals:
    /// @param finished the gesture is over; edits up to the next finished one are one step
    void edited(const fumage::Value& value, bool finished);

protected:
    /// "key.part": names a child for tests and for those who cannot see it.
    void name(QWidget& part, const QString& suffix, const QString& spoken) const;
    /// A field for one component, named after it.
    [[nodiscard]] NumberField* addField(const QString& suffix, const QString& spoken);
    /// A line below that tells what the hand can do.
    [[nodiscard]] QWidget* makeHint(const QString& text);

private:
    const Parameter& m_parameter;
};

} // namespace fumage::ui
