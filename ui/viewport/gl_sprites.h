#pragma once

#include "ui/preview/picture.h"

#include <QOpenGLBuffer>
#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLShaderProgram>
#include <QOpenGLVertexArrayObject>

#include <memory>
#include <utility>
#include <vector>

namespace fumage::ui {

/// Draws the sprites of a picture with OpenGL 3.3: one instanced quad a particle, far to near, into a half-float buffer
/// of linear light, then exposure, view transform and backdrop. The same formulas as the compositor, which is the
/// reference.
///
/// Made, used and destroyed with its context current.
class GlSprites : protected QOpenGLFunctions_3_3_Core {
public:
    GlSprites();
    ~GlSprites() override;
    GlSprites(const GlSprites&) = delete;
    GlSprites& operator=(const GlSprites&) = delete;

    /// @param picture with sprites
    /// @param pixels  of the target
    /// @param target  framebuffer that is drawn into; all of it is written
    void draw(const Picture& picture, const QSize& pixels, GLuint target);

    /// Empty where all is well; else what the driver said.
    [[nodiscard]] const QString& failure() const { return m_failure; }

private:
    void compile(QOpenGLShaderProgram& program, const QString& name);
    void upload(const SpriteBatchSnapshot& scene);
    void uploadTextures(const SpriteBatchSnapshot& scene);
    [[nodiscard]] GLuint makeTexture(const SpriteTexture& texture);
    [[nodiscard]] GLuint makeTexture(const SpritePicture& picture);
    void setStyles(const SpriteBatchSnapshot& scene);
    void pointAt(std::size_t first);
    void uploadDetail(const SpriteBatchSnapshot& scene);
    void makeBillows();
    void drawSprites(const SpriteBatchSnapshot& scene, const QSize& pixels);
    void resolve(const Picture& picture, const QSize& pixels, GLuint target);

    QString m_failure;
    QOpenGLShaderProgram m_spriteProgram;
    QOpenGLShaderProgram m_resolveProgram;
    QOpenGLVertexArrayObject m_vertices;
    QOpenGLVertexArrayObject m_nothing; ///< for the triangle that covers the screen, which needs no data
    QOpenGLBuffer m_instances{QOpenGLBuffer::VertexBuffer};
    QOpenGLBuffer m_details{QOpenGLBuffer::VertexBuffer}; ///< of the instances, where the smoke has any
    std::unique_ptr<QOpenGLFramebufferObject> m_light;
    QOpenGLBuffer m_layers{QOpenGLBuffer::VertexBuffer}; ///< of the instances
    std::vector<std::pair<SpriteSurface, GLuint>> m_surfaces; ///< of the last picture
    GLuint m_billows = 0; ///< 0: not needed yet
    std::shared_ptr<const SpriteBatchSnapshot> m_uploaded;
};

} // namespace fumage::ui
