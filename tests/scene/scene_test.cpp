#include "tests/helpers.h"
#include "tests/scene/scene_pictures.h"

#include "core/lighting/appearance.h"
#include "core/lighting/light_grid.h"
#include "core/preset/library.h"
#include "core/preset/preset_file.h"
#include "core/rendering/scene_renderer.h"
#include "core/scene/layer_assignment.h"
#include "core/simulation/air_plan.h"

#include <algorithm>

using namespace fumage;

namespace {

constexpr int kFrame = 12;

/// Smoke that rises in air, small enough for a test.
Effect smoke()
{
    Effect effect = tests::everythingOn();
    effect.air.enabled = true;
    effect.air.resolution = kMinAirResolution;
    effect.timeline.prewarm = false;
    effect.look.detail = 0.0F;
    return effect;
}

/// Smoke, embers that follow its air without feeding it, and a puff that comes later and feeds it.
Scene campfire()
{
    Scene scene = smoke();
    scene.layers[0].name = "smoke";
    Effect embers = smoke();
    embers.emitter.seed = 5;
    embers.emitter.count = 200;
    embers.source.feeds = false;
    embers.motion.drag = 3.0F;
    scene.layers.emplace_back();
    scene.assign(1, embers);
    scene.layers[1].name = "embers";
    Effect puff = smoke();
    puff.emitter.seed = 9;
    puff.emitter.position = {0.3F, 0.0F, 0.1F};
    puff.emitter.start = 0.1F;
    puff.emitter.length = 0.2F;
    scene.layers.emplace_back();
    scene.assign(2, puff);
    scene.layers[2].name = "puff";
    return scene;
}

SceneFrame frameOf(const Scene& scene, int number = kFrame)
{
    return SceneSimulator(sampledLayers(scene)).frame(number).value();
}

Image pictureOf(const Scene& scene, int number = kFrame)
{
    return tests::pictureOf(scene, number);
}

bool sameBits(const Image& a, const Image& b)
{
    return a.width == b.width && a.height == b.height && tests::sameBits(a.pixels, b.pixels);
}

std::string textOf(const Scene& scene)
{
    Preset preset;
    preset.scene = scene;
    return formatPreset(preset);
}

} // namespace

class SceneTest : public QObject {
    Q_OBJECT

private slots:
    void aSceneOfOneIsItsEffect_data()
    {
        QTest::addColumn<bool>("air");
        QTest::newRow("air") << true;
        QTest::newRow("none") << false;
    }
    void aSceneOfOneIsItsEffect()
    {
        QFETCH(bool, air);
        Effect effect = smoke();
        effect.air.enabled = air;
        QVERIFY(Scene(effect).effect() == effect);
        QVERIFY(sameBits(pictureOf(effect), tests::render(effect, kFrame)));
    }

    /// Adding, muting or moving a layer that does not feed the air changes no bit of the others.
    void layersDoNotKnowOfOneAnother()
    {
        const SceneFrame all = frameOf(campfire());
        Scene without = campfire();
        without.layers[1].visible = false;
        const SceneFrame muted = frameOf(without);
        QCOMPARE(muted.layers.size(), std::size_t{2});
        QVERIFY(tests::sameBits(all.layers[0]->particles, muted.layers[0]->particles));
        QVERIFY(tests::sameBits(all.layers[2]->particles, muted.layers[1]->particles));
        Scene moved = campfire();
        std::swap(moved.layers[1], moved.layers[2]);
        const SceneFrame other = frameOf(moved);
        QVERIFY(tests::sameBits(all.layers[1]->particles, other.layers[2]->particles));
        QVERIFY(tests::sameBits(all.layers[2]->particles, other.layers[1]->particles));
    }

    /// What feeds the air is felt by all that it carries; what does not, by none.
    void onlyWhatFeedsTheAirMovesIt()
    {
        Scene scene = campfire();
        const SceneFrame before = frameOf(scene);
        scene.layers[2].visible = false;
        const SceneFrame calm = frameOf(scene);
        QVERIFY(!tests::sameBits(before.layers[0]->particles, calm.layers[0]->particles));
        scene.layers[1].emitter.speed = 4.0F;
        QVERIFY(tests::sameBits(calm.layers[0]->particles, frameOf(scene).layers[0]->particles));
    }

