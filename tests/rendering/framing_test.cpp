// A camera that was framed sees all that it was framed for, and nothing nearer would.
#include "tests/helpers.h"

#include "core/rendering/framing.h"

#include <cmath>

#include <glm/vec2.hpp>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr int kWidth = 200;
constexpr int kHeight = 100;
constexpr float kMax = 0.96F; ///< of half the picture, which has a margin of 4 %

/// A few discs that someone placed by hand.
struct Discs {
    Particles particles;
    Appearance appearance;

    explicit Discs(const std::vector<glm::vec4>& discs) // position and radius
    {
        particles.reset(discs.size());
        appearance.radius.resize(particles.x.size());
        appearance.alpha.resize(particles.x.size());
        for (std::size_t i = 0; i < discs.size(); ++i) {
            particles.x[i] = discs[i].x;
            particles.y[i] = discs[i].y;
            particles.z[i] = discs[i].z;
            appearance.radius[i] = discs[i].w;
            appearance.alpha[i] = 0.5F;
        }
    }
};

/// How far from the middle the discs reach, in halves of the picture: across and upwards.
glm::vec2 reachThrough(const Camera& camera, const Discs& discs, float seconds)
{
    const View view = makeView(camera, seconds, kWidth, kHeight);
    glm::vec2 most(0.0F);
    for (std::size_t i = 0; i < discs.particles.capacity; ++i) {
        const Projected at = project(view, {discs.particles.x[i], discs.particles.y[i], discs.particles.z[i]});
        if (at.depth <= 0.0F) {
            return glm::vec2(1e9F);
        }
        const float radius = discs.appearance.radius[i] * view.focal / at.depth;
        most.x = std::max(most.x, (std::abs(at.x - 0.5F * kWidth) + radius) / (0.5F * kWidth));
        most.y = std::max(most.y, (std::abs(at.y - 0.5F * kHeight) + radius) / (0.5F * kHeight));
    }
    return most;
}

Discs somewhere()
{
    return Discs(
        {{0.0F, 0.0F, 0.0F, 0.2F}, {3.0F, 1.0F, -2.0F, 0.1F}, {-0.5F, 4.0F, 1.0F, 0.5F}, {1.0F, 2.0F, 6.0F, 0.3F}});
}

} // namespace

class FramingTest : public QObject {
    Q_OBJECT

private slots:
    void everyDiscIsSeenAndTheTightSideIsFull_data()
    {
        QTest::addColumn<int>("mode");
        QTest::addColumn<float>("yaw");
        QTest::addColumn<float>("pitch");
        QTest::newRow("ahead") << static_cast<int>(CameraMode::Orbit) << 0.0F << 0.0F;
        QTest::newRow("aside, from above") << static_cast<int>(CameraMode::Orbit) << 130.0F << 40.0F;
        QTest::newRow("from below") << static_cast<int>(CameraMode::Orbit) << -70.0F << -60.0F;
        QTest::newRow("fixed") << static_cast<int>(CameraMode::Fixed) << 0.0F << 0.0F;
    }
    void everyDiscIsSeenAndTheTightSideIsFull()
    {
        QFETCH(int, mode);
        QFETCH(float, yaw);
        QFETCH(float, pitch);
        Camera camera;
        camera.mode = static_cast<CameraMode>(mode);
        camera.yaw = yaw;
        camera.pitch = pitch;
        camera.view = {0.3F, -0.2F, -1.0F};
        const Discs discs = somewhere();
        Framing framing(camera, kWidth, kHeight);
        framing.addParticles(discs.particles, discs.appearance, 0.0F);
        const glm::vec2 reach = reachThrough(framing.camera(), discs, 0.0F);
        QVERIFY(reach.x < kMax + 1e-3F);
        QVERIFY(reach.y < kMax + 1e-3F);
        QVERIFY2(std::max(reach.x, reach.y) > kMax - 1e-3F, "nearer would do");
        QCOMPARE(framing.camera().yaw, camera.yaw);
        QCOMPARE(framing.camera().focalLength, camera.focalLength);
    }

