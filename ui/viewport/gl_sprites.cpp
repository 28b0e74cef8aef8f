#include "ui/viewport/gl_sprites.h"

#include "core/rendering/view_transform.h"

#include <QCoreApplication>
#include <QVector2D>
#include <QVector3D>
#include <QVector4D>

#include <algorithm>
#include <cstddef>

namespace fumage::ui {

namespace {

/// A member of Sprite as an attribute of an instance.
struct Attribute {
    GLuint location;
    GLint floats;
    std::size_t offset;
};
constexpr Attribute kFloats[] = {
    {0, 4, offsetof(Sprite, x)},
    {1, 4, offsetof(Sprite, m00)},
    {2, 4, offsetof(Sprite, direct)},
    {3, 3, offsetof(Sprite, ambient)},
};
constexpr GLuint kPackedLocation = 4;
constexpr GLuint kDetailLocation = 5; ///< of the first of kDetailQuads
constexpr GLuint kDetailQuads = sizeof(SpriteDetail) / (4 * sizeof(GLuint));
constexpr GLuint kLayerLocation = kDetailLocation + kDetailQuads;

/// OpenGL takes an offset into a buffer as a pointer.
const void* asPointer(std::size_t offset)
{
    return reinterpret_cast<const void*>(offset); // NOLINT(performance-no-int-to-ptr)
}

} // namespace

GlSprites::GlSprites()
{
    initializeOpenGLFunctions();
    compile(m_spriteProgram, QStringLiteral("sprite"));
    compile(m_resolveProgram, QStringLiteral("resolve"));
    m_nothing.create();
    m_vertices.create();
    m_instances.create();
    m_instances.setUsagePattern(QOpenGLBuffer::StreamDraw);
    const QOpenGLVertexArrayObject::Binder binder(&m_vertices);
    for (const Attribute& attribute : kFloats) {
        glEnableVertexAttribArray(attribute.location);
        glVertexAttribDivisor(attribute.location, 1);
    }
    for (const GLuint location : {kPackedLocation, kLayerLocation}) {
        glEnableVertexAttribArray(location);
        glVertexAttribDivisor(location, 1);
    }
    for (GLuint quad = 0; quad < kDetailQuads; ++quad) {
        glVertexAttribDivisor(kDetailLocation + quad, 1);
    }
    m_details.create();
    m_details.setUsagePattern(QOpenGLBuffer::StreamDraw);
    m_layers.create();
    m_layers.setUsagePattern(QOpenGLBuffer::StreamDraw);
    pointAt(0);
}

GlSprites::~GlSprites()
{
    for (const auto& [of, texture] : m_surfaces) {
        glDeleteTextures(1, &texture);
    }
    glDeleteTextures(1, &m_billows);
}

void GlSprites::compile(QOpenGLShaderProgram& program, const QString& name)
{
    const bool linked =
        program.addShaderFromSourceFile(QOpenGLShader::Vertex, QStringLiteral(":/shaders/%1.vert").arg(name))
        && program.addShaderFromSourceFile(QOpenGLShader::Fragment, QStringLiteral(":/shaders/%1.frag").arg(name))
        && program.link();
    if (!linked) {
        m_failure = QCoreApplication::translate("GlSprites", "The graphics driver refuses the shader %1: %2")
                        .arg(name, program.log());
    }
}

GLuint GlSprites::makeTexture(const SpritePicture& picture)
{
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, picture.levels() - 1);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    for (int level = 0; level < picture.levels(); ++level) {
        const int edge = picture.levelSize(level);
        glTexImage2D(GL_TEXTURE_2D, level, GL_RGBA16F, edge, edge, 0, GL_RGBA, GL_FLOAT, picture.texels(level));
    }
    glBindTexture(GL_TEXTURE_2D, 0);
    return texture;
}

