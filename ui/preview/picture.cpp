#include "ui/preview/picture.h"

#include <QRectF>

#include <algorithm>

namespace fumage::ui {

QRectF exportFrame(const Scene& scene, int width, int height)
{
    const double scale =
        std::min(static_cast<double>(width) / scene.output.width, static_cast<double>(height) / scene.output.height);
    const QSizeF size(scene.output.width * scale, scene.output.height * scale);
    return {QPointF((width - size.width()) / 2.0, (height - size.height()) / 2.0), size};
}

View windowView(const Scene& scene, int frame, int width, int height)
{
    const bool moves = !scene.tracks.empty(); // else nothing is copied: this is asked for at each move of the mouse
    View view =
        makeView(moves ? scene.atFrame(frame).camera : scene.camera, secondsOf(scene.timeline, frame), width, height);
    const QRectF inside = exportFrame(scene, width, height);
    const double shorter = std::min(inside.width(), inside.height());
    view.focal *= static_cast<float>(shorter / std::min(width, height));
    return view;
}

} // namespace fumage::ui
