#pragma once

#include <QDoubleSpinBox>

namespace fumage::ui {

/// Shows as many decimals as its number has, and has room for all that it may have.
class DecimalBox : public QDoubleSpinBox {
public:
    using QDoubleSpinBox::QDoubleSpinBox;

    QString textFromValue(double value) const override
    {
        return locale().toString(value, 'f', QLocale::FloatingPointShortest);
    }
    QSize sizeHint() const override { return widened(QDoubleSpinBox::sizeHint()); }
    QSize minimumSizeHint() const override { return widened(QDoubleSpinBox::minimumSizeHint()); }

private:
    /// The hint of Qt knows the texts of the ends of the range alone.
    [[nodiscard]] QSize widened(const QSize& hint) const
    {
        return {hint.width() + (decimals() + 1) * fontMetrics().horizontalAdvance(u'0'), hint.height()};
    }
};

} // namespace fumage::ui
