#include "core/fumage.h"

#include <cmath>
#include <cstring>
#include <memory>
#include <vector>

#include <QtTest/QtTest>

namespace {

using Smoke = std::unique_ptr<fumage_smoke, decltype(&fumage_destroy)>;

Smoke named(const char* name, const fumage_options* options = nullptr)
{
    return {fumage_create_from_name(name, options), &fumage_destroy};
}

} // namespace

/// The functions of the shared library, as a program in C calls them.
class CInterfaceTest : public QObject {
    Q_OBJECT

private slots:
    void itsArraysAreThoseOfTheLivingSmoke()
    {
        const fumage_options options{60, 5000, 0, 0.0};
        const Smoke smoke = named("thesis-2012", &options);
        QVERIFY2(fumage_error(smoke.get()) == nullptr, fumage_error(smoke.get()));
        for (int i = 0; i < 60; ++i) {
            QCOMPARE(fumage_step(smoke.get(), 1.0 / 60.0), 1);
        }
        QCOMPARE(fumage_slots(smoke.get()), std::size_t(5000));
        std::size_t seen = 0;
        const float* const radius = fumage_radius(smoke.get());
        const float* const colour = fumage_colour(smoke.get());
        for (std::size_t i = 0; i < fumage_slots(smoke.get()); ++i) {
            QVERIFY(std::isfinite(fumage_x(smoke.get())[i] + fumage_y(smoke.get())[i] + fumage_z(smoke.get())[i]));
            QCOMPARE(radius[i] > 0.0F, colour[4 * i + 3] > 0.0F);
            seen += radius[i] > 0.0F ? 1 : 0;
        }
        QVERIFY(seen > 0 && seen <= fumage_living(smoke.get()));
    }

    void parametersActAndAreToldWhereTheyWereClamped()
    {
        const Smoke smoke = named("thesis-2012");
        QCOMPARE(fumage_set(smoke.get(), "wind.strength", "0.5"), 0);
        QCOMPARE(fumage_set(smoke.get(), "wind.strength", "1e30"), 1);
        QCOMPARE(fumage_set(smoke.get(), "motion.wnd", "1"), -1);
        QVERIFY2(std::strstr(fumage_error(smoke.get()), "wind.strength") != nullptr, fumage_error(smoke.get()));
        QCOMPARE(fumage_set(smoke.get(), "wind.strength", "strong"), -1);
        QCOMPARE(fumage_set(smoke.get(), nullptr, nullptr), -1);
        QCOMPARE(fumage_set(smoke.get(), "timeline.frame_rate", "7"), -1);
        QVERIFY(fumage_error(smoke.get()) != nullptr);
        QCOMPARE(fumage_step(smoke.get(), 0.0), 0);
        QVERIFY(fumage_error(smoke.get()) == nullptr);
    }

    void theEmitterMovesAndIsSwitchedOff()
    {
        const Smoke smoke = named("thesis-2012");
        const float place[3] = {5.0F, 0.0F, 0.0F};
        const float normal[3] = {0.0F, 1.0F, 0.0F};
        const float none[3] = {};
        QCOMPARE(fumage_set_emitter(smoke.get(), place, normal, nullptr), 0);
        QCOMPARE(fumage_set_emitter(smoke.get(), place, none, nullptr), -1);
        QVERIFY(fumage_error(smoke.get()) != nullptr);
        QCOMPARE(fumage_place_emitter(smoke.get(), place, nullptr, nullptr), 0);
        fumage_set_share(smoke.get(), 0.0F);
        QVERIFY(fumage_step(smoke.get(), 0.1) > 0);
        QCOMPARE(fumage_living(smoke.get()), std::size_t(0));
        fumage_set_share(smoke.get(), 1.0F);
        QVERIFY(fumage_step(smoke.get(), 0.1) > 0);
        QVERIFY(fumage_living(smoke.get()) > 0);
        QVERIFY(fumage_x(smoke.get())[0] > 2.0F);
    }

