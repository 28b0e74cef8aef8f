// The functions of the shared library that are about layers, as a program in C calls them.
#include "core/fumage.h"

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <QtTest/QtTest>

namespace {

using Smoke = std::unique_ptr<fumage_smoke, decltype(&fumage_destroy)>;

constexpr float kUp[3] = {0.0F, 1.0F, 0.0F};

/// A torch of four layers, of which the last is muted.
constexpr const char* kTorch = R"({"format": "fumage-preset", "version": 2, "name": "Torch",
    "scene": {"air": {"enabled": true, "resolution": 16}, "light": {"resolution": 16},
              "timeline": {"frame_rate": 60, "prewarm": false}},
    "layers": [
        {"name": "flames", "emitter": {"count": 600}, "glow": {"emission": 2}},
        {"name": "smoke", "emitter": {"count": 400, "seed": 2, "position": [0, 0.5, 0]}},
        {"name": "embers", "from": "flames", "emitter": {"count": 100, "seed": 3}, "motion": {"coupling": "dragged"}},
        {"name": "sparks", "visible": false, "emitter": {"count": 50, "seed": 4}}
    ]})";

Smoke torch(const char* const* settings = nullptr, int most = 0)
{
    const fumage_options options{60, most, 0, 0.0};
    return {fumage_create_from_json_with(kTorch, settings, &options), &fumage_destroy};
}

void go(const Smoke& smoke, int steps)
{
    for (int i = 0; i < steps; ++i) {
        QCOMPARE(fumage_step(smoke.get(), 1.0 / 60.0), 1);
    }
}

/// The mean height of the particles of a layer that are seen.
double heightOf(const Smoke& smoke, int layer)
{
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < fumage_layer_slots(smoke.get(), layer); ++i) {
        if (fumage_layer_radius(smoke.get(), layer)[i] > 0.0F) {
            sum += static_cast<double>(fumage_layer_y(smoke.get(), layer)[i]);
            count += 1.0;
        }
    }
    return count > 0.0 ? sum / count : -1e9;
}

bool hasError(const Smoke& smoke, const char* part)
{
    const char* const why = fumage_error(smoke.get());
    if (why == nullptr || !QByteArray(why).contains(part)) {
        qWarning("%s", why == nullptr ? "no error" : why);
        return false;
    }
    return true;
}

} // namespace

class CLayersTest : public QObject {
    Q_OBJECT

private slots:
    void layersHaveNumbersAndNames()
    {
        const Smoke smoke = torch();
        QVERIFY2(fumage_error(smoke.get()) == nullptr, fumage_error(smoke.get()));
        QCOMPARE(fumage_layers(smoke.get()), 4);
        QCOMPARE(QByteArray(fumage_layer_name(smoke.get(), 2)), QByteArray("embers"));
        QCOMPARE(fumage_find_layer(smoke.get(), "smoke"), 1);
        QCOMPARE(fumage_find_layer(smoke.get(), "Smoke"), 1); // but for capital letters
        QCOMPARE(fumage_find_layer(smoke.get(), "1"), 0); // as in keys: counted from 1
        QVERIFY(fumage_error(smoke.get()) == nullptr);
        QCOMPARE(fumage_find_layer(smoke.get(), "mist"), -1);
        QVERIFY(hasError(smoke, "embers"));
    }

    void theFunctionsWithoutALayerAreThoseOfTheFirst()
    {
        const Smoke smoke = torch();
        go(smoke, 60);
        fumage_smoke* const s = smoke.get();
        QCOMPARE(fumage_slots(s), fumage_layer_slots(s, 0));
        QCOMPARE(fumage_living(s), fumage_layer_living(s, 0));
        QCOMPARE(fumage_share(s), fumage_layer_share(s, 0));
        QVERIFY(fumage_x(s) == fumage_layer_x(s, 0) && fumage_y(s) == fumage_layer_y(s, 0)
            && fumage_z(s) == fumage_layer_z(s, 0) && fumage_radius(s) == fumage_layer_radius(s, 0)
            && fumage_colour(s) == fumage_layer_colour(s, 0) && fumage_age(s) == fumage_layer_age(s, 0)
            && fumage_life(s) == fumage_layer_life(s, 0) && fumage_id(s) == fumage_layer_id(s, 0)
            && fumage_velocity_x(s) == fumage_layer_velocity_x(s, 0)
            && fumage_velocity_y(s) == fumage_layer_velocity_y(s, 0)
            && fumage_velocity_z(s) == fumage_layer_velocity_z(s, 0)
            && fumage_lit_colour(s, nullptr) == fumage_layer_lit_colour(s, 0, nullptr)
            && fumage_normal(s) == fumage_layer_normal(s, 0));
    }

