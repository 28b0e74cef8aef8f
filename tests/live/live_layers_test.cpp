// What a game does with the layers of its smoke: each by itself, or all together.
#include "tests/live/live_scene_helpers.h"

#include <limits>

#include <glm/geometric.hpp>

using namespace fumage;
using namespace fumage::tests;

namespace {

/// Where the particles of a layer are that live, without those that stand in the same place.
std::vector<float> placesOf(const LiveScene& live, std::size_t layer)
{
    std::vector<float> out;
    const Particles& particles = live.particles(layer);
    for (std::size_t i = 0; i < particles.capacity; ++i) {
        if (particles.birthStep[i] != Particles::kUnborn) {
            out.push_back(particles.x[i]);
        }
    }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

} // namespace

class LiveLayersTest : public QObject {
    Q_OBJECT

private slots:
    void eachLayerHasAnEmitterOfItsOwn()
    {
        Scene scene = standingPoint(600);
        addLayer(scene, "moved", 2);
        LiveScene live = startedScene(scene);
        QVERIFY(live.placeEmitter(1, at(5.0F)).ok());
        go(live, 10);
        QVERIFY(live.setEmitter(1, at(6.0F)).ok());
        QCOMPARE(live.step(4.0 * live.stepSeconds()).value(), 4);
        QCOMPARE(placesOf(live, 0), std::vector<float>{0.0F});
        const std::vector<float> places = placesOf(live, 1);
        QCOMPARE(places.front(), 5.0F);
        QVERIFY(places.back() > 5.75F && places.back() <= 6.0F && places.size() > 4); // along the way
        QCOMPARE(live.step(4.0 * live.stepSeconds()).value(), 4);
        const std::vector<float> arrived = placesOf(live, 1);
        QCOMPARE(arrived.back(), 6.0F);
        QVERIFY(arrived.size() <= places.size() + 1); // it does not go the way once more
        QVERIFY(!live.setEmitter(1, {glm::vec3(0.0F), glm::vec3(0.0F), glm::vec3(0.0F)}));
        QCOMPARE(live.emitter(1).position.x, 6.0F);
    }

    void emittersMoveAsOneBody()
    {
        Scene scene = standingPoint(600);
        scene.layers[0].emitter.position = {1.0F, 2.0F, 3.0F};
        addLayer(scene, "above", 2).emitter.position = {1.0F, 2.5F, 3.0F};
        addLayer(scene, "beside", 3).emitter.position = {1.0F, 2.0F, 4.0F};
        scene.layers[2].emitter.normal = {0.0F, 0.0F, 1.0F};
        LiveScene live = startedScene(scene);
        QVERIFY(live.setEmitters({{7.0F, 0.0F, 0.0F}, {2.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}}).ok());
        const auto isAt = [&](std::size_t layer, const glm::vec3& place, const glm::vec3& normal) {
            return glm::distance(live.emitter(layer).position, place) < 1e-6F
                && glm::distance(live.emitter(layer).normal, normal) < 1e-6F;
        };
        // From up to the right, about z: what was above is right of it, what lay along z stays.
        QVERIFY(isAt(0, {7.0F, 0.0F, 0.0F}, {1.0F, 0.0F, 0.0F}));
        QVERIFY(isAt(1, {7.5F, 0.0F, 0.0F}, {1.0F, 0.0F, 0.0F}));
        QVERIFY(isAt(2, {7.0F, 0.0F, 1.0F}, {0.0F, 0.0F, 1.0F}));
        QCOMPARE(live.emitter(2).velocity.y, 1.0F);
        // Upside down, and back: nothing has been added up on the way.
        QVERIFY(live.placeEmitters({{0.0F, 0.0F, 0.0F}, {0.0F, -1.0F, 0.0F}, {}}).ok());
        QVERIFY(isAt(1, {0.0F, -0.5F, 0.0F}, {0.0F, -1.0F, 0.0F}));
        QVERIFY(near(static_cast<double>(glm::length(live.emitter(2).position)), 1.0, 1e-6));
        QVERIFY(live.placeEmitters({{1.0F, 2.0F, 3.0F}, kUp, {}}).ok());
        for (std::size_t layer = 0; layer < 3; ++layer) {
            QCOMPARE(live.emitter(layer).position, scene.layers[layer].emitter.position);
            QCOMPARE(live.emitter(layer).normal, scene.layers[layer].emitter.normal);
        }
        const float nan = std::numeric_limits<float>::quiet_NaN();
        QVERIFY(!live.setEmitters(at(nan)));
        QCOMPARE(live.emitter(1).position, scene.layers[1].emitter.position);
    }

    void nothingIsLaidAlongTheWayOfEmittersThatAreElsewhere()
    {
        Scene scene = standingPoint(600);
        addLayer(scene, "other", 2);
        LiveScene live = startedScene(scene);
        go(live, 10);
        QVERIFY(live.placeEmitters(at(5.0F)).ok());
        QCOMPARE(live.step(4.0 * live.stepSeconds()).value(), 4);
        for (const std::size_t layer : {std::size_t{0}, std::size_t{1}}) {
            QCOMPARE(placesOf(live, layer), (std::vector<float>{0.0F, 5.0F}));
        }
    }