    void aLayerThatIsNotSeenCastsNoShadow()
    {
        Scene scene = campfire();
        Scene alone = scene;
        alone.layers.resize(1);
        scene.layers[1].visible = scene.layers[2].visible = false;
        QVERIFY(sameBits(pictureOf(scene), pictureOf(alone)));
        scene.layers[0].visible = false;
        const Image nothing = pictureOf(scene);
        QVERIFY(std::all_of(nothing.pixels.begin(), nothing.pixels.end(), [](float value) { return value == 0.0F; }));
    }

    void anyFrameAloneIsThatWhichIsPlayed_data()
    {
        QTest::addColumn<bool>("loop");
        QTest::newRow("once") << false;
        QTest::newRow("loop") << true;
    }
    void anyFrameAloneIsThatWhichIsPlayed()
    {
        QFETCH(bool, loop);
        Scene scene = campfire();
        scene.timeline.loop = loop;
        scene.timeline.length = 20;
        SceneRenderer played(scene);
        Image image;
        for (int number = 0; number < 24; number += 6) {
            QVERIFY(played.render(number, scene.output.width, scene.output.height, image).ok());
            QVERIFY(sameBits(image, pictureOf(scene, number)));
        }
        if (loop) {
            QVERIFY(sameBits(pictureOf(scene, 20 + kFrame), pictureOf(scene, kFrame)));
        }
    }

    void whatStartsLateIsNotThereBefore()
    {
        Scene scene = campfire();
        scene.layers[2].emitter.start = 0.4F; // frame 12 at 30 a second
        const auto living = [&](int number) { return tests::livingCount(*frameOf(scene, number).layers[2]); };
        QCOMPARE(living(0), 0);
        QCOMPARE(living(11), 0);
        QVERIFY(living(13) > 0);
        // After its length nobody is born: the last particles were.
        const SceneFrame late = frameOf(scene, 40);
        const Particles& particles = late.layers[2]->particles;
        const std::int64_t last = 6 + 1; // steps of 0.2 s
        for (std::size_t i = 0; i < particles.capacity; ++i) {
            QVERIFY(particles.birthStep[i] <= last || !lifecycle(*late.layers[2], i).alive);
        }
    }

    /// A change of one layer does not simulate the others again.
    void layersThatAreTheSameAreKept()
    {
        Scene scene = campfire();
        const auto shelf = std::make_shared<AirCache>();
        SceneSimulator before(sampledLayers(scene), Simulator::kDefaultCheckpointBytes, shelf);
        const SceneFrame first = before.frame(kFrame).value();
        scene.layers[1].motion.drag = 1.0F;
        scene.layers[0].look.opacity = 0.5F; // of its look alone
        SceneSimulator after(sampledLayers(scene), Simulator::kDefaultCheckpointBytes, shelf);
        after.adopt(before);
        const SceneFrame second = after.frame(kFrame).value();
        QCOMPARE(second.layers[0].get(), first.layers[0].get());
        QCOMPARE(second.layers[2].get(), first.layers[2].get());
        QVERIFY(second.layers[1].get() != first.layers[1].get());
        QVERIFY(tests::sameBits(second.layers[1]->particles, frameOf(scene).layers[1]->particles));
    }

    /// Smoke is as dense however it is divided into layers.
    void divisionChangesNoDensity()
    {
        const Effect effect = smoke();
        const auto frame = tests::frameOf(effect, kFrame);
        Appearance whole;
        findAppearance(*frame, sampled(effect), lightAxes(effect.light.direction), whole);
        std::array<Appearance, 2> halves{whole, whole};
        for (std::size_t i = 0; i < whole.radius.size(); ++i) {
            halves[i % 3 == 0 ? 0 : 1].alpha[i] = 0.0F;
        }
        halves[0].count = whole.count / 2;
        halves[1].count = whole.count - halves[0].count;
        const LitLayer all{frame.get(), &effect, &whole, nullptr};
        const std::array<LitLayer, 2> parts{LitLayer{frame.get(), &effect, halves.data(), nullptr},
            LitLayer{frame.get(), &effect, &halves[1], nullptr}};
        LightWorkspace room;
        LightGrid one;
        LightGrid two;
        fillDensity({&all, 1}, effect.light, lightAxes(effect.light.direction), room, one);
        fillDensity(parts, effect.light, lightAxes(effect.light.direction), room, two);
        QVERIFY(tests::sameBits(one.density, two.density));
        QVERIFY(*std::max_element(one.density.begin(), one.density.end()) > 0.0F);
    }

