#include "tests/live/live_helpers.h"

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr double kBudget = 1e-3; // s
constexpr double kEach = 1e-6; // s a particle

/// A machine whose steps take what they are said to: so much for each particle that lives.
struct Machine {
    const LiveSimulation* simulation = nullptr; ///< null: it has not started
    double each = kEach; ///< s
    double now = 0.0; ///< s

    /// Asked before a step, after its air and after its particles.
    double tick()
    {
        const bool afterParticles = ++m_ticks % 3 == 0;
        now += afterParticles && simulation != nullptr ? each * static_cast<double>(simulation->living()) : 0.0;
        return now;
    }

private:
    int m_ticks = 0;
};

/// A smoke of 3000 particles for which a machine has time for a thousand.
class Thinned {
public:
    explicit Thinned(double fadeRate = 0.1)
        : m_effect(windy(3000))
    {
        m_effect.life.fadeRate = static_cast<float>(fadeRate);
        m_live.emplace(started(m_effect, {.budgetMs = kBudget * 1e3, .clock = [this] { return m_machine.tick(); }}));
        m_machine.simulation = &*m_live;
    }
    Thinned(const Thinned&) = delete;
    Thinned& operator=(const Thinned&) = delete;

    LiveSimulation& live() { return *m_live; }
    Machine& machine() { return m_machine; }

    /// How long the longest of some steps takes, s.
    double longestOf(int steps)
    {
        double longest = 0.0;
        for (int i = 0; i < steps; ++i) {
            const double before = m_machine.now;
            go(*m_live, 1);
            longest = std::max(longest, m_machine.now - before);
        }
        return longest;
    }

private:
    Effect m_effect;
    Machine m_machine;
    std::optional<LiveSimulation> m_live;
};

} // namespace

/// Smoke that is thinned so that its steps keep within a time.
class BudgetTest : public QObject {
    Q_OBJECT

private slots:
    void theBudgetFindsItsShareAtOnceAndStaysThere()
    {
        BirthBudget budget(kBudget);
        QCOMPARE(budget.observe({0.0, kEach * 100}, 100, 10000), 1.0F); // too few to tell
        double living = 10000;
        for (int step = 0; step < 300; ++step) {
            const float share = budget.observe({0.0, kEach * living}, static_cast<std::size_t>(living), 10000);
            QVERIFY(near(
                share, 0.08, 1e-4)); // 0.8 ms at 1 us each; steps are even, but for that to be known takes more of them
            living += 0.02 * (10000.0 * static_cast<double>(share) - living);
        }
        float share = 0.0F;
        for (int step = 0; step < 300; ++step) {
            share = budget.observe({0.0, 0.01 * kEach * 1000.0}, 1000, 10000);
        }
        QVERIFY(share > 0.99F); // the machine has become faster
        for (int step = 0; step < 300; ++step) {
            const double interrupted = step % 10 == 0 ? 50.0 : 1.0;
            share = budget.observe({0.0, interrupted * kEach * 1000.0}, 1000, 10000);
        }
        QVERIFY2(share > 0.065F && share <= 0.092F,
            qPrintable(QString::number(share))); // of what it does itself, no step is longer than another
        for (int step = 0; step < 100; ++step) {
            share = budget.observe({5e-3, kEach * 1000.0}, 1000, 10000);
        }
        QCOMPARE(share, BirthBudget::kMinShare); // air alone takes longer
    }

    void oneStepInAHundredMayTakeLonger()
    {
        constexpr double kLonger = 1.8; // now and then, as where caches are another program's
        BirthBudget budget(kBudget);
        std::mt19937 random{11};
        constexpr int kSteps = 20000;
        constexpr int kSettled = 2000;
        int over = 0;
        double share = 1.0;
        double used = 0.0;
        for (int step = 0; step < kSteps; ++step) {
            const double living = 10000.0 * share;
            const double takes = kEach * living * (random() % 25 == 0 ? kLonger : 1.0);
            over += step >= kSettled && takes > kBudget ? 1 : 0;
            used += step >= kSettled ? takes / kBudget / (kSteps - kSettled) : 0.0;
            share = static_cast<double>(budget.observe({0.0, takes}, static_cast<std::size_t>(living), 10000));
        }
        QVERIFY2(over < (kSteps - kSettled) * 3 / 200, qPrintable(QString::number(over)));
        QVERIFY2(used > 0.4, qPrintable(QString::number(used))); // and no more is thinned than that takes
    }

