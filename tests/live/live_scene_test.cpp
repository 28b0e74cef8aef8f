// Smoke of several layers that steps with a game: the bits of its particles, and its light.
#include "tests/live/counted_heap.h"
#include "tests/live/live_scene_helpers.h"

#include "core/base/parallel.h"
#include "core/simulation/scene_simulator.h"

#include <array>

#include <glm/geometric.hpp>

using namespace fumage;
using namespace fumage::tests;

namespace {

/// The functions of a LiveSimulation, of a scene's first layer.
struct FirstLayer {
    LiveScene& scene;

    [[nodiscard]] EmitterPose emitter() const { return scene.emitter(0); }
    [[nodiscard]] Status setEmitter(const EmitterPose& pose) { return scene.setEmitter(0, pose); }
    [[nodiscard]] Status setEffect(const Effect& effect) { return scene.setEffect(0, effect); }
    void setShare(float share) { scene.setShare(0, share); }
};

/// The number of a layer of a name.
std::size_t numberOf(const LiveScene& live, const std::string& name)
{
    return findLayer(live.scene(), name).value();
}

} // namespace

class LiveSceneTest : public QObject {
    Q_OBJECT

private slots:
    void aSceneOfOneIsALiveSimulationToTheBit_data()
    {
        QTest::addColumn<Effect>("effect");
        QTest::newRow("no air") << windy(800);
        QTest::newRow("air") << inAir(800);
    }
    void aSceneOfOneIsALiveSimulationToTheBit()
    {
        QFETCH(Effect, effect);
        Result<LiveSimulation> alone = LiveSimulation::start(effect, {.mostParticles = 500});
        LiveScene scene = startedScene(effect, {.mostParticles = 500});
        FirstLayer first{scene};
        RestlessGame game(effect);
        RestlessGame same(effect);
        for (int step = 0; step < 150; ++step) {
            QVERIFY(game.act(alone.value(), step).ok() && same.act(first, step).ok());
            QCOMPARE(alone.value().step(kDt).value(), scene.step(kDt).value());
        }
        QVERIFY(sameBits(alone.value().particles(), scene.particles(0)));
        QCOMPARE(alone.value().living(), scene.living());
    }

    /// Without anybody who changes it each layer is that of the pictures: its own start and end, what feeds the air and
    /// what does not, what is carried, dragged and free, and what is born on another.
    void whatNobodyChangesIsTheSceneSimulatorToTheBit_data()
    {
        QTest::addColumn<bool>("air");
        QTest::addColumn<bool>("burst");
        QTest::newRow("no air") << false << false;
        QTest::newRow("air") << true << false;
        QTest::newRow("a burst in air") << true << true;
    }
    void whatNobodyChangesIsTheSceneSimulatorToTheBit()
    {
        QFETCH(bool, air);
        QFETCH(bool, burst);
        Scene scene = torch(air);
        if (burst) {
            scene.layers[0].emitter.mode = EmissionMode::Burst;
        }
        scene.timeline.stepsPerFrame = 2;
        SceneSimulator simulator(sampledLayers(scene));
        LiveScene live = startedScene(scene);
        for (const int number : {0, 1, 2, 3, 7, 20, 70}) {
            go(live, 2 * number + 1 - static_cast<int>(live.frame(0).step + 1));
            const SceneFrame frame = simulator.frame(number).value();
            for (std::size_t layer = 0; layer < live.layers(); ++layer) {
                QCOMPARE(live.frame(layer).step, frame.layers[layer]->step);
                QCOMPARE(live.frame(layer).number, number);
                QVERIFY2(sameBits(live.particles(layer), frame.layers[layer]->particles),
                    qPrintable(QStringLiteral("layer %1 in frame %2").arg(layer).arg(number)));
            }
        }
        QVERIFY(live.living(3) > 50);
    }

    void aMutedLayerChangesNoBitOfTheOthers()
    {
        const Scene all = torch();
        Scene some = all;
        some.layers[2].visible = false; // others are born on it
        some.layers.push_back(some.layers[1]);
        some.layers[4].name = "not there";
        some.layers[4].visible = false; // it would feed the air
        LiveScene live = startedScene(all);
        LiveScene muted = startedScene(some);
        go(live, 40);
        go(muted, 40);
        for (std::size_t layer = 0; layer < 4; ++layer) {
            QVERIFY(sameBits(live.particles(layer), muted.particles(layer)));
        }
        QCOMPARE(muted.particles(4).capacity, std::size_t{0});
        QCOMPARE(muted.share(4), 0.0F);
        QCOMPARE(muted.frames().size(), std::size_t{3});
        QVERIFY(muted.litColours(2).value().empty() && muted.normals(4).value().empty());
        QVERIFY(muted.appearance(4).radius.empty() && muted.ids(4).empty() && muted.colours(4).empty());
    }

    void whereNothingIsSeenNothingHappens()
    {
        Scene scene = torch();
        for (Layer& layer : scene.layers) {
            layer.visible = false;
        }
        LiveScene live = startedScene(scene, {.budgetMs = 1.0});
        QVERIFY(live.setEmitters(at(1.0F)).ok());
        go(live, 5);
        QCOMPARE(live.living(), std::size_t{0});
        QVERIFY(live.frames().empty() && live.litColours(0).value().empty());
    }

