#include "ui/viewport/gl_support.h"

#include <QByteArray>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>

#include <array>

namespace fumage::ui {

namespace {

bool isSoftware(const QByteArray& renderer)
{
    constexpr std::array<const char*, 4> kNames{"llvmpipe", "softpipe", "SwiftShader", "Software"};
    for (const char* name : kNames) {
        if (renderer.contains(name)) {
            return true;
        }
    }
    return false;
}

} // namespace

bool openGlIsWanted()
{
    return qEnvironmentVariableIsSet("FUMAGE_OPENGL");
}

GlSupport probeOpenGl()
{
    const QByteArray wish = qgetenv("FUMAGE_OPENGL");
    if (wish == "none") {
        return GlSupport::None;
    }
    QOpenGLContext context;
    QOffscreenSurface surface;
    surface.create();
    if (!context.create() || !surface.isValid() || !context.makeCurrent(&surface)) {
        return GlSupport::None;
    }
    constexpr auto kOldest = qMakePair(3, 3);
    const QByteArray renderer(reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER)));
    const bool recent = context.format().version() >= kOldest;
    context.doneCurrent();
    if (!recent) {
        return GlSupport::None;
    }
    if (wish == "software" || wish == "hardware") {
        return wish == "software" ? GlSupport::Software : GlSupport::Hardware;
    }
    return isSoftware(renderer) ? GlSupport::Software : GlSupport::Hardware;
}

} // namespace fumage::ui
