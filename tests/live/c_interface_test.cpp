#include "core/fumage.h"

#include <cmath>
#include <cstring>
#include <memory>

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
        QCOMPARE(fumage_set(smoke.get(), "motion.wind", "0.5"), 0);
        QCOMPARE(fumage_set(smoke.get(), "motion.wind", "1e30"), 1);
        QCOMPARE(fumage_set(smoke.get(), "motion.wnd", "1"), -1);
        QVERIFY2(std::strstr(fumage_error(smoke.get()), "motion.wind") != nullptr, fumage_error(smoke.get()));
        QCOMPARE(fumage_set(smoke.get(), "motion.wind", "strong"), -1);
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

    void whatDoesNotStartSaysWhyAndDoesNothing()
    {
        const fumage_options wrong{1000, 0, 0, 0.0};
        for (const Smoke& smoke : {named("thesis-2O12"), named("thesis-2012", &wrong), Smoke(fumage_create_from_json("{ \"format\": ", nullptr), &fumage_destroy),
                 Smoke(fumage_create_from_json(nullptr, nullptr), &fumage_destroy)}) {
            QVERIFY(smoke != nullptr);
            const QByteArray why = fumage_error(smoke.get());
            QVERIFY(!why.isEmpty());
            QCOMPARE(fumage_step(smoke.get(), 1.0), -1);
            QCOMPARE(fumage_set(smoke.get(), "motion.wind", "1"), -1);
            QCOMPARE(fumage_slots(smoke.get()), std::size_t(0));
            QVERIFY(fumage_x(smoke.get()) == nullptr && fumage_colour(smoke.get()) == nullptr);
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