    void whatIsFixedLaterCanBeSetBeforeItStarts()
    {
        const char* const settings[] = {"air.enabled=on", "air.resolution=16", "emitter.count=500", nullptr};
        const Smoke smoke(fumage_create_from_name_with("thesis-2012", settings, nullptr), &fumage_destroy);
        QVERIFY2(fumage_error(smoke.get()) == nullptr, fumage_error(smoke.get()));
        QVERIFY(fumage_slots(smoke.get()) < 600);
        QCOMPARE(fumage_set(smoke.get(), "air.resolution", "24"), -1); // it has begun
        QCOMPARE(QByteArray(fumage_error(smoke.get())).count("air.resolution"), 1);
        QCOMPARE(fumage_step(smoke.get(), 0.1) > 0, true);
        QCOMPARE(fumage_set(smoke.get(), "air.resolution", "16"), 0); // as it is
        const char* const wrong[] = {"air.resolutin=16", nullptr};
        const Smoke none(fumage_create_from_name_with("thesis-2012", wrong, nullptr), &fumage_destroy);
        QVERIFY2(QByteArray(fumage_error(none.get())).contains("air.resolution"), fumage_error(none.get()));
        QCOMPARE(fumage_step(none.get(), 0.1), -1);
        const Smoke plain(
            fumage_create_from_json_with("{\"format\":\"fumage-preset\",\"version\":1}", settings, nullptr),
            &fumage_destroy);
        QVERIFY2(fumage_error(plain.get()) == nullptr, fumage_error(plain.get()));
    }

    void itsColumnsAreOfTheSameParticles()
    {
        const fumage_options options{60, 2000, 0, 0.0};
        const Smoke smoke = named("thesis-2012", &options);
        QVERIFY(fumage_step(smoke.get(), 1.0 / 60.0) == 1);
        for (int i = 0; i < 30; ++i) {
            QCOMPARE(fumage_step(smoke.get(), 1.0 / 60.0), 1);
        }
        std::size_t living = 0;
        for (std::size_t i = 0; i < fumage_slots(smoke.get()); ++i) {
            const bool lives = fumage_id(smoke.get())[i] != FUMAGE_NOBODY;
            living += lives ? 1 : 0;
            QVERIFY(fumage_age(smoke.get())[i] >= 0.0F && fumage_age(smoke.get())[i] < 31.5F / 60.0F);
            QVERIFY(fumage_life(smoke.get())[i] >= 0.0F && fumage_life(smoke.get())[i] <= 1.0F);
            QVERIFY(std::isfinite(fumage_velocity_x(smoke.get())[i] + fumage_velocity_y(smoke.get())[i]
                + fumage_velocity_z(smoke.get())[i]));
            QVERIFY(lives || fumage_radius(smoke.get())[i] == 0.0F);
        }
        QCOMPARE(living, fumage_living(smoke.get()));
        QVERIFY(fumage_share(smoke.get()) > 0.0F && fumage_share(smoke.get()) <= 1.0F);
        QCOMPARE(fumage_is_over_budget(smoke.get()), 0);
    }

    void itsLightIsFoundWhenItIsAskedFor()
    {
        const char* const settings[] = {"light.resolution=16", "look.opacity=4", nullptr};
        const fumage_options options{60, 3000, 0, 0.0};
        const Smoke smoke(fumage_create_from_name_with("thesis-2012", settings, &options), &fumage_destroy);
        for (int i = 0; i < 60; ++i) {
            QCOMPARE(fumage_step(smoke.get(), 1.0 / 60.0), 1);
        }
        const float eye[3] = {0.0F, 1.0F, 6.0F};
        const float* const lit = fumage_lit_colour(smoke.get(), eye);
        QVERIFY2(lit != nullptr && fumage_error(smoke.get()) == nullptr, fumage_error(smoke.get()));
        const float* const normal = fumage_normal(smoke.get());
        const float* const plain = fumage_colour(smoke.get());
        QCOMPARE(fumage_lit_colour(smoke.get(), eye), lit);
        std::size_t seen = 0;
        for (std::size_t i = 0; i < fumage_slots(smoke.get()); ++i) {
            QCOMPARE(lit[4 * i + 3], plain[4 * i + 3]);
            const bool isSeen = fumage_radius(smoke.get())[i] > 0.0F;
            QCOMPARE(lit[4 * i] > 0.0F, isSeen);
            const float length = std::hypot(normal[3 * i], normal[3 * i + 1], normal[3 * i + 2]);
            QVERIFY(isSeen ? std::abs(length - 1.0F) < 1e-4F || length == 0.0F : length == 0.0F);
            seen += isSeen ? 1 : 0;
        }
        QVERIFY(seen > 100);
        const float nowhere[3] = {0.0F, std::nanf(""), 0.0F};
        QVERIFY(fumage_lit_colour(smoke.get(), nowhere) == nullptr && fumage_error(smoke.get()) != nullptr);
        QVERIFY(fumage_lit_colour(smoke.get(), nullptr) != nullptr && fumage_error(smoke.get()) == nullptr);
        QVERIFY(fumage_lit_colour(nullptr, eye) == nullptr && fumage_normal(nullptr) == nullptr);
    }