GLuint GlSprites::makeTexture(const SpriteTexture& texture)
{
    GLuint noise = 0;
    glGenTextures(1, &noise);
    glBindTexture(GL_TEXTURE_2D_ARRAY, noise);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, texture.levels() - 1);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (int level = 0; level < texture.levels(); ++level) {
        const int edge = texture.levelSize(level);
        const auto texels = static_cast<std::size_t>(edge) * static_cast<std::size_t>(edge);
        std::vector<std::uint8_t> greys(texels * static_cast<std::size_t>(texture.slices()));
        for (int slice = 0; slice < texture.slices(); ++slice) {
            const std::uint32_t* from = texture.texels(level, slice);
            for (std::size_t i = 0; i < texels; ++i) {
                greys[static_cast<std::size_t>(slice) * texels + i] = static_cast<std::uint8_t>(from[i] & 255U);
            }
        }
        glTexImage3D(
            GL_TEXTURE_2D_ARRAY, level, GL_R8, edge, edge, texture.slices(), 0, GL_RED, GL_UNSIGNED_BYTE, greys.data());
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
    return noise;
}

/// Those that are there already stay.
void GlSprites::uploadTextures(const SpriteBatchSnapshot& scene)
{
    std::vector<std::pair<SpriteSurface, GLuint>> before = std::exchange(m_surfaces, {});
    for (const SpriteSurface& wanted : scene.surfaces) {
        const auto here =
            std::find_if(before.begin(), before.end(), [&](const auto& each) { return each.first == wanted; });
        if (here != before.end()) {
            m_surfaces.push_back(std::move(*here));
            before.erase(here);
        } else {
            m_surfaces.emplace_back(
                wanted, wanted.picture != nullptr ? makeTexture(*wanted.picture) : makeTexture(*wanted.texture));
        }
    }
    for (const auto& [of, texture] : before) {
        glDeleteTextures(1, &texture);
    }
}

void GlSprites::makeBillows()
{
    const DetailTexture& texture = DetailTexture::instance();
    glGenTextures(1, &m_billows);
    glBindTexture(GL_TEXTURE_3D, m_billows);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAX_LEVEL, DetailTexture::kLevels - 1);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    for (int level = 0; level < DetailTexture::kLevels; ++level) {
        const int edge = DetailTexture::size(level);
        glTexImage3D(GL_TEXTURE_3D, DetailTexture::kLevels - 1 - level, GL_RGBA8_SNORM, edge, edge, edge, 0, GL_RGBA,
            GL_BYTE, texture.texelsInRows(level).data());
    }
    glBindTexture(GL_TEXTURE_3D, 0);
}

void GlSprites::uploadDetail(const SpriteBatchSnapshot& scene)
{
    const bool has = !scene.details.empty();
    const QOpenGLVertexArrayObject::Binder binder(&m_vertices);
    for (GLuint quad = 0; quad < kDetailQuads; ++quad) {
        if (has) {
            glEnableVertexAttribArray(kDetailLocation + quad);
        } else {
            glDisableVertexAttribArray(kDetailLocation + quad);
        }
    }
    if (!has) {
        return;
    }
    m_details.bind();
    m_details.allocate(scene.details.data(), static_cast<int>(scene.details.size() * sizeof(SpriteDetail)));
    m_details.release();
    if (m_billows == 0) {
        makeBillows();
    }
}

void GlSprites::upload(const SpriteBatchSnapshot& scene)
{
    m_instances.bind();
    m_instances.allocate(scene.sprites.data(), static_cast<int>(scene.sprites.size() * sizeof(Sprite)));
    m_instances.release();
    m_layers.bind();
    m_layers.allocate(scene.layers.data(), static_cast<int>(scene.layers.size() * sizeof(std::uint32_t)));
    m_layers.release();
    uploadDetail(scene);
    uploadTextures(scene);
}

void GlSprites::drawSprites(const SpriteBatchSnapshot& scene, const QSize& pixels)
{
    if (!m_light || m_light->size() != pixels) {
        m_light = std::make_unique<QOpenGLFramebufferObject>(
            pixels, QOpenGLFramebufferObject::NoAttachment, GL_TEXTURE_2D, GL_RGBA16F);
    }
    m_light->bind();
    glViewport(0, 0, pixels.width(), pixels.height());
    glClearColor(0.0F, 0.0F, 0.0F, 0.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_3D, m_billows);
    glActiveTexture(GL_TEXTURE0);
    m_spriteProgram.bind();
    m_spriteProgram.setUniformValue(
        "size", QVector2D(static_cast<float>(scene.view.width), static_cast<float>(scene.view.height)));
    m_spriteProgram.setUniformValue("noise", 0);
    m_spriteProgram.setUniformValue("billows", 1);
    m_spriteProgram.setUniformValue("picture", 2);
    m_spriteProgram.setUniformValue("hasDetail", !scene.details.empty());
    setStyles(scene);
    const QOpenGLVertexArrayObject::Binder binder(&m_vertices);
    for (const SpriteBatchSnapshot::Run& run : scene.runs) {
        const auto& [surface, texture] = m_surfaces[run.surface];
        glActiveTexture(surface.picture != nullptr ? GL_TEXTURE2 : GL_TEXTURE0);
        glBindTexture(surface.picture != nullptr ? GL_TEXTURE_2D : GL_TEXTURE_2D_ARRAY, texture);
        pointAt(run.first);
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(run.count));
    }
    m_spriteProgram.release();
    glDisable(GL_BLEND);
}