    void eachLayerHasItsOwnColumns()
    {
        const Smoke smoke = torch();
        go(smoke, 60);
        for (int layer = 0; layer < 3; ++layer) {
            std::size_t living = 0;
            const float eye[3] = {0.0F, 1.0F, 6.0F};
            const float* const lit = fumage_layer_lit_colour(smoke.get(), layer, eye);
            QVERIFY2(lit != nullptr, fumage_error(smoke.get()));
            for (std::size_t i = 0; i < fumage_layer_slots(smoke.get(), layer); ++i) {
                living += fumage_layer_id(smoke.get(), layer)[i] != FUMAGE_NOBODY ? 1 : 0;
                QVERIFY(std::isfinite(lit[4 * i] + fumage_layer_x(smoke.get(), layer)[i]));
                QCOMPARE(lit[4 * i + 3], fumage_layer_colour(smoke.get(), layer)[4 * i + 3]);
            }
            QCOMPARE(living, fumage_layer_living(smoke.get(), layer));
            QVERIFY(living > 10);
        }
        QVERIFY(fumage_layer_x(smoke.get(), 0) != fumage_layer_x(smoke.get(), 1));
    }

    void aMutedLayerHasNoSlots()
    {
        const Smoke smoke = torch();
        go(smoke, 10);
        QCOMPARE(fumage_layer_slots(smoke.get(), 3), std::size_t{0});
        QCOMPARE(fumage_layer_living(smoke.get(), 3), std::size_t{0});
        QVERIFY(fumage_layer_x(smoke.get(), 3) == nullptr && fumage_layer_id(smoke.get(), 3) == nullptr
            && fumage_layer_colour(smoke.get(), 3) == nullptr
            && fumage_layer_lit_colour(smoke.get(), 3, nullptr) == nullptr
            && fumage_layer_normal(smoke.get(), 3) == nullptr);
        QVERIFY(fumage_error(smoke.get()) == nullptr); // that is no fault
    }

    void emittersMoveTogetherOrAlone()
    {
        const Smoke smoke = torch();
        const float place[3] = {0.0F, 20.0F, 0.0F};
        QCOMPARE(fumage_place_emitter(smoke.get(), place, kUp, nullptr), 0); // all of the torch
        go(smoke, 20);
        for (int layer = 0; layer < 3; ++layer) {
            QVERIFY(heightOf(smoke, layer) > 19.0);
        }
        const float high[3] = {0.0F, 100.0F, 0.0F};
        QCOMPARE(fumage_place_layer_emitter(smoke.get(), 1, high, nullptr, nullptr), 0);
        QCOMPARE(fumage_set_layer_emitter(smoke.get(), 1, high, kUp, kUp), 0);
        go(smoke, 20);
        QVERIFY(heightOf(smoke, 0) < 30.0);
        QVERIFY(heightOf(smoke, 1) > 30.0);
        const float none[3] = {};
        QCOMPARE(fumage_set_layer_emitter(smoke.get(), 1, high, none, nullptr), -1);
        QVERIFY(hasError(smoke, "normal"));
    }

    void keysNameALayer()
    {
        const char* const settings[] = {"smoke/emitter.count=200", "3/from=smoke", "wind.strength=0.5", nullptr};
        const Smoke smoke = torch(settings);
        QVERIFY2(fumage_error(smoke.get()) == nullptr, fumage_error(smoke.get()));
        QVERIFY(fumage_layer_slots(smoke.get(), 1) < 300);
        QCOMPARE(fumage_set(smoke.get(), "smoke/motion.drag", "2"), 0);
        QCOMPARE(fumage_set(smoke.get(), "2/motion.drag", "1e30"), 1);
        QCOMPARE(fumage_set(smoke.get(), "mist/motion.drag", "2"), -1);
        QVERIFY(hasError(smoke, "flames"));
        QCOMPARE(fumage_set(smoke.get(), "smoke/motion.drug", "2"), -1);
        QVERIFY(hasError(smoke, "motion.drag"));
        QCOMPARE(fumage_set(smoke.get(), "embers/from", "flames"), -1); // it has begun
        QVERIFY(hasError(smoke, "fixed"));
        QCOMPARE(fumage_set(smoke.get(), "/", nullptr), -1);
        go(smoke, 1);
        const char* const wrong[] = {"mist/emitter.count=200", nullptr};
        QVERIFY(hasError(torch(wrong), "flames"));
        const char* const ring[] = {"flames/from=embers", nullptr};
        QVERIFY(hasError(torch(ring), "born on itself"));
    }