    void noStepOfAnEvenMachineIsTooLong()
    {
        Thinned smoke;
        QVERIFY(smoke.longestOf(60) < 1.1 * kBudget); // what was born before it could be told what one costs
        const double longest = smoke.longestOf(600);
        QVERIFY2(longest <= kBudget, qPrintable(QString::number(longest)));
        QVERIFY2(smoke.live().living() > 700, qPrintable(QString::number(smoke.live().living())));
        QVERIFY(smoke.live().share() < 0.4F);
    }

    void aMachineThatBecomesSlowerAndFasterIsFollowed()
    {
        Thinned smoke;
        (void)smoke.longestOf(300);
        smoke.machine().each = 3.0 * kEach;
        (void)smoke.longestOf(120); // what lives has to die first: twice as long as a life, and a moment to learn it
        QVERIFY(smoke.longestOf(300) <= kBudget);
        smoke.machine().each = 0.1 * kEach;
        (void)smoke.longestOf(600);
        QCOMPARE(smoke.live().share(), 1.0F);
        QCOMPARE(smoke.live().living(), std::size_t(3000));
        QVERIFY(smoke.longestOf(300) <= kBudget);
    }

    void aShareComesBackWhereFewAreLeftToLearnFrom()
    {
        BirthBudget budget(kBudget);
        float share = budget.observe({0.0, 20.0 * kBudget}, 1000, 1000);
        QCOMPARE(share, BirthBudget::kMinShare);
        for (int step = 0; step < 200; ++step) {
            share = budget.observe({0.0, kEach}, 1, 1000);
        }
        QVERIFY(share > 0.99F);
    }

    void aBudgetThatCannotBeKeptSaysSo()
    {
        BirthBudget budget(kBudget);
        const auto after = [&](int steps, double air, double living) {
            for (int step = 0; step < steps; ++step) {
                (void)budget.observe({air, kEach * living}, static_cast<std::size_t>(living), 10000);
            }
            return budget.isHopeless();
        };
        QVERIFY(!after(100, 0.0, 800.0));
        QVERIFY(after(100, 5.0 * kBudget, 800.0)); // air alone takes longer
        QVERIFY(!after(200, 0.1 * kBudget, 500.0));
    }

    void theSameTimesHaveTheSameBits()
    {
        Thinned first;
        Thinned second;
        (void)first.longestOf(300);
        (void)second.longestOf(300);
        QVERIFY(sameBits(first.live().particles(), second.live().particles()));
    }

    void aMinuteOfChangesKeepsTheBudget()
    {
        Thinned smoke(0.05);
        RestlessGame game(windy(3000));
        std::vector<double> taken;
        Particles before;
        before.reset(smoke.live().particles().capacity);
        for (int step = 0; step < 3600; ++step) {
            QVERIFY(game.act(smoke.live(), step).ok());
            before.copySlots(smoke.live().particles(), 0, before.x.size());
            taken.push_back(smoke.longestOf(1));
            QVERIFY(isFinite(smoke.live().particles()));
            QVERIFY(longestJump(before, smoke.live().particles(), 6.0F * smoke.live().effect().turbulence.strength)
                < 1e-5F);
        }
        std::sort(taken.begin(), taken.end());
        const double p99 = taken[taken.size() * 99 / 100];
        QVERIFY2(p99 <= kBudget, qPrintable(QString::number(p99)));
        QVERIFY(taken[taken.size() / 2] > 0.3 * kBudget);
    }
};

QTEST_GUILESS_MAIN(BudgetTest)
#include "budget_test.moc"