    void theOrderOfLayersMovesNoParticle()
    {
        const Scene scene = torch();
        LiveScene there = startedScene(scene, {.mostParticles = 1500});
        go(there, 40);
        const std::array<std::size_t, 4> order{3, 2, 0, 1};
        Scene moved = scene;
        for (std::size_t i = 0; i < order.size(); ++i) {
            moved.layers[i] = scene.layers[order[i]];
        }
        LiveScene here = startedScene(moved, {.mostParticles = 1500});
        go(here, 40);
        for (std::size_t i = 0; i < order.size(); ++i) {
            QVERIFY(sameBits(here.particles(i), there.particles(order[i])));
            const std::span<const glm::vec4> lit = here.litColours(i).value();
            const std::span<const glm::vec4> same = there.litColours(order[i]).value();
            for (std::size_t slot = 0; slot < lit.size(); ++slot) {
                QVERIFY(glm::distance(lit[slot], same[slot]) <= 1e-5F * (1.0F + glm::length(same[slot])));
            }
        }
    }

    void theSameCallsHaveTheSameBitsForAnyNumberOfThreads()
    {
        const auto run = [] {
            LiveScene live = startedScene(torch());
            for (int step = 0; step < 60; ++step) {
                const float way = 0.03F * static_cast<float>(step);
                [&] { QVERIFY(live.setEmitters({{way, 0.5F * way, 0.0F}, {way, 1.0F, 0.0F}, {1, 0, 0}}).ok()); }();
                live.setShare(1, step % 20 < 5 ? 0.3F : 1.0F);
                go(live, 1);
            }
            std::vector<Particles> out;
            for (std::size_t layer = 0; layer < live.layers(); ++layer) {
                out.push_back(live.particles(layer));
            }
            return out;
        };
        const std::vector<Particles> first = run();
        const ThreadLimit one(1);
        const std::vector<Particles> second = run();
        for (std::size_t layer = 0; layer < first.size(); ++layer) {
            QVERIFY(isFinite(first[layer]) && sameBits(first[layer], second[layer]));
        }
    }

    void stepsAllocateNothing()
    {
        Scene scene = torch();
        scene.layers[2].emitter.length = 0.0F;
        scene.layers[3].emitter.parentLifeTo = 0.9F;
        LiveScene live = startedScene(scene);
        [[maybe_unused]] constexpr int kSettled = 60;
        for (int step = 0; step < 300; ++step) {
            [[maybe_unused]] const std::size_t before = allocations();
            const float way = 0.02F * static_cast<float>(step);
            QVERIFY(live.setEmitters({{way, 0.0F, 0.5F * way}, {0.5F * way, 1.0F, 0.0F}, {}}).ok());
            QVERIFY(live.setEmitter(1, at(way, 0.1F)).ok());
            if (step % 9 == 0) {
                Effect effect = live.scene().effect(2);
                effect.emitter.count = 200 + step % 100;
                effect.wind.strength = 0.01F * static_cast<float>(step % 50);
                QVERIFY(live.setEffect(2, effect).ok());
            }
            QCOMPARE(live.step(live.stepSeconds()).value(), 1);
#ifndef FUMAGE_LOOPS_ALLOCATE
            if (step >= kSettled) {
                QCOMPARE(allocations(), before);
            }
#endif
        }
        QVERIFY(live.living(3) > 50);
    }

    void colourIsThatOfTheSpritesOfTheWholeScene()
    {
        LiveScene live = startedScene(torch());
        go(live, 60);
        const View view = makeView(live.scene().camera, 0.0F, 256, 256);
        Renderer renderer;
        QVERIFY(renderer.prepare(live.frames(), view).ok());
        for (std::size_t layer = 0; layer < live.layers(); ++layer) {
            const std::span<const glm::vec4> lit = live.litColours(layer, view.eye).value();
            const SpriteBatch& batch = renderer.batch(layer);
            std::size_t seen = 0;
            for (std::size_t i = 0; i < lit.size(); ++i) {
                if (batch.depth[i] == SpriteBatch::kHidden) {
                    continue;
                }
                ++seen;
                for (int channel = 0; channel < 3; ++channel) {
                    QCOMPARE(lit[i][channel], batch.sprites[i].direct[channel] + batch.sprites[i].ambient[channel]);
                }
                QCOMPARE(lit[i].a, live.colours(layer)[i].a);
            }
            QVERIFY(seen > 20);
        }
    }

    /// The box goes with the layer of least seed among those that feed the air, wherever that is in the list.
    void theAirGoesWithTheFirstThatFeedsIt()
    {
        Scene scene = torch();
        scene.layers[2].emitter.seed = 0; // of the embers, which do not feed it
        std::rotate(scene.layers.begin(), scene.layers.begin() + 1, scene.layers.end());
        LiveScene live = startedScene(scene);
        const std::size_t flames = numberOf(live, "flames");
        go(live, 10);
        for (int step = 0; step < 60; ++step) {
            QVERIFY(live.setEmitter(flames, at(0.2F * static_cast<float>(step))).ok());
            go(live, 1);
        }
        const Particles& p = live.particles(flames);
        std::size_t hot = 0;
        std::size_t newborn = 0;
        for (std::size_t i = 0; i < p.capacity; ++i) {
            const bool isNew = p.birthStep[i] != Particles::kUnborn && p.birthStep[i] > 65;
            newborn += isNew ? 1 : 0;
            hot += isNew && p.heat[i] > 0.05F ? 1 : 0; // without air there is no heat
        }
        QVERIFY(newborn > 10 && 2 * hot > newborn);
    }
};

QTEST_GUILESS_MAIN(LiveSceneTest)
#include "live_scene_test.moc"
