#pragma once

#include <QBoxLayout>

#include <vector>

namespace fumage::ui {

/// Gives widgets of a layout the order of a list; what else is in it stays behind them.
template <class Widget>
void arrange(QBoxLayout& layout, const std::vector<Widget*>& order)
{
    for (std::size_t i = 0; i < order.size(); ++i) {
        const int place = static_cast<int>(i);
        if (layout.indexOf(order[i]) != place) {
            layout.removeWidget(order[i]);
            layout.insertWidget(place, order[i]);
        }
    }
}

} // namespace fumage::ui