    /// The order of layers in a list means nothing to their particles, in air that several feed.
    void orderMovesNoParticle()
    {
        const Scene scene = campfire();
        const SceneFrame there = frameOf(scene);
        for (const std::array<std::size_t, 3>& order :
            {std::array<std::size_t, 3>{2, 1, 0}, std::array<std::size_t, 3>{1, 2, 0}}) {
            Scene moved = scene;
            for (std::size_t i = 0; i < order.size(); ++i) {
                moved.layers[i] = scene.layers[order[i]];
            }
            const SceneFrame here = frameOf(moved);
            for (std::size_t i = 0; i < order.size(); ++i) {
                QVERIFY(tests::sameBits(here.layers[i]->particles, there.layers[order[i]]->particles));
            }
            QVERIFY(airParts(sampledLayers(moved)) == airParts(sampledLayers(scene))); // nor is it baked again
        }
    }

    /// A layer of which no particle lives yet is nothing to the light of the others, whatever its detail and its place.
    void whatHasNotBegunChangesNoPixel()
    {
        Scene scene = smoke();
        scene.layers[0].look.detail = 1.0F;
        for (const std::size_t late : {std::size_t{0}, std::size_t{1}}) {
            Scene both = scene;
            both.layers.resize(2, scene.layers[0]);
            both.layers[late].emitter.start = 5.0F;
            both.layers[late].emitter.seed = 7;
            both.layers[late].source.feeds = false;
            both.layers[late].look.detailSize *= 2.0F;
            for (const float place :
                {0.0F, 40.0F}) { // the empty slots lie at the origin, outside of the smoke or in it
                both.layers[0].emitter.position.x = place;
                both.layers[1].emitter.position.x = place;
                both.camera.target.x = place;
                Scene one = both;
                one.layers[late].visible = false;
                QVERIFY(sameBits(pictureOf(both), pictureOf(one)));
            }
        }
    }

    /// What layers have in common is found once: where their detail is, and how it lies in the density.
    void layersShareTheirDetail()
    {
        Scene scene = smoke();
        scene.layers[0].look.detail = 1.0F;
        scene.layers.resize(3, scene.layers[0]);
        scene.layers[1].emitter.seed = 7;
        scene.layers[1].emitter.start = 0.1F; // another clock, the same air
        scene.layers[2].look.detailLife *= 2.0F;
        const std::vector<SampledEffect> layers = sampledLayers(scene);
        const SceneFrame frame = frameOf(scene);
        Renderer renderer;
        Image image;
        QVERIFY(renderer.render(LayersAtFrame(frame, layers), 64, 64, image));
        QCOMPARE(renderer.detail(0)->phases, renderer.detail(1)->phases);
        QVERIFY(renderer.detail(0)->phases != renderer.detail(2)->phases);
        QVERIFY(shadowsAlike(*renderer.detail(0), *renderer.detail(1)));
        QVERIFY(!shadowsAlike(*renderer.detail(0), *renderer.detail(2)));
        for (std::size_t layer = 0; layer < layers.size(); ++layer) {
            AdvectedCoordinates alone;
            const Frame& of = *frame.layers[layer];
            QVERIFY(alone.moveTo(of.model, of.step, layers[layer]->look.detailLife, {}));
            for (std::size_t i = 0; i < 2; ++i) {
                const AdvectedPhase& shared = (*renderer.detail(layer)->phases)[i];
                QCOMPARE(shared.seed, alone.phases()[i].seed);
                QCOMPARE(shared.weight, alone.phases()[i].weight);
                QVERIFY(tests::sameBits(shared.map.quads, alone.phases()[i].map.quads));
            }
        }
        // A life that is changed for one leaves the other's where they were.
        std::vector<SampledEffect> changed = layers;
        scene.layers[0].look.detailLife *= 4.0F;
        changed[0] = sampled(scene.effect(0));
        const std::array<AdvectedPhase, 2>* before = renderer.detail(1)->phases;
        QVERIFY(renderer.render(LayersAtFrame(frame, changed), 64, 64, image));
        QCOMPARE(renderer.detail(1)->phases, before);
        QVERIFY(renderer.detail(0)->phases != before);
    }

