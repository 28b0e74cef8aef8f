#pragma once

#include "core/rendering/scene_renderer.h"

#include <QtTest/QtTest>

namespace fumage::tests {

/// A frame of a scene in its own size.
inline Image pictureOf(const Scene& scene, int number)
{
    SceneRenderer renderer(scene);
    Image image;
    const Status status = renderer.render(number, scene.output.width, scene.output.height, image);
    if (!status) {
        qFatal("%s", status.error().text().c_str());
    }
    return image;
}

} // namespace fumage::tests
