// The sprites that OpenGL draws, held against the compositor's picture.
#include "editor_helpers.h"

#include "ui/viewport/gl_sprites.h"
#include "ui/viewport/viewport.h"

#include "tests/pictures.h"

#include "core/preset/library.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions>

#include <cmath>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr int kEdge = 320;
constexpr double kMinPsnr = 40.0; // dB; what a person cannot tell apart side by side

double psnr(const QImage& a, const QImage& b)
{
    double squares = 0.0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y);
            const QRgb q = b.pixel(x, y);
            for (const int difference : {qRed(p) - qRed(q), qGreen(p) - qGreen(q), qBlue(p) - qBlue(q)}) {
                squares += difference * difference;
            }
        }
    }
    const double mean = squares / (3.0 * a.width() * a.height());
    return mean == 0.0 ? 99.0 : 10.0 * std::log10(255.0 * 255.0 / mean);
}

} // namespace

class GlSpritesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        m_surface.create();
        QVERIFY(m_context.create());
        QVERIFY(m_context.makeCurrent(&m_surface));
        m_sprites = std::make_unique<GlSprites>();
        QVERIFY2(m_sprites->failure().isEmpty(), qPrintable(m_sprites->failure()));
        qInfo("%s", reinterpret_cast<const char*>(m_context.functions()->glGetString(GL_RENDERER)));
    }
    void cleanupTestCase()
    {
        QVERIFY(m_context.makeCurrent(&m_surface));
        m_sprites.reset();
        m_context.doneCurrent();
    }

    void openGlShowsWhatTheCompositorPaints_data()
    {
        QTest::addColumn<QString>("preset");
        QTest::addColumn<bool>("checker");
        QTest::addColumn<bool>("ownBackground");
        QTest::addColumn<bool>("detailed");
        for (const LibraryEntry& entry : builtinPresets()) {
            QTest::newRow(entry.id.c_str()) << toQString(entry.id) << false << false << false;
        }
        QTest::newRow("default on a checker, filmic, exposed") << u"default"_q << true << false << false;
        QTest::newRow("fire on white, filmic, exposed") << u"fire-ball"_q << true << true << false;
        QTest::newRow("mushroom cloud in detail") << u"mushroom-cloud"_q << false << false << true;
    }
    void openGlShowsWhatTheCompositorPaints()
    {
        QFETCH(QString, preset);
        QFETCH(bool, checker);
        QFETCH(bool, ownBackground);
        QFETCH(bool, detailed);
        Effect effect = loadPreset(preset.toStdString()).value().preset.scene.effect();
        constexpr int kMax = 30000; // llvmpipe has to draw them all
        effect.emitter.count = qMin(effect.emitter.count, kMax);
        if (detailed) {
            effect.look.detail = 1.2F;
        }
        if (checker) {
            effect.output.exposure = 0.7F;
            effect.output.viewTransform = ViewTransform::Filmic;
        }
        if (ownBackground) {
            effect.output.background = Background::Colour;
            effect.output.backgroundColour = glm::vec3(1.0F);
        }
        compare(preset, effect, checker ? Backdrop::Kind::Checker : Backdrop::Kind::Colour);
    }

    /// Layers of their own styles and noises, drawn by depth together.
    void theySeeLayersThroughOneAnother()
    {
        Effect effect = loadPreset("default").value().preset.scene.effect();
        effect.emitter.count = 4000;
        effect.air.resolution = kMinAirResolution;
        Scene scene = effect;
        effect.look.mask = MaskShape::Square;
        effect.look.texture = 0.9F;
        effect.look.detail = 0.0F;
        effect.look.relief = 0.6F;
        effect.look.colour = {0.8F, 0.3F, 0.1F};
        effect.noise.seed = 3;
        effect.noise.resolution = 32;
        effect.emitter.seed = 4;
        scene.layers.emplace_back();
        scene.assign(1, effect);
        effect.look.size *= 2.0F;
        effect.look.softness = 0.3F;
        effect.noise.seed = 9;
        effect.emitter.seed = 5;
        scene.layers.emplace_back();
        scene.assign(2, effect);
        compare(QStringLiteral("layers"), scene, Backdrop::Kind::Colour);
    }

    /// Particles that look like a picture, and others among them.
    void theyShowPicturesAsTheCompositorDoes()
    {
        Effect effect = loadPreset("default").value().preset.scene.effect();
        effect.emitter.count = 3000;
        effect.air.resolution = kMinAirResolution;
        Scene scene = effect;
        effect.emitter.count = 300;
        effect.emitter.seed = 4;
        effect.look.detail = 0.0F;
        effect.look.size *= 3.0F;
        effect.look.opacity *= 4.0F;
        effect.look.mask = MaskShape::Picture;
        for (const int width : {40, 300}) {
            effect.look.picture = pictureOf(width, 48, [width](int x, int y) {
                const bool isLeaf = std::abs(2 * x - width) * 48 < y * width;
                return std::array<std::uint8_t, 4>{static_cast<std::uint8_t>(4 * y), 200,
                    static_cast<std::uint8_t>(x * 255 / width), static_cast<std::uint8_t>(isLeaf ? 255 : 0)};
            });
            scene.layers.emplace_back();
            scene.assign(scene.layers.size() - 1, effect);
            effect.emitter.seed = 5;
        }
        compare(QStringLiteral("pictures"), scene, Backdrop::Kind::Colour);
    }

    void aViewportOnAGraphicsCardShowsThem()
    {
        Document document;
        Solo solo(document);
        Player player;
        Viewport viewport(document, solo, player, std::make_shared<AirCache>(), GlSupport::Hardware);
        Preset preset = loadPreset("chimney").value().preset;
        preset.scene.layers[0].emitter.count = 8000;
        preset.scene.air.resolution = kMinAirResolution;
        document.load(preset, {});
        for (const Overlay overlay : {Overlay::Grid, Overlay::Emitter, Overlay::Gizmos, Overlay::Readout}) {
            viewport.setOverlay(overlay, false);
        }
        viewport.resize(kEdge, kEdge);
        viewport.show();
        QVERIFY(QTest::qWaitForWindowExposed(&viewport));
        QTRY_VERIFY(viewport.isSettled());
        QVERIFY(viewport.picture()->sprites != nullptr);
        RenderRequest request;
        request.scene = std::make_shared<const Scene>(document.scene());
        request.width = kEdge;
        request.height = kEdge;
        request.backdrop = viewport.backdrop();
        const QImage reference = PreviewRenderer().make(request, {})->image;
        auto* surface = qobject_cast<QOpenGLWidget*>(viewport.surface());
        QVERIFY(psnr(reference, surface->grabFramebuffer().convertToFormat(QImage::Format_RGB32)) >= kMinPsnr);
    }

