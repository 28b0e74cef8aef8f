#include "ui/preview/picture.h"

#include <QRectF>

#include <algorithm>

namespace fumage::ui {

QRectF exportFrame(const Effect& effect, int width, int height)
{
    const double scale =
        std::min(static_cast<double>(width) / effect.output.width, static_cast<double>(height) / effect.output.height);
    const QSizeF size(effect.output.width * scale, effect.output.height * scale);
    return {QPointF((width - size.width()) / 2.0, (height - size.height()) / 2.0), size};
}

View windowView(const Effect& effect, int frame, int width, int height)
{
    View view = makeView(effect.camera, secondsOf(effect.timeline, frame), width, height);
    const QRectF inside = exportFrame(effect, width, height);
    const double shorter = std::min(inside.width(), inside.height());
    view.focal *= static_cast<float>(shorter / std::min(width, height));
    return view;
}

} // namespace fumage::ui