    void anyNumberOfThreadsGivesTheSameBits()
    {
        std::vector<float> places[2];
        for (const int threads : {1, 0}) {
            QCOMPARE(fumage_limit_threads(threads), 0);
            const Smoke smoke = named("thesis-2012");
            QVERIFY(fumage_step(smoke.get(), 0.1) > 0);
            places[threads].assign(fumage_x(smoke.get()), fumage_x(smoke.get()) + fumage_slots(smoke.get()));
        }
        QCOMPARE(places[0], places[1]);
        QCOMPARE(fumage_limit_threads(-1), -1);
    }

    void markersAreRead()
    {
        const char* const json = R"({"format": "fumage-preset", "version": 2,
            "scene": {"markers": [{"name": "Hit", "time": 1.25}, {"name": "Boom", "time": 0.5}]}})";
        const Smoke smoke(fumage_create_from_json(json, nullptr), &fumage_destroy);
        QVERIFY2(fumage_error(smoke.get()) == nullptr, fumage_error(smoke.get()));
        QCOMPARE(fumage_markers(smoke.get()), 2);
        QCOMPARE(QByteArray(fumage_marker_name(smoke.get(), 0)), QByteArray("Boom"));
        QCOMPARE(fumage_marker_seconds(smoke.get(), 0), 0.5);
        QCOMPARE(QByteArray(fumage_marker_name(smoke.get(), 1)), QByteArray("Hit"));
        QCOMPARE(fumage_marker_seconds(smoke.get(), 1), 1.25);
        for (const int none : {-1, 2}) {
            QVERIFY(fumage_marker_name(smoke.get(), none) == nullptr);
            QVERIFY(QByteArray(fumage_error(smoke.get())).contains("no marker number"));
            QCOMPARE(fumage_marker_seconds(smoke.get(), none), -1.0);
        }
        QCOMPARE(fumage_markers(nullptr), 0);
        QVERIFY(fumage_marker_name(nullptr, 0) == nullptr);
        QCOMPARE(fumage_marker_seconds(nullptr, 0), -1.0);
    }

    void anEndlessTimeIsNoEndOfTheSmoke()
    {
        const Smoke smoke = named("thesis-2012");
        QCOMPARE(fumage_step(smoke.get(), 1e308), 8);
        for (int i = 0; i < 5; ++i) {
            QVERIFY(fumage_step(smoke.get(), 0.1) >= 0);
        }
        QVERIFY(fumage_error(smoke.get()) == nullptr);
    }

    void whatDoesNotStartSaysWhyAndDoesNothing()
    {
        const fumage_options wrong{1000, 0, 0, 0.0};
        for (const Smoke& smoke : {named("thesis-2O12"), named("thesis-2012", &wrong),
                 Smoke(fumage_create_from_json("{ \"format\": ", nullptr), &fumage_destroy),
                 Smoke(fumage_create_from_json(nullptr, nullptr), &fumage_destroy)}) {
            QVERIFY(smoke != nullptr);
            const QByteArray why = fumage_error(smoke.get());
            QVERIFY(!why.isEmpty());
            QCOMPARE(fumage_step(smoke.get(), 1.0), -1);
            QCOMPARE(fumage_set(smoke.get(), "wind.strength", "1"), -1);
            QCOMPARE(fumage_slots(smoke.get()), std::size_t(0));
            QVERIFY(fumage_x(smoke.get()) == nullptr && fumage_colour(smoke.get()) == nullptr
                && fumage_id(smoke.get()) == nullptr && fumage_age(smoke.get()) == nullptr
                && fumage_lit_colour(smoke.get(), nullptr) == nullptr && fumage_normal(smoke.get()) == nullptr);
            QVERIFY(fumage_share(smoke.get()) == 0.0F && fumage_is_over_budget(smoke.get()) == 0);
            fumage_burst(smoke.get());
            QCOMPARE(QByteArray(fumage_error(smoke.get())), why);
        }
        QCOMPARE(fumage_step(nullptr, 1.0), -1);
        QVERIFY(fumage_x(nullptr) == nullptr && fumage_living(nullptr) == 0);
        QVERIFY(fumage_error(nullptr) != nullptr);
        fumage_destroy(nullptr);
    }
};

QTEST_GUILESS_MAIN(CInterfaceTest)
#include "c_interface_test.moc"