private:
    void compare(const QString& name, const Scene& scene, Backdrop::Kind backdrop)
    {
        RenderRequest request;
        request.scene = std::make_shared<const Scene>(scene);
        request.frame = qMin(45, scene.timeline.length - 1);
        request.width = kEdge;
        request.height = kEdge;
        request.backdrop.colour = {0.02F, 0.03F, 0.05F};
        request.backdrop.kind = backdrop;
        PreviewRenderer previewRenderer;
        const QImage reference = previewRenderer.make(request, {})->image;
        request.sprites = true;
        const PicturePtr picture = previewRenderer.make(request, {});
        QVERIFY(picture->image.isNull() && picture->sprites && !picture->sprites->sprites.empty());

        QVERIFY(m_context.makeCurrent(&m_surface));
        QOpenGLFramebufferObject target(kEdge, kEdge);
        m_sprites->draw(*picture, {kEdge, kEdge}, target.handle());
        const QImage drawn = target.toImage().convertToFormat(QImage::Format_RGB32);
        const double decibels = psnr(reference, drawn);
        if (decibels < kMinPsnr) {
            const QString stem = QStringLiteral(FUMAGE_GOLDEN_SEEN "/sprites_") + name;
            QVERIFY(QDir().mkpath(QStringLiteral(FUMAGE_GOLDEN_SEEN)));
            reference.save(stem + u".expected.png"_q);
            drawn.save(stem + u".png"_q);
        }
        QVERIFY2(decibels >= kMinPsnr,
            qPrintable(QStringLiteral("%1 dB; see %2").arg(decibels).arg(QStringLiteral(FUMAGE_GOLDEN_SEEN))));
        qInfo("%s: %.1f dB", qPrintable(name), decibels);
    }

    QOffscreenSurface m_surface;
    QOpenGLContext m_context;
    std::unique_ptr<GlSprites> m_sprites;
};

FUMAGE_TEST_MAIN(GlSpritesTest)
#include "gl_sprites_test.moc"