    /// They are born where the parent's particles are in the game, and on none that has died.
    void childrenAreBornOnTheParentsParticles()
    {
        Scene scene = standingPoint(600);
        scene.layers[0].name = "debris";
        scene.layers[0].life.fadeRate *= 10.0F; // half a second
        Layer& trail = addLayer(scene, "trail", 2);
        trail.from = "debris";
        trail.life.fadeRate *= 5.0F; // a second
        LiveScene live = startedScene(scene);
        go(live, 20);
        QVERIFY(live.placeEmitter(0, at(100.0F)).ok());
        QVERIFY(live.placeEmitter(1, at(-7.0F)).ok()); // not that it matters
        go(live, 20);
        QCOMPARE(placesOf(live, 1), (std::vector<float>{0.0F, 100.0F}));
        go(live, 100);
        QCOMPARE(placesOf(live, 1), std::vector<float>{100.0F});
        const std::size_t many = live.living(1);
        QVERIFY(many > 100);
        live.setShare(0, 0.0F);
        go(live, 100); // all debris has died, and what was born on it
        QCOMPARE(live.living(0), std::size_t{0});
        QCOMPARE(live.living(1), std::size_t{0});
        const std::span<const std::uint64_t> ids = live.ids(1);
        QVERIFY(std::all_of(ids.begin(), ids.end(), [](std::uint64_t id) { return id == LiveScene::kNobody; }));
        live.setShare(0, 1.0F);
        go(live, 100);
        QVERIFY(live.living(1) > many / 2);
    }

    void aShareIsOfALayerOrOfAll()
    {
        Scene scene = standingPoint(600);
        addLayer(scene, "other", 2);
        LiveScene live = startedScene(scene);
        LiveScene left = startedScene(scene);
        live.setShare(1, 0.5F);
        go(live, 120);
        go(left, 120);
        QVERIFY(sameBits(live.particles(0), left.particles(0)));
        QVERIFY(near(static_cast<double>(live.living(1)), 0.5 * static_cast<double>(left.living(1)), 1.0));
        live.setShare(0.5F);
        QCOMPARE(live.share(0), 0.5F);
        QCOMPARE(live.share(1), 0.25F);
        live.setShare(0.0F);
        go(live, 310);
        QCOMPARE(live.living(), std::size_t{0});
    }

    void placesAreDividedAndThinAllAlike()
    {
        Scene scene = standingPoint(2000);
        addLayer(scene, "half", 2).emitter.count = 1000;
        addLayer(scene, "few", 3).emitter.count = 10;
        for (const int most : {3, 50, 1000, 3009, 3010, 7000}) {
            LiveScene live = startedScene(scene, {.mostParticles = most});
            std::size_t sum = 0;
            for (std::size_t layer = 0; layer < 3; ++layer) {
                QVERIFY(live.particles(layer).capacity >= 1);
                sum += live.particles(layer).capacity;
                const double wanted = std::min(1.0, most / 3010.0);
                QVERIFY(near(static_cast<double>(live.share(layer)), wanted,
                    3.0 / scene.layers[layer].emitter.count)); // places are whole, and one is left
            }
            QVERIFY(sum <= static_cast<std::size_t>(most) && sum + 3 >= static_cast<std::size_t>(most));
            go(live, 320);
            QVERIFY(live.living() <= static_cast<std::size_t>(most));
        }
        const Result<LiveScene> none = LiveScene::start(scene, {.mostParticles = 2});
        QVERIFY(!none.ok() && none.error().code == ErrorCode::OutOfRange);
    }

    void aBudgetIsOfTheWholeScene()
    {
        Scene scene = standingPoint(2000);
        addLayer(scene, "other", 2).emitter.count = 1000;
        double now = 0.0;
        int ticks = 0;
        const LiveScene* scenery = nullptr;
        constexpr double kEach = 1e-6; // s
        const auto clock = [&] {
            const bool afterParticles = ++ticks % 3 == 0;
            now += afterParticles && scenery != nullptr ? kEach * static_cast<double>(scenery->living()) : 0.0;
            return now;
        };
        LiveScene live = startedScene(scene, {.budgetMs = 1.0, .clock = clock}); // for 1000 of 3000
        scenery = &live;
        go(live, 700);
        QCOMPARE(live.share(0), live.share(1));
        QVERIFY(live.share(0) < 0.4F && live.share(0) > 0.2F);
        QVERIFY2(live.living() <= 1000 && live.living() > 700, qPrintable(QString::number(live.living())));
        QVERIFY(near(static_cast<double>(live.living(0)), 2.0 * static_cast<double>(live.living(1)), 30.0));
    }

