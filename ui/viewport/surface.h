#pragma once

#include "ui/preview/picture.h"
#include "ui/viewport/gl_support.h"

#include <QOpenGLWidget>

#include <functional>
#include <memory>

class QPainter;

namespace fumage::ui {

class GlSprites;

/// Draws what lies over the picture.
using OverlayPainter = std::function<void(QPainter&)>;

/// The area of the viewport that shows the picture: an OpenGL widget, or a plain one where there is no graphics card.
class Surface {
public:
    virtual ~Surface() = default;
    [[nodiscard]] virtual QWidget* widget() = 0;
    /// Whether it wants the sprites of a picture and draws them itself.
    [[nodiscard]] virtual bool drawsSprites() const = 0;
    virtual void show(const PicturePtr& picture) = 0;
};

/// @param preferOpenGl even where the processor has to play graphics card, which is slower than the plain widget
/// @param overlay called within each paint, with a painter in logical pixels
[[nodiscard]] std::unique_ptr<Surface> makeSurface(
    GlSupport support, bool preferOpenGl, QWidget* parent, OverlayPainter overlay);

} // namespace fumage::ui
