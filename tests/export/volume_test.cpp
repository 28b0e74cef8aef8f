// Smoke as volumes: what particles leave in cells, and that files hold it.
#include "tests/helpers.h"
#include "tests/lighting/clouds.h"

#include "core/base/file.h"
#include "core/export/vdb_file.h"

#include <QDir>
#include <QTemporaryDir>

using namespace fumage;
using namespace fumage::tests;

namespace {

/// Extinction times volume, summed over all cells, m^2.
double crossSection(const Volume& volume)
{
    double sum = 0.0;
    for (const float density : volume.density) {
        sum += static_cast<double>(density);
    }
    return sum * std::pow(static_cast<double>(volume.cell), 3.0);
}

/// What discs of 0.2 m and alpha 0.5 take, m^2.
double crossSectionOfDiscs(std::size_t count)
{
    return static_cast<double>(count) * 0.5 * M_PI * 0.01 / 3.0;
}

Effect plume()
{
    Effect effect = thesisEffect(3000);
    effect.air.enabled = true;
    effect.air.resolution = 16;
    effect.motion.buoyancy = 2.0F;
    return effect;
}

} // namespace

class VolumeTest : public QObject {
    Q_OBJECT

private slots:
    void smokeIsAllThereWhateverTheCells()
    {
        const Effect effect = evenLook();
        std::vector<glm::vec3> places;
        for (std::uint32_t i = 0; i < 500; ++i) {
            places.push_back(3.0F * glm::vec3(unitFloat(streamBits(i, 1)), unitFloat(streamBits(i, 2)), unitFloat(streamBits(i, 3))));
        }
        const Frame frame = cloud(effect, places);
        for (const int longest : {8, 40, 150}) { // cells far larger and far smaller than particles
            const Volume volume = volumeOf(frame, sampled(effect), longest);
            QVERIFY(volume.cells.x <= longest && volume.cells.y <= longest && volume.cells.z <= longest);
            QVERIFY(near(crossSection(volume) / crossSectionOfDiscs(places.size()), 1.0, 1e-4));
        }
    }

    void aBallTakesWhatItsDiscTakes()
    {
        // Along a line through the middle: 105 / (96 r) alpha times the integral of (1 - q^2)^2 over 2 r, 16 / 15.
        const Effect effect = evenLook();
        const Volume volume = volumeOf(cloud(effect, {glm::vec3(0.3F, 1.0F, -2.0F)}), sampled(effect), 64);
        double most = 0.0;
        for (int x = 0; x < volume.cells.x; ++x) {
            for (int y = 0; y < volume.cells.y; ++y) {
                double depth = 0.0;
                for (int z = 0; z < volume.cells.z; ++z) {
                    depth += static_cast<double>(volume.density[static_cast<std::size_t>((z * volume.cells.y + y) * volume.cells.x + x)]);
                }
                most = std::max(most, depth * static_cast<double>(volume.cell));
            }
        }
        QVERIFY(near(most, 105.0 / 96.0 * 0.5 * 16.0 / 15.0, 0.005));
    }

    void nothingLiesOnTheBordersOfTheBox()
    {
        const Effect effect = plume();
        const Volume volume = volumeOf(*frameOf(effect, 20), sampled(effect), 48);
        QVERIFY(volume.count() > 0);
        for (int z = 0; z < volume.cells.z; ++z) {
            for (int y = 0; y < volume.cells.y; ++y) {
                for (int x = 0; x < volume.cells.x; ++x) {
                    const bool border = x == 0 || y == 0 || z == 0 || x + 1 == volume.cells.x || y + 1 == volume.cells.y || z + 1 == volume.cells.z;
                    QVERIFY(!border || volume.density[static_cast<std::size_t>((z * volume.cells.y + y) * volume.cells.x + x)] == 0.0F);
                }
            }
        }
    }

    void columnsAreThereWhereTheyMeanSomething()
    {
        Effect effect = plume();
        const Volume inAir = volumeOf(*frameOf(effect, 20), sampled(effect), 32);
        QCOMPARE(inAir.temperature.size(), inAir.count());
        QVERIFY(inAir.flames.empty());
        QVERIFY(*std::max_element(inAir.temperature.begin(), inAir.temperature.end()) > 0.1F);
        effect.air.enabled = false;
        QVERIFY(volumeOf(*frameOf(effect, 20), sampled(effect), 32).temperature.empty());
        effect.light.emission = 2.0F;
        const Volume fire = volumeOf(*frameOf(effect, 20), sampled(effect), 32);
        QCOMPARE(fire.flames.size(), fire.count());
        for (std::size_t i = 0; i < fire.count(); ++i) {
            QVERIFY(fire.flames[i] <= fire.density[i] * 1.0001F);
        }
    }

    void smokeThatMovesAsOneHasItsVelocity()
    {
        const Effect effect = evenLook();
        Frame frame = cloud(effect, {glm::vec3(0.0F), glm::vec3(0.1F, 0.0F, 0.0F)});
        for (std::size_t i = 0; i < 2; ++i) {
            frame.particles.vx[i] = 1.0F;
            frame.particles.vy[i] = -2.0F;
            frame.particles.vz[i] = 0.5F;
        }
        const Volume volume = volumeOf(frame, sampled(effect), 16);
        for (std::size_t i = 0; i < volume.count(); ++i) {
            if (volume.density[i] > 0.0F) {
                QVERIFY(glm::distance(volume.velocity[i], glm::vec3(1.0F, -2.0F, 0.5F)) < 1e-5F);
            }
        }
    }

    void nothingIsAVolumeToo()
    {
        const Effect effect = evenLook();
        const Volume volume = volumeOf(cloud(effect, {}), sampled(effect), 32);
        QCOMPARE(volume.count(), std::size_t{0});
        const std::string bytes = encodeVdb(volume, UpAxis::Y);
        QVERIFY(bytes.find("Tree_float_5_4_3_HalfFloat") != std::string::npos);
    }

    void aFileHasTheSameBytesAgain()
    {
        const QTemporaryDir folder;
        VolumeSequenceOptions options;
        options.output = folder.filePath("smoke_##.vdb").toStdString();
        options.frames = {8, 12, 4};
        options.longest = 32;
        QVERIFY(writeVolumes(plume(), options, {}).ok());
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList({"smoke_08.vdb", "smoke_12.vdb"}));
        const auto contents = [&](const char* name) { return readFile(folder.filePath(name).toStdString(), std::size_t{1} << 28U).value(); };
        const std::string alone = encodeVdb(volumeOf(*frameOf(plume(), 12), sampled(plume()), 32), options.up);
        QVERIFY(contents("smoke_12.vdb") == alone);
        QVERIFY(contents("smoke_08.vdb") != alone);
        QCOMPARE(alone.substr(0, 8), std::string(" BDV\0\0\0\0", 8));
        options.longest = kMaxVolumeCells + 1;
        QCOMPARE(writeVolumes(plume(), options, {}).error().code, ErrorCode::OutOfRange);
    }
};

QTEST_APPLESS_MAIN(VolumeTest)
#include "volume_test.moc"