    /// A transparent layer changes no pixel; one that is not lies in front or behind by its depth alone.
    void layersAreDrawnByDepth()
    {
        Scene scene = smoke();
        scene.layers.emplace_back(scene.layers[0]);
        scene.layers[1].look.opacity = 0.0F;
        scene.layers[1].source.feeds = false;
        Scene one = scene;
        one.layers.pop_back();
        QVERIFY(sameBits(pictureOf(scene), pictureOf(one)));
        scene.layers[1].look.opacity = 1.0F;
        scene.layers[1].look.colour = {0.9F, 0.1F, 0.1F};
        scene.layers[1].emitter.seed = 3;
        const Image mixed = pictureOf(scene);
        QVERIFY(!sameBits(mixed, pictureOf(one)));
        scene.wind.strength = 0.0F; // which goes by the first layer that feeds the air
        Scene swapped = scene;
        std::swap(swapped.layers[0], swapped.layers[1]);
        // Equal depths alone go by the order of layers.
        const Image there = pictureOf(scene);
        const Image back = pictureOf(swapped);
        std::size_t differing = 0;
        float most = 0.0F;
        for (std::size_t i = 0; i < there.pixels.size(); ++i) {
            const float difference = std::abs(there.pixels[i] - back.pixels[i]);
            differing += difference > 0.0F ? 1 : 0;
            most = std::max(most, difference);
        }
        QVERIFY2(most < 0.02F && differing < there.pixels.size() / 20,
            qPrintable(QStringLiteral("%1 of %2, up to %3").arg(differing).arg(there.pixels.size()).arg(most)));
    }

    void filesKeepAllLayers()
    {
        Scene scene = campfire();
        scene.layers[1].visible = false;
        scene.layers[1].locked = true;
        scene.layers[2].tag = ColourTag::Violet;
        scene.layers[2].name = "a \"name\" with å";
        const std::string text = textOf(scene);
        const Result<PresetReading> read = parsePreset(text);
        QVERIFY2(read.ok(), read ? "" : read.error().text().c_str());
        QVERIFY(read.value().warnings.empty());
        QVERIFY(read.value().preset.scene == scene);
        QCOMPARE(formatPreset(read.value().preset), text);
    }

    void unknownMembersStayWithTheirLayer()
    {
        std::string text = textOf(campfire());
        const std::size_t puff = text.find("\"puff\"");
        text.insert(text.find("\"emitter\": {", puff) + 12, "\"hue\": 7,");
        text.insert(puff - std::string("\"name\": ").size(), "\"mass\": [1],");
        const PresetReading read = parsePreset(text).value();
        QCOMPARE(read.warnings.size(), std::size_t{2});
        const std::string again = formatPreset(read.preset);
        const std::size_t there = again.find("\"puff\"");
        QVERIFY(again.find("\"hue\": 7") > there);
        QVERIFY(again.find("\"mass\": [1]") > there);
        QCOMPARE(formatPreset(parsePreset(again).value().preset), again);
    }

    void brokenLayersAreRefused_data()
    {
        QTest::addColumn<QByteArray>("layers");
        QTest::addColumn<int>("code");
        const auto row = [](const char* name, const QByteArray& layers, ErrorCode code) {
            QTest::newRow(name) << layers << static_cast<int>(code);
        };
        row("none", "[]", ErrorCode::OutOfRange);
        row("too many", "[" + QByteArray("{},").repeated(64) + "{}]", ErrorCode::OutOfRange);
        row("no list", "{}", ErrorCode::WrongType);
        row("a number", "[7]", ErrorCode::WrongType);
        row("name", R"([{"name": 7}])", ErrorCode::WrongType);
        row("long name", "[{\"name\": \"" + QByteArray("x").repeated(257) + "\"}]", ErrorCode::TooLarge);
        row("visible", R"([{"visible": "yes"}])", ErrorCode::WrongType);
        row("tag", R"([{"tag": "pink"}])", ErrorCode::WrongType);
        row("tag number", R"([{"tag": 1}])", ErrorCode::WrongType);
    }
    void brokenLayersAreRefused()
    {
        QFETCH(QByteArray, layers);
        QFETCH(int, code);
        const Result<PresetReading> read =
            parsePreset(R"({"format": "fumage-preset", "version": 2, "layers": )" + layers.toStdString() + "}", "file");
        QVERIFY(!read.ok());
        QCOMPARE(static_cast<int>(read.error().code), code);
        QVERIFY2(read.error().place.text().find("file") == 0, read.error().place.text().c_str());
    }