    void aLayerGoesOutAndBurstsAlone()
    {
        const char* const settings[] = {"smoke/emitter.mode=burst", "smoke/emitter.burst_duration=0.1", nullptr};
        const Smoke smoke = torch(settings, 5000);
        QCOMPARE(fumage_set_layer_share(smoke.get(), 0, 0.0F), 0);
        QCOMPARE(fumage_layer_share(smoke.get(), 0), 0.0F);
        go(smoke, 20);
        QCOMPARE(fumage_layer_living(smoke.get(), 0), std::size_t{0});
        const std::size_t once = fumage_layer_living(smoke.get(), 1);
        QCOMPARE(once, std::size_t{400});
        QCOMPARE(fumage_burst_layer(smoke.get(), 0), 0); // whose share is still 0
        go(smoke, 20);
        QCOMPARE(fumage_layer_living(smoke.get(), 1), once);
        QCOMPARE(fumage_burst_layer(smoke.get(), 1), 0);
        go(smoke, 20);
        QCOMPARE(fumage_layer_living(smoke.get(), 1), 2 * once);
        QCOMPARE(fumage_layer_living(smoke.get(), 0), std::size_t{0});
    }

    void numbersThatNoLayerHasAreRefused_data()
    {
        QTest::addColumn<int>("layer");
        for (const int layer : {-1, 4, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()}) {
            QTest::newRow(std::to_string(layer).c_str()) << layer;
        }
    }
    void numbersThatNoLayerHasAreRefused()
    {
        QFETCH(int, layer);
        const Smoke smoke = torch();
        go(smoke, 1);
        fumage_smoke* const s = smoke.get();
        const auto refused = [&](bool result) {
            const bool isTold = result && hasError(smoke, "from 0 to 3");
            (void)fumage_step(s, 0.0); // takes the error away
            return isTold && fumage_error(s) == nullptr;
        };
        QVERIFY(refused(fumage_layer_name(s, layer) == nullptr));
        QVERIFY(refused(fumage_layer_slots(s, layer) == 0));
        QVERIFY(refused(fumage_layer_living(s, layer) == 0));
        QVERIFY(refused(fumage_set_layer_emitter(s, layer, kUp, kUp, kUp) == -1));
        QVERIFY(refused(fumage_place_layer_emitter(s, layer, kUp, kUp, kUp) == -1));
        QVERIFY(refused(fumage_set_layer_share(s, layer, 1.0F) == -1));
        QVERIFY(refused(fumage_layer_share(s, layer) == 0.0F));
        QVERIFY(refused(fumage_burst_layer(s, layer) == -1));
        QVERIFY(refused(fumage_layer_lit_colour(s, layer, nullptr) == nullptr));
        QVERIFY(refused(fumage_layer_normal(s, layer) == nullptr));
        QVERIFY(refused(fumage_layer_id(s, layer) == nullptr));
        for (const auto column : {&fumage_layer_x, &fumage_layer_y, &fumage_layer_z, &fumage_layer_radius,
                 &fumage_layer_colour, &fumage_layer_age, &fumage_layer_life, &fumage_layer_velocity_x,
                 &fumage_layer_velocity_y, &fumage_layer_velocity_z}) {
            QVERIFY(refused(column(s, layer) == nullptr));
        }
    }

    void nobodyAndNothingAreNoCrash()
    {
        const Smoke smoke = torch();
        QCOMPARE(fumage_find_layer(smoke.get(), nullptr), -1);
        QVERIFY(hasError(smoke, "flames"));
        QCOMPARE(fumage_set_layer_emitter(smoke.get(), 0, nullptr, nullptr, nullptr), 0);
        const Smoke unstarted(fumage_create_from_name("no such smoke", nullptr), &fumage_destroy);
        const QByteArray why = fumage_error(unstarted.get());
        for (fumage_smoke* const s : {unstarted.get(), static_cast<fumage_smoke*>(nullptr)}) {
            QCOMPARE(fumage_layers(s), 0);
            QVERIFY(fumage_layer_name(s, 0) == nullptr && fumage_find_layer(s, "flames") == -1);
            QVERIFY(fumage_set_layer_emitter(s, 0, kUp, kUp, kUp) == -1 && fumage_set_layer_share(s, 0, 1.0F) == -1
                && fumage_place_layer_emitter(s, 0, kUp, kUp, kUp) == -1 && fumage_burst_layer(s, 0) == -1);
            QVERIFY(
                fumage_layer_share(s, 0) == 0.0F && fumage_layer_slots(s, 0) == 0 && fumage_layer_living(s, 0) == 0);
            QVERIFY(fumage_layer_x(s, 0) == nullptr && fumage_layer_id(s, 0) == nullptr
                && fumage_layer_lit_colour(s, 0, kUp) == nullptr && fumage_layer_normal(s, 0) == nullptr);
        }
        QCOMPARE(QByteArray(fumage_error(unstarted.get())), why); // and why it has not started is still known
    }
};

QTEST_GUILESS_MAIN(CLayersTest)
#include "c_layers_test.moc"
