#include "ui/viewport/surface.h"

#include "ui/viewport/gl_sprites.h"

#include <QOpenGLContext>
#include <QPainter>

namespace fumage::ui {

namespace {

void paintImage(QPainter& painter, const QImage& image, const QRect& area)
{
    if (image.isNull()) {
        painter.fillRect(area, QColor(24, 26, 30));
        return;
    }
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(area, image);
    painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
}

/// No OpenGL at all.
class PlainSurface : public QWidget, public Surface {
public:
    PlainSurface(QWidget* parent, OverlayPainter overlay)
        : QWidget(parent)
        , m_overlay(std::move(overlay))
    {
        setAttribute(Qt::WA_OpaquePaintEvent);
    }

    QWidget* widget() override { return this; }
    bool drawsSprites() const override { return false; }
    void show(const PicturePtr& picture) override
    {
        m_picture = picture;
        update();
    }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        paintImage(painter, m_picture ? m_picture->image : QImage(), rect());
        m_overlay(painter);
    }

private:
    OverlayPainter m_overlay;
    PicturePtr m_picture;
};

/// The compositor's picture as a texture, or on a graphics card the sprites themselves.
class GlSurface : public QOpenGLWidget, public Surface {
public:
    GlSurface(QWidget* parent, GlSupport support, OverlayPainter overlay)
        : QOpenGLWidget(parent)
        , m_hardware(support == GlSupport::Hardware)
        , m_overlay(std::move(overlay))
    {
        setUpdateBehavior(QOpenGLWidget::NoPartialUpdate);
    }
    ~GlSurface() override
    {
        makeCurrent();
        m_sprites.reset();
        doneCurrent();
    }
    Q_DISABLE_COPY_MOVE(GlSurface)

    QWidget* widget() override { return this; }
    bool drawsSprites() const override { return m_hardware; }
    void show(const PicturePtr& picture) override
    {
        m_picture = picture;
        update();
    }

protected:
    void initializeGL() override
    {
        // Moving to another window brings another context; what the old one held is gone with it.
        connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] {
            makeCurrent();
            m_sprites.reset();
            doneCurrent();
        });
    }

    void paintGL() override
    {
        if (m_picture && m_picture->sprites) {
            if (!m_sprites) {
                m_sprites = std::make_unique<GlSprites>();
            }
            const QSize pixels = size() * devicePixelRatioF();
            m_sprites->draw(*m_picture, pixels, defaultFramebufferObject());
        }
        QPainter painter(this);
        if (!m_picture || !m_picture->sprites) {
            paintImage(painter, m_picture ? m_picture->image : QImage(), rect());
        }
        m_overlay(painter);
    }

private:
    bool m_hardware;
    OverlayPainter m_overlay;
    PicturePtr m_picture;
    std::unique_ptr<GlSprites> m_sprites;
};

} // namespace

std::unique_ptr<Surface> makeSurface(GlSupport support, bool preferOpenGl, QWidget* parent, OverlayPainter overlay)
{
    // A processor that plays graphics card draws the whole window anew for every frame: 23 frames/s where the plain
    // widget has 30.
    if (support == GlSupport::None || (support == GlSupport::Software && !preferOpenGl)) {
        return std::make_unique<PlainSurface>(parent, std::move(overlay));
    }
    return std::make_unique<GlSurface>(parent, support, std::move(overlay));
}

} // namespace fumage::ui