    void aTurntableSeesAllOfItAllTheWayRound()
    {
        Camera camera;
        camera.turntable = 90.0F;
        const Discs discs = somewhere();
        Framing framing(camera, kWidth, kHeight);
        constexpr int kMoments = 32;
        const auto secondsAt = [](int moment) { return 4.0F * static_cast<float>(moment) / kMoments; };
        for (int moment = 0; moment < kMoments; ++moment) {
            framing.addParticles(discs.particles, discs.appearance, secondsAt(moment));
        }
        const Camera found = framing.camera();
        float most = 0.0F;
        for (int moment = 0; moment < kMoments; ++moment) {
            const glm::vec2 reach = reachThrough(found, discs, secondsAt(moment));
            most = std::max({most, reach.x, reach.y});
        }
        QVERIFY(most < kMax + 1e-3F);
        QVERIFY(most > kMax - 1e-3F);

        // No target nearby would let the camera come much nearer.
        for (const glm::vec3& step :
            {glm::vec3(0.2F, 0.0F, 0.0F), glm::vec3(0.0F, 0.2F, 0.0F), glm::vec3(0.0F, 0.0F, 0.2F)}) {
            QVERIFY(framing.distanceFrom(found.target + step) > 0.99F * found.distance);
            QVERIFY(framing.distanceFrom(found.target - step) > 0.99F * found.distance);
        }
    }

    void theDistanceForATargetIsTheLeastThatDoes()
    {
        Camera camera;
        camera.yaw = 20.0F;
        const Discs discs = somewhere();
        Framing framing(camera, kWidth, kHeight);
        framing.addParticles(discs.particles, discs.appearance, 0.0F);
        camera.distance = framing.distanceFrom(camera.target);
        const glm::vec2 reach = reachThrough(camera, discs, 0.0F);
        QVERIFY(std::abs(std::max(reach.x, reach.y) - kMax) < 1e-3F);
    }

    void theTargetIsAmongTheSmokeAndNotHalfWayToWhatHasFlownOff()
    {
        std::vector<glm::vec4> discs(50, {0.0F, 0.0F, -2.0F, 0.3F});
        discs.emplace_back(0.0F, 0.1F, 6.0F, 0.01F);
        const Discs smoke(discs);
        const Camera camera; // looks along -z, a little down
        Framing framing(camera, kWidth, kHeight);
        framing.addParticles(smoke.particles, smoke.appearance, 0.0F);
        const Camera found = framing.camera();
        QVERIFY(std::abs(found.target.z + 2.0F) < 0.1F);
        const glm::vec2 reach = reachThrough(found, smoke, 0.0F);
        QVERIFY(std::max(reach.x, reach.y) < kMax + 1e-3F);
    }

    void whatIsFramedIsBetweenTheMargins()
    {
        const Discs discs = somewhere();
        Framing framing(Camera(), kWidth, kHeight);
        const PictureReach inner = framing.inner();
        QCOMPARE(inner, (PictureReach{.left = 4, .right = kWidth - 4, .top = 2, .bottom = kHeight - 2}));
        framing.addParticles(discs.particles, discs.appearance, 0.0F);
        const glm::vec2 reach = reachThrough(framing.camera(), discs, 0.0F);
        QVERIFY(reach.x * 0.5F * kWidth < 0.5F * kWidth - static_cast<float>(inner.left) + 0.1F);
        QVERIFY(reach.y * 0.5F * kHeight < 0.5F * kHeight - static_cast<float>(inner.top) + 0.1F);
    }

    void clearParticlesNeedNoRoom()
    {
        Discs discs({{0.0F, 0.0F, 0.0F, 0.2F}, {100.0F, 0.0F, 0.0F, 1.0F}});
        discs.appearance.alpha[1] = 0.0F;
        const Camera camera;
        Framing all(camera, kWidth, kHeight);
        all.addParticles(discs.particles, discs.appearance, 0.0F);
        QVERIFY(all.camera().distance < 2.0F);

        discs.appearance.alpha[0] = 0.0F;
        Framing nothing(camera, kWidth, kHeight);
        nothing.addParticles(discs.particles, discs.appearance, 0.0F);
        QVERIFY(nothing.isEmpty());
        QVERIFY(nothing.camera() == camera);
    }

    void theReachOfAPictureIsTheBoxOfWhatIsSeen()
    {
        Image image;
        image.resize(7, 5);
        std::fill(image.pixels.begin(), image.pixels.end(), 0.0F);
        QVERIFY(reachOf(image, 0.1F).isEmpty());
        image.row(1)[4 * 2 + 3] = 0.5F;
        image.row(3)[4 * 5 + 3] = 0.1F;
        image.row(4)[4 * 6 + 3] = 0.09F;
        QCOMPARE(reachOf(image, 0.1F), (PictureReach{.left = 2, .right = 6, .top = 1, .bottom = 4}));
    }
};

QTEST_GUILESS_MAIN(FramingTest)
#include "framing_test.moc"