    void layersAreNamedInAssignments()
    {
        Scene scene = campfire();
        QVERIFY(applyToScene(scene, "embers/motion.drag=1.5").ok());
        QCOMPARE(scene.layers[1].motion.drag, 1.5F);
        QVERIFY(applyToScene(scene, "3/motion.drag=2.5").ok());
        QCOMPARE(scene.layers[2].motion.drag, 2.5F);
        QVERIFY(applyToScene(scene, "motion.drag=0.5").ok());
        QCOMPARE(scene.layers[0].motion.drag, 0.5F);
        QVERIFY(applyToScene(scene, "embers/wind.strength=3").ok());
        QCOMPARE(scene.wind.strength, 3.0F);
        QVERIFY(applyToScene(scene, "Embers/motion.drag=3.5").ok());
        QCOMPARE(scene.layers[1].motion.drag, 3.5F);
        scene.layers[2].name = "embers";
        for (const char* wrong : {"embers/motion.drag=1", "0/motion.drag=1", "4/motion.drag=1", "ash/motion.drag=1"}) {
            const Result<bool> result = applyToScene(scene, wrong);
            QVERIFY2(!result.ok() && result.error().code == ErrorCode::UnknownName, wrong);
        }
        QVERIFY(showOnly(scene, "2, smoke").ok());
        QVERIFY(scene.layers[0].visible && scene.layers[1].visible && !scene.layers[2].visible);
        QVERIFY(mute(scene, "smoke").ok());
        QVERIFY(!scene.layers[0].visible && scene.layers[1].visible);
        QVERIFY(!mute(scene, "smoke,ash").ok());
    }

    /// As it is written first, by number then, and else but for capital letters where that says which.
    void layersAreFoundWhateverTheirCapitalLetters()
    {
        Scene scene = campfire();
        scene.layers[0].name = "Embers";
        scene.layers[2].name = "2";
        QCOMPARE(layerNamed(scene, "embers").value(), std::size_t{1});
        QCOMPARE(layerNamed(scene, "Embers").value(), std::size_t{0});
        QCOMPARE(layerNamed(scene, "2").value(), std::size_t{2});
        const Result<std::size_t> either = layerNamed(scene, "EMBERS");
        QVERIFY(!either.ok());
        QCOMPARE(either.error().code, ErrorCode::UnknownName);
        for (const char* name : {"\"Embers\" (1)", "\"embers\" (2)"}) {
            QVERIFY2(either.error().text().find(name) != std::string::npos, either.error().text().c_str());
        }
        QVERIFY(!layerNamed(scene, "ember").ok());
        scene.layers[0].name = "Flames";
        QCOMPARE(layerNamed(scene, "EMBERS").value(), std::size_t{1});
        QVERIFY(showOnly(scene, "FLAMES").ok());
        QVERIFY(mute(scene, "flames").ok());
        QVERIFY(scene.visibleLayers().empty());
    }

    void listsOfLayersNameOne()
    {
        Scene scene = campfire();
        const Scene before = scene;
        for (const char* nothing : {"", " ", ","}) {
            QVERIFY(!showOnly(scene, nothing).ok());
            QVERIFY(!mute(scene, nothing).ok());
        }
        QVERIFY(scene == before);
        scene.layers[1].name.clear(); // and nothing is not its name
        QVERIFY(!mute(scene, "").ok());
    }

    /// As many particles in all as one effect may have.
    void particlesAreBoundedInAll()
    {
        Scene scene;
        scene.layers.resize(kMaxLayers);
        for (Layer& layer : scene.layers) {
            layer.emitter.count = 1'000'000;
        }
        const std::int64_t sum = particlesOf(sampledLayers(scene));
        QVERIFY(sum <= kMaxParticles && sum > kMaxParticles * 9 / 10);
    }

    /// Each layer gives up the same share, and none all.
    void thinLayersKeepTheirShares()
    {
        Scene scene;
        scene.layers.resize(3);
        scene.layers[0].emitter.count = 6000;
        scene.layers[1].emitter.count = 3000;
        scene.layers[2].emitter.count = 1;
        const std::vector<SampledEffect> whole = sampledLayers(scene);
        std::vector<SampledEffect> layers = whole;
        thinLayers(layers, 9001);
        QCOMPARE(layers, whole);
        thinLayers(layers, 3001);
        QCOMPARE(layers[0]->emitter.count, 6000 * 3001 / 9001);
        QCOMPARE(layers[1]->emitter.count, 3000 * 3001 / 9001);
        QCOMPARE(layers[2]->emitter.count, 1);
    }
};

QTEST_GUILESS_MAIN(SceneTest)
#include "scene_test.moc"