void GlSprites::setStyles(const SpriteBatchSnapshot& scene)
{
    std::vector<QVector4D> styles;
    for (const SpriteStyle& style : scene.styles) {
        styles.emplace_back(style.square ? 1.0F : 0.0F, style.hardness, style.texture, style.erosionSoftness);
        styles.emplace_back(style.textureScale, style.lightX, style.lightY, style.relief);
        styles.emplace_back(style.roundness, style.pictureReach, 0.0F, 0.0F);
    }
    m_spriteProgram.setUniformValueArray("styles", styles.data(), static_cast<int>(styles.size()));
}

/// Has instances counted from a sprite on.
void GlSprites::pointAt(std::size_t first)
{
    m_instances.bind();
    for (const Attribute& attribute : kFloats) {
        glVertexAttribPointer(attribute.location, attribute.floats, GL_FLOAT, GL_FALSE, sizeof(Sprite),
            asPointer(first * sizeof(Sprite) + attribute.offset));
    }
    glVertexAttribIPointer(kPackedLocation, 1, GL_UNSIGNED_INT, sizeof(Sprite),
        asPointer(first * sizeof(Sprite) + offsetof(Sprite, texture)));
    m_instances.release();
    m_details.bind();
    for (GLuint quad = 0; quad < kDetailQuads; ++quad) {
        glVertexAttribIPointer(kDetailLocation + quad, 4, GL_UNSIGNED_INT, sizeof(SpriteDetail),
            asPointer(first * sizeof(SpriteDetail) + static_cast<std::size_t>(quad) * 4 * sizeof(GLuint)));
    }
    m_details.release();
    m_layers.bind();
    glVertexAttribIPointer(
        kLayerLocation, 1, GL_UNSIGNED_INT, sizeof(std::uint32_t), asPointer(first * sizeof(std::uint32_t)));
    m_layers.release();
}

void GlSprites::resolve(const Picture& picture, const QSize& pixels, GLuint target)
{
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glViewport(0, 0, pixels.width(), pixels.height());
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, m_light->texture());
    const Output& output = picture.output;
    const bool own = output.background == Background::Colour;
    const glm::vec3 behind = own ? output.backgroundColour : picture.backdrop.colour;
    m_resolveProgram.bind();
    m_resolveProgram.setUniformValue("smoke", 0);
    m_resolveProgram.setUniformValue("background", QVector3D(behind.r, behind.g, behind.b));
    m_resolveProgram.setUniformValue("checker", !own && picture.backdrop.kind == Backdrop::Kind::Checker);
    m_resolveProgram.setUniformValue("gain", exposureGain(output.exposure));
    m_resolveProgram.setUniformValue("filmic", output.viewTransform == ViewTransform::Filmic);
    m_resolveProgram.setUniformValue("height", static_cast<float>(pixels.height()));
    const QOpenGLVertexArrayObject::Binder binder(&m_nothing);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    m_resolveProgram.release();
    glBindTexture(GL_TEXTURE_2D, 0);
}

void GlSprites::draw(const Picture& picture, const QSize& pixels, GLuint target)
{
    if (!m_failure.isEmpty()) {
        return;
    }
    if (picture.sprites != m_uploaded) {
        upload(*picture.sprites);
        m_uploaded = picture.sprites;
    }
    drawSprites(*picture.sprites, pixels);
    resolve(picture, pixels, target);
}

} // namespace fumage::ui