    void oneLayerShadowsAnother()
    {
        Scene scene = windy(3000);
        scene.layers[0].look.texture = 0.0F;
        scene.light.direction = {0.0F, -1.0F, 0.0F};
        scene.light.ambient = 0.0F;
        Layer& above = addLayer(scene, "above", 2);
        above.emitter.position.y = 6.0F;
        above.look.opacity = 20.0F;
        const auto brightness = [](LiveScene& live) {
            double sum = 0.0;
            const std::span<const glm::vec4> colours = live.litColours(0).value();
            for (const glm::vec4& colour : colours) {
                sum += static_cast<double>(colour.r);
            }
            return sum;
        };
        LiveScene shadowed = startedScene(scene);
        scene.layers[1].visible = false;
        LiveScene alone = startedScene(scene);
        go(shadowed, 90);
        go(alone, 90);
        QVERIFY(sameBits(shadowed.particles(0), alone.particles(0)));
        QVERIFY(brightness(shadowed) < 0.7 * brightness(alone));
    }

    void parametersAreSetInALayerOrInAll()
    {
        Scene scene = windy(500);
        addLayer(scene, "other", 2);
        LiveScene live = startedScene(scene);
        LiveScene left = startedScene(scene);
        go(live, 20);
        go(left, 20);
        Effect effect = live.scene().effect(1);
        effect.emitter.position.x = 9.0F;
        effect.emitter.speed = 3.0F;
        QVERIFY(live.setEffect(1, effect).ok());
        QCOMPARE(live.emitter(1).position.x, 9.0F);
        go(live, 20);
        go(left, 20);
        QVERIFY(sameBits(live.particles(0), left.particles(0)));
        QVERIFY(!sameBits(live.particles(1), left.particles(1)));
        effect.wind.strength = 20.0F; // of the surroundings
        QVERIFY(live.setEffect(1, effect).ok());
        QCOMPARE(live.scene().wind.strength, 20.0F);
        go(live, 20);
        go(left, 20);
        QVERIFY(!sameBits(live.particles(0), left.particles(0)));
    }

    void whatCannotChangeIsRefused()
    {
        const Scene scene = torch();
        LiveScene live = startedScene(scene);
        go(live, 3);
        const auto refuses = [&](const auto& change) {
            Scene other = scene;
            change(other);
            const Status status = live.setScene(other);
            return !status && status.error().code == ErrorCode::OutOfRange && live.scene() == scene;
        };
        QVERIFY(refuses([](Scene& other) { other.layers.pop_back(); }));
        QVERIFY(refuses([](Scene& other) { other.layers[1].visible = false; }));
        QVERIFY(refuses([](Scene& other) { other.layers[1].name = "mist"; }));
        QVERIFY(refuses([](Scene& other) { other.layers[3].from.clear(); }));
        QVERIFY(refuses([](Scene& other) { other.air.resolution *= 2; }));
        QVERIFY(refuses([](Scene& other) { other.timeline.stepsPerFrame = 3; }));
        Effect effect = scene.effect(2);
        effect.air.enabled = false;
        QVERIFY(!live.setEffect(2, effect));
        QVERIFY(live.setScene(scene).ok());
        Scene ring = scene;
        ring.layers[2].from = "sparks";
        QVERIFY(!LiveScene::start(ring));
        go(live, 1);
    }

    void whatBeginsLaterBeginsWhenItsTimeHasCome()
    {
        Scene scene = standingPoint(600);
        addLayer(scene, "later", 2).emitter.start = 0.5F; // 30 steps
        LiveScene live = startedScene(scene);
        QVERIFY(live.setEmitter(1, at(2.0F)).ok()); // nothing is born on the way
        go(live, 30);
        QCOMPARE(live.living(1), std::size_t{0});
        QCOMPARE(live.frame(1).step, std::int64_t{-1});
        go(live, 1);
        QCOMPARE(live.frame(1).step, std::int64_t{0});
        QVERIFY(live.living(1) > 0);
        QCOMPARE(placesOf(live, 1), std::vector<float>{2.0F});
        // A time that is set before it has come holds; afterwards it means nothing.
        LiveScene sooner = startedScene(scene);
        go(sooner, 10);
        Effect effect = scene.effect(1);
        effect.emitter.start = 0.0F;
        QVERIFY(sooner.setEffect(1, effect).ok());
        go(sooner, 1);
        QCOMPARE(sooner.frame(1).step, std::int64_t{0});
        effect.emitter.start = 3.0F;
        QVERIFY(sooner.setEffect(1, effect).ok());
        go(sooner, 5);
        QCOMPARE(sooner.frame(1).step, std::int64_t{5});
        QVERIFY(sooner.living(1) > 5);
    }

    void aBurstIsOfALayerOrOfAll()
    {
        Scene scene = standingPoint(100);
        scene.layers[0].emitter.mode = EmissionMode::Burst;
        scene.layers[0].emitter.burstDuration = 0.1F;
        addLayer(scene, "other", 2);
        LiveScene live = startedScene(scene, {.mostParticles = 1000});
        go(live, 20);
        live.burst(1);
        go(live, 20);
        QCOMPARE(live.living(0), std::size_t{100});
        QCOMPARE(live.living(1), std::size_t{200});
        live.burst();
        go(live, 20);
        QCOMPARE(live.living(), std::size_t{500});
    }
};

QTEST_GUILESS_MAIN(LiveLayersTest)
#include "live_layers_test.moc"
