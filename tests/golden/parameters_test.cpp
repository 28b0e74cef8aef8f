// Tests that loop over the parameter table: every parameter does something, and that and only that which its row says.

#include "tests/helpers.h"
#include "tests/parameter_rows.h"
#include "tests/parameter_stage.h"
#include "tests/pictures.h"

#include "core/effect/known_parameter.h"
#include "core/effect/value.h"
#include "core/rendering/scene_renderer.h"
#include "core/rendering/view_transform.h"
#include "core/simulation/air_plan.h"
#include "core/simulation/air_cache.h"
#include "core/simulation/simulation_model.h"

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr int kFrame = 9; // of air too, which starts at rest

/// The same in air, whether the parameter is seen there or not, after a short life.
Effect inAirFor(const Parameter& p)
{
    Effect effect = stageFor(p);
    putInAir(effect);
    effect.timeline.prewarm = !effect.timeline.loop;
    effect.life.fadeRate = 0.2F;
    return effect;
}

bool isAboutParents(const Parameter& p)
{
    return &p == &knownParameter("emitter.inherit") || p.key.starts_with("emitter.parent_");
}

/// The effect as the first layer of a scene: alone, or born on another where the parameter is about that.
Scene sceneFor(const Parameter& p, const Effect& effect)
{
    Scene scene = effect;
    if (isAboutParents(p)) {
        scene.layers.push_back(Scene(stageFor(p)).layers.front());
        scene.layers.back().name = "parent";
        scene.layers.front().from = "parent";
    }
    return scene;
}

std::shared_ptr<const Frame> frameFor(const Parameter& p, const Effect& effect)
{
    return SceneSimulator(sampledLayers(sceneFor(p, effect))).frame(kFrame).value().layers.front();
}

Image pictureFor(const Parameter& p, const Effect& effect)
{
    Image image;
    SceneRenderer renderer(sceneFor(p, effect));
    if (!renderer.render(kFrame, effect.output.width, effect.output.height, image)) {
        qFatal("no picture");
    }
    return image;
}

/// Whether particles are the same, and live the same lives.
bool isSameFrame(const Frame& a, const Frame& b)
{
    bool same = sameBits(a.particles, b.particles);
    for (std::size_t i = 0; same && i < a.particles.capacity; ++i) {
        same = lifecycle(a, i) == lifecycle(b, i);
    }
    return same;
}

bool isSameField(const AirField& a, const AirField& b)
{
    return a.grid.cell == b.grid.cell && a.grid.cells == b.grid.cells && a.grid.corner == b.grid.corner
        && a.wind == b.wind && a.share == b.share && sameBits(a.quads, b.quads) && a.earlier.size() == b.earlier.size()
        && std::equal(a.earlier.begin(), a.earlier.end(), b.earlier.begin(), isSameField);
}

/// The air of a frame, baked afresh: what is kept cannot hide that it would be another.
AirFieldPtr fieldOf(const Effect& effect)
{
    const SampledEffect whole = sampled(effect);
    return BakedAir(airPlan(whole)).field(frameOf(effect, kFrame)->step).value();
}

} // namespace

class ParametersTest : public QObject {
    Q_OBJECT

private slots:
    void noParameterIsDead_data() { addParameterRows(); }
    void noParameterIsDead()
    {
        QFETCH(QString, key);
        const Parameter& p = *findParameter(key.toStdString());
        Effect before = stageFor(p);
        Effect after = before;
        p.set(after, moved(p, before));
        QVERIFY(isVisible(p, before));
        QVERIFY(!differences(before, after).empty());
        const Image a = pictureFor(p, before);
        const Image b = pictureFor(p, after);
        EncodedImageOf first(a, before);
        EncodedImageOf second(b, after);
        QVERIFY2(first.bytes != second.bytes, "moving it changes no pixel");
    }

    void theFrameChangesWhereTheRowSaysSo_data() { addParameterRows(); }
    void theFrameChangesWhereTheRowSaysSo()
    {
        QFETCH(QString, key);
        const Parameter& p = *findParameter(key.toStdString());
        const Effect before = stageFor(p);
        Effect after = before;
        p.set(after, moved(p, before));
        QCOMPARE(isSameFrame(*frameFor(p, before), *frameFor(p, after)), p.dirties < DirtyStage::Simulate);
        QCOMPARE(before.noise == after.noise, p.dirties != DirtyStage::Noise);
    }

    void whatIsShadedNeedsNoNewFrame_data() { addParameterRows(); }
    void whatIsShadedNeedsNoNewFrame()
    {
        QFETCH(QString, key);
        const Parameter& p = *findParameter(key.toStdString());
        if (p.dirties >= DirtyStage::Simulate || p.group() == "output") {
            return;
        }
        const Effect before = stageFor(p);
        Effect after = before;
        p.set(after, moved(p, before));
        Renderer renderer;
        Image image;
        QVERIFY(
            renderer.render(*frameOf(before, kFrame), sampled(after), after.output.width, after.output.height, image)
                .ok());
        QVERIFY(sameBits(image.pixels, render(after, kFrame).pixels));
    }

    void theAirChangesWhereTheRowSaysSo_data() { addParameterRows(); }
    void theAirChangesWhereTheRowSaysSo()
    {
        QFETCH(QString, key);
        const Parameter& p = *findParameter(key.toStdString());
        if (&p == &knownParameter("air.enabled")) {
            return; // there is air, or there is none
        }
        const Effect before = inAirFor(p);
        Effect after = before;
        p.set(after, moved(p, before));
        QCOMPARE(isSameField(*fieldOf(before), *fieldOf(after)), p.dirties != DirtyStage::Air);
        AirCache shelf(2);
        QCOMPARE(shelf.airOf(sampled(before)) == shelf.airOf(sampled(after)), p.dirties != DirtyStage::Air);
    }

    void theRendererForgetsNothing()
    {
        // One renderer that sees one effect after the other gives the same pictures as a new one each time.
        Renderer kept;
        Image image;
        for (const Parameter& p : parameterTable()) {
            if (p.dirties >= DirtyStage::Simulate || p.group() == "output") {
                continue;
            }
            Effect effect = stageFor(p);
            p.set(effect, moved(p, effect));
            QVERIFY(
                kept.render(*frameOf(effect, kFrame), sampled(effect), effect.output.width, effect.output.height, image)
                    .ok());
            QVERIFY2(sameBits(image.pixels, render(effect, kFrame).pixels), p.key.data());
        }
    }

private:
    struct EncodedImageOf {
        RawArray<std::uint8_t> bytes;
        EncodedImageOf(const Image& image, const Effect& effect)
        {
            EncodedImage<std::uint8_t> encoded;
            encode(image, effect.output, encoded);
            bytes = std::move(encoded.pixels);
            bytes.push_back(static_cast<std::uint8_t>(image.width));
        }
    };
};

QTEST_GUILESS_MAIN(ParametersTest)
#include "parameters_test.moc"
