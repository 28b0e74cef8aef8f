#include "ui/widgets/in_sight.h"

#include <QWidget>

namespace fumage::ui {

bool isInSight(const QWidget& widget)
{
    QRect left = widget.rect();
    for (const QWidget* part = &widget; !part->isWindow() && part->parentWidget() != nullptr;
         part = part->parentWidget()) {
        left = left.translated(part->pos()).intersected(part->parentWidget()->rect());
    }
    return widget.isVisible() && !left.isEmpty();
}

} // namespace fumage::ui
