// Smoke as volumes: what particles leave in cells, and that files hold it.
#include "tests/export/vdb_reader.h"
#include "tests/helpers.h"
#include "tests/lighting/clouds.h"

#include "core/effect/known_parameter.h"
#include "core/system/file.h"
#include "core/export/data/vdb_file.h"
#include "core/preset/library.h"
#include "core/rendering/scene_renderer.h"

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

/// Discs that no texture disturbs.
Effect plainDiscs()
{
    Effect effect = evenLook();
    effect.look.texture = 0.0F;
    return effect;
}

Effect plume()
{
    Effect effect = thesisEffect(3000);
    effect.air.enabled = true;
    effect.air.resolution = 16;
    effect.motion.buoyancy = effect.air.buoyancy = 2.0F;
    return effect;
}

/// The volume of a frame in cells of an edge, m.
Volume volumeIn(const Frame& frame, const Effect& effect, float voxel)
{
    return volumeOf(frame, sampled(effect), voxel).value();
}

/// Smoke that has gone before its timeline is over.
Effect burst()
{
    Effect effect = thesisEffect(500);
    effect.emitter.mode = EmissionMode::Burst;
    effect.emitter.burstDuration = 0.1F;
    effect.life.initialAlpha = 0.5F;
    effect.life.fadeRate = 2.0F;
    effect.glow.emission = 3.0F;
    effect.timeline.length = 24;
    effect.timeline.loop = false;
    return effect;
}

/// Smoke that fills more room with every frame.
Effect growing()
{
    Effect effect = thesisEffect(800);
    effect.timeline.length = 24;
    effect.timeline.loop = false;
    effect.timeline.prewarm = false;
    return effect;
}

/// The files of frames, read again.
class Written {
public:
    Written(const Scene& scene, const FrameRange& frames, std::optional<float> voxel = {}, UpAxis up = UpAxis::Z)
        : m_frames(frames)
    {
        VolumeSequenceOptions options;
        options.output = m_folder.filePath("a_##.vdb").toStdString();
        options.frames = frames;
        options.longest = 24;
        options.voxel = voxel;
        options.up = up;
        const Result<float> used = writeVolumes(scene, options);
        if (!used) {
            qFatal("%s", used.error().text().c_str());
        }
        m_voxel = used.value();
    }
    [[nodiscard]] std::string bytes(int frame) const
    {
        return readFile(m_folder.filePath(QStringLiteral("a_%1.vdb").arg(frame, 2, 10, QLatin1Char('0'))).toStdString(),
            std::size_t{1} << 28U)
            .value();
    }
    [[nodiscard]] std::vector<VdbGrid> grids(int frame) const
    {
        const std::string file = bytes(frame);
        return VdbReader(file).grids();
    }
    [[nodiscard]] float voxel() const { return m_voxel; }

private:
    QTemporaryDir m_folder;
    FrameRange m_frames;
    float m_voxel = 0.0F;
};

/// Smoke and flames through one another, and ash that is gone soon.
Scene layered()
{
    Scene scene = growing();
    scene.layers[0].name = "Smoke";
    for (const char* name : {"Flames", "Red ash"}) {
        Effect effect = scene.effect(0);
        effect.emitter.seed = static_cast<std::uint32_t>(scene.layers.size()) + 7;
        effect.emitter.position.x = 0.3F;
        effect.glow.emission = scene.layers.size() == 1 ? 3.0F : 0.0F;
        effect.look.opacity = 3.0F;
        scene.layers.emplace_back();
        scene.assign(scene.layers.size() - 1, effect);
        scene.layers.back().name = name;
    }
    Effect ash = scene.effect(2);
    ash.emitter.mode = EmissionMode::Burst;
    ash.emitter.burstDuration = 0.1F;
    ash.life.fadeRate = 4.0F;
    ash.life.initialAlpha = 0.5F;
    scene.assign(2, ash);
    return scene;
}

/// The volume of a frame of all layers, with the density of each.
Volume layeredVolume(const Scene& scene, int frame, float voxel, LayerDensities densities)
{
    const std::vector<SampledEffect> layers = sampledLayers(scene);
    std::vector<GreyCounts> greys;
    for (const SampledEffect& layer : layers) {
        greys.push_back(greysShown(layer).value());
    }
    const SceneFrame made = SceneSimulator(layers).frame(frame).value();
    return volumeOf(LayersAtFrame(made, layers), voxel, greys, densities).value();
}

} // namespace

class VolumeTest : public QObject {
    Q_OBJECT

private slots:
    void aGlowThatIsKeyedIsInEveryFrame()
    {
        Scene scene = growing();
        Track emission{&knownParameter("glow.emission"), {{0.1, 0.0F, Ease::Hold}, {0.5, 2.0F}}};
        scene.layers.front().tracks.set(emission);
        const Written written(scene, {0, 20, 10}, 0.1F);
        const auto namesOf = [&](int frame) {
            QStringList names;
            for (const VdbGrid& grid : written.grids(frame)) {
                names.push_back(QString::fromStdString(grid.name));
            }
            return names;
        };
        QVERIFY(namesOf(20).contains(QStringLiteral("flames")));
        QCOMPARE(namesOf(0), namesOf(20));
        QCOMPARE(namesOf(10), namesOf(20));
    }

    void voxelsAreThoseOfTheSizeThatIsKeyed()
    {
        Scene scene = growing();
        Track size{&knownParameter("look.size"), {{0.0, 0.05F, Ease::Linear}, {0.7, 4.0F}}};
        scene.layers.front().tracks.set(size);
        const std::vector<SampledEffect> layers = sampledLayers(scene);
        SceneSimulator simulator(layers);
        constexpr int kLongest = 24;
        const float voxel = voxelFor(simulator, layers, kLongest).value();
        int longest = 0;
        for (int frame = 0; frame < scene.timeline.length; ++frame) {
            const Volume volume = layeredVolume(scene, frame, voxel, LayerDensities::No);
            longest = std::max({longest, volume.cells.x, volume.cells.y, volume.cells.z});
        }
        QVERIFY(longest <= kLongest);
        QVERIFY(longest > kLongest - 5);
    }

    void smokeIsAllThereWhateverTheCells()
    {
        const Effect effect = plainDiscs();
        std::vector<glm::vec3> places;
        for (std::uint32_t i = 0; i < 500; ++i) {
            places.push_back(3.0F
                * glm::vec3(unitFloat(streamBits(i, 1)), unitFloat(streamBits(i, 2)), unitFloat(streamBits(i, 3))));
        }
        const Frame frame = cloud(effect, places);
        for (const float voxel : {0.6F, 0.08F, 0.02F}) { // cells far larger and far smaller than particles
            const Volume volume = volumeIn(frame, effect, voxel);
            QVERIFY(near(crossSection(volume) / crossSectionOfDiscs(places.size()), 1.0, 1e-4));
        }
    }

    void aBallTakesWhatItsDiscTakes()
    {
        // Along a line through the middle: 105 / (96 r) alpha times the integral of (1 - q^2)^2 over 2 r, 16 / 15.
        const Effect effect = plainDiscs();
        const Volume volume = volumeIn(cloud(effect, {glm::vec3(0.3F, 1.0F, -2.0F)}), effect, 0.2F / 61.0F);
        double most = 0.0;
        for (int x = 0; x < volume.cells.x; ++x) {
            for (int y = 0; y < volume.cells.y; ++y) {
                double depth = 0.0;
                for (int z = 0; z < volume.cells.z; ++z) {
                    depth += static_cast<double>(
                        volume.density[static_cast<std::size_t>((z * volume.cells.y + y) * volume.cells.x + x)]);
                }
                most = std::max(most, depth * static_cast<double>(volume.cell));
            }
        }
        QVERIFY(near(most, 105.0 / 96.0 * 0.5 * 16.0 / 15.0, 0.005));
    }

    void nothingLiesOnTheBordersOfTheBox()
    {
        const Effect effect = plume();
        const Volume volume = volumeIn(*frameOf(effect, 20), effect, 0.1F);
        QVERIFY(volume.count() > 0);
        for (int z = 0; z < volume.cells.z; ++z) {
            for (int y = 0; y < volume.cells.y; ++y) {
                for (int x = 0; x < volume.cells.x; ++x) {
                    const bool border = x == 0 || y == 0 || z == 0 || x + 1 == volume.cells.x || y + 1 == volume.cells.y
                        || z + 1 == volume.cells.z;
                    QVERIFY(!border
                        || volume.density[static_cast<std::size_t>((z * volume.cells.y + y) * volume.cells.x + x)]
                            == 0.0F);
                }
            }
        }
    }

    void columnsAreThereWhereTheyMeanSomething()
    {
        Effect effect = plume();
        const Volume inAir = volumeIn(*frameOf(effect, 20), effect, 0.15F);
        QCOMPARE(inAir.temperature.size(), inAir.count());
        QVERIFY(inAir.flames.empty());
        QVERIFY(*std::max_element(inAir.temperature.begin(), inAir.temperature.end()) > 0.1F);
        effect.air.enabled = false;
        QVERIFY(volumeIn(*frameOf(effect, 20), effect, 0.15F).temperature.empty());
        effect.glow.emission = 2.0F;
        const Volume fire = volumeIn(*frameOf(effect, 20), effect, 0.15F);
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
        const Volume volume = volumeIn(frame, effect, 0.02F);
        for (std::size_t i = 0; i < volume.count(); ++i) {
            if (volume.density[i] > 0.0F) {
                QVERIFY(glm::distance(volume.velocity[i], glm::vec3(1.0F, -2.0F, 0.5F)) < 1e-5F);
            }
        }
    }

    void densitiesOfLayersAddUpToThatOfAll()
    {
        const Scene scene = layered();
        const Volume volume = layeredVolume(scene, 15, 0.15F, LayerDensities::Yes);
        QCOMPARE(volume.layers.size(), std::size_t{3});
        QVERIFY(volume.count() > 0);
        for (std::size_t i = 0; i < volume.count(); ++i) {
            double sum = 0.0;
            for (const std::vector<float>& layer : volume.layers) {
                QVERIFY(layer[i] >= 0.0F);
                sum += static_cast<double>(layer[i]);
            }
            QVERIFY(near(sum, static_cast<double>(volume.density[i]), 1e-5 * static_cast<double>(volume.density[i])));
        }
        // Nothing else depends on them, and each is that of the layer without the others.
        const Volume together = layeredVolume(scene, 15, 0.15F, LayerDensities::No);
        QVERIFY(together.layers.empty());
        QVERIFY(sameBits(together.density, volume.density));
        QVERIFY(sameBits(together.flames, volume.flames));
        Scene alone = scene;
        alone.layers[0].visible = alone.layers[2].visible = false;
        const Volume flames = layeredVolume(alone, 15, 0.15F, LayerDensities::No);
        double sum = 0.0;
        for (const float density : volume.layers[1]) {
            sum += static_cast<double>(density);
        }
        QVERIFY(near(sum * std::pow(0.15, 3.0) / crossSection(flames), 1.0, 1e-4));
    }

    void filesHaveAGridALayer()
    {
        const QTemporaryDir folder;
        VolumeSequenceOptions options;
        options.output = folder.filePath("a_##.vdb").toStdString();
        options.longest = 24;
        options.frames = {4, 20, 16};
        options.density = DensityGrids::Layers;
        const auto gridsOf = [&](int frame) {
            const std::string bytes =
                readFile(framePath(options.output, options.frames, kVdbEnding, frame), std::size_t{1} << 28U).value();
            return VdbReader(bytes).grids();
        };
        QVERIFY(writeVolumes(layered(), options).ok());
        const std::vector<VdbGrid> early = gridsOf(4);
        const std::vector<VdbGrid> late = gridsOf(20);
        options.density = DensityGrids::Together;
        QVERIFY(writeVolumes(layered(), options).ok());
        for (const auto& [frame, apart] : {std::pair{4, early}, std::pair{20, late}}) {
            const std::vector<VdbGrid> whole = gridsOf(frame);
            std::vector<std::string> names;
            for (const VdbGrid& grid : apart) {
                names.push_back(grid.name);
                QVERIFY(grid.scale == whole[0].scale && grid.translation == whole[0].translation);
            }
            QVERIFY((names
                == std::vector<std::string>{
                    "density_smoke", "density_flames", "density_red_ash", "temperature", "flames", "vel"}));
            std::map<std::array<int, 3>, double> sum;
            for (std::size_t layer = 0; layer < 3; ++layer) {
                for (const auto& [place, value] : apart[layer].voxels) {
                    sum[place] += static_cast<double>(value[0]);
                    QVERIFY(whole[0].voxels.contains(place));
                }
            }
            QCOMPARE(sum.size(), whole[0].voxels.size()); // some may round to 0, and are there
            for (const auto& [place, value] : whole[0].voxels) {
                const auto density = static_cast<double>(value[0]);
                QVERIFY(near(sum.at(place), density, 0x1.1p-10 * density + 0x1p-23)); // halves
            }
            QVERIFY(apart.back().voxels == whole.back().voxels); // what all have together stays
        }
        QVERIFY(early[2].voxels.size() > 0 && late[2].voxels.empty()); // the ash is gone, its grid is there
    }

    void namesOfGridsAreTakenByEveryProgram()
    {
        Scene scene = layered();
        scene.layers.resize(6, scene.layers[0]);
        const std::array names{"Rök & eld", "\u70df", "smoke", "r k eld-1", "../x\n\"", ""};
        for (std::size_t i = 0; i < names.size(); ++i) {
            scene.layers[i].name = names[i];
        }
        const std::vector<std::string> grids = namesOfGrids(scene);
        QCOMPARE(grids.size(), names.size());
        for (std::size_t i = 0; i < grids.size(); ++i) {
            QVERIFY2(grids[i].starts_with("density_"), grids[i].c_str());
            QVERIFY(std::ranges::all_of(
                grids[i], [](char c) { return c == '_' || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); }));
            QCOMPARE(std::ranges::count(grids, grids[i]), std::ptrdiff_t{1});
        }
        QCOMPARE(grids[2], std::string("density_smoke"));
    }

    void tooManyDensitiesAreRefusedBeforeTheyAreMade()
    {
        // Two cells far apart, and room for a box of them: what is allowed for one density is too much for 60.
        Effect effect = plainDiscs();
        const Frame frame = cloud(effect, {glm::vec3(0.0F), glm::vec3(20.0F)});
        const SampledEffect look = sampled(effect);
        const std::vector<LayerFrame> layers(60, LayerFrame{&frame, &look});
        const std::vector<GreyCounts> greys(60, greysShown(look).value());
        const Result<Volume> refused = volumeOf(layers, 0.1F, greys, LayerDensities::Yes);
        QVERIFY(!refused.ok());
        QCOMPARE(refused.error().code, ErrorCode::TooLarge);
        QVERIFY2(refused.error().text().find("60 layers") != std::string::npos, refused.error().text().c_str());
        QVERIFY(volumeOf(layers, 0.4F, greys, LayerDensities::Yes).ok());
    }

    void nothingIsAVolumeToo()
    {
        const Effect effect = evenLook();
        const Volume volume = volumeIn(cloud(effect, {}), effect, 0.1F);
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
        const Result<float> voxel = writeVolumes(plume(), options);
        QVERIFY(voxel.ok());
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList({"smoke_08.vdb", "smoke_12.vdb"}));
        const auto contents = [&](const char* name) {
            return readFile(folder.filePath(name).toStdString(), std::size_t{1} << 28U).value();
        };
        const std::string alone = encodeVdb(volumeIn(*frameOf(plume(), 12), plume(), voxel.value()), options.up);
        QVERIFY(contents("smoke_12.vdb") == alone);
        QVERIFY(contents("smoke_08.vdb") != alone);
        QCOMPARE(alone.substr(0, 8), std::string(" BDV\0\0\0\0", 8));
        options.longest = kMaxVolumeCells + 1;
        QCOMPARE(writeVolumes(plume(), options).error().code, ErrorCode::OutOfRange);
        options.longest = 32;
        options.voxel = 0.0F;
        QCOMPARE(writeVolumes(plume(), options).error().code, ErrorCode::OutOfRange);
        options.voxel = 0.0005F;
        QCOMPARE(writeVolumes(plume(), options).error().code, ErrorCode::TooLarge);
    }

    void framesHaveTheSameGridsAndLattice_data()
    {
        QTest::addColumn<Effect>("effect");
        QTest::newRow("plume") << plume();
        QTest::newRow("burst") << burst();
        QTest::newRow("growing") << growing();
        for (const LibraryEntry& preset : builtinPresets()) {
            Effect effect = loadPreset(preset).value().preset.scene.effect();
            effect.timeline.length = 24;
            effect.timeline.stepsPerFrame = 1;
            effect.emitter.count = 400;
            effect.air.resolution = 8;
            QTest::newRow(preset.id.c_str()) << effect;
        }
    }
    void framesHaveTheSameGridsAndLattice()
    {
        QFETCH(Effect, effect);
        const Written whole(effect, {0, 20, 10});
        const std::vector<VdbGrid> first = whole.grids(0);
        for (const int frame : {10, 20}) {
            const std::vector<VdbGrid> grids = whole.grids(frame);
            QCOMPARE(grids.size(), first.size());
            for (std::size_t i = 0; i < grids.size(); ++i) {
                QCOMPARE(grids[i].name, first[i].name);
                QVERIFY(grids[i].scale == first[i].scale && grids[i].translation == first[i].translation);
            }
            // What is written apart, as farms do, is what is written in one go.
            QVERIFY(Written(effect, {frame, frame, 1}).bytes(frame) == whole.bytes(frame));
        }
        QVERIFY(near(first[0].scale[0], static_cast<double>(whole.voxel()), 0.0));
        QVERIFY(near(first[0].translation[0], 0.5 * first[0].scale[0], 0.0));
    }

    void framesWithoutSmokeHaveAllGrids()
    {
        const std::vector<VdbGrid> before = Written(burst(), {2, 2, 1}).grids(2);
        const std::vector<VdbGrid> after = Written(burst(), {23, 23, 1}).grids(23);
        for (const std::vector<VdbGrid>& grids : {before, after}) {
            QCOMPARE(grids.size(), std::size_t{4});
            QCOMPARE(grids[1].name, std::string("temperature"));
            QCOMPARE(grids[2].name, std::string("flames"));
        }
        QVERIFY(!before[0].voxels.empty() && after[0].voxels.empty());
    }

    void theSmokeOfTheTimelineIsAsManyCellsLongAsAsked()
    {
        const Effect effect = growing();
        std::array<int, 3> low{1000, 1000, 1000};
        std::array<int, 3> high{-1000, -1000, -1000};
        const Written all(effect, {0, 23, 1});
        for (int frame = 0; frame < 24; ++frame) {
            const std::vector<VdbGrid> grids = all.grids(frame);
            for (const auto& [place, value] : grids[0].voxels) {
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    low[axis] = std::min(low[axis], place[axis]);
                    high[axis] = std::max(high[axis], place[axis]);
                }
            }
        }
        const int longest = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]}) + 1;
        QVERIFY2(longest <= 24 && longest >= 20, qPrintable(QString::number(longest)));
    }

    void voxelsAreAsLargeAsTheyAreAskedFor()
    {
        const Written fine(growing(), {20, 20, 1}, 0.125F);
        QVERIFY(near(fine.grids(20)[0].scale[2], 0.125, 0.0));
        QVERIFY(near(static_cast<double>(fine.voxel()), 0.125, 0.0));
    }

    void smokeLiesWhereItsParticlesAre()
    {
        const Effect effect = evenLook();
        for (const glm::vec3 place :
            {glm::vec3(0.31F, 1.07F, -2.03F), glm::vec3(-7.7F, -0.02F, 0.01F), glm::vec3(409.6F, -409.6F, 3.0F)}) {
            const Volume volume = volumeIn(cloud(effect, {place}), effect, 0.1F);
            for (const UpAxis up : kAllUpAxes) {
                const std::string bytes = encodeVdb(volume, up);
                const VdbGrid density = VdbReader(bytes).grids()[0];
                double sum = 0.0;
                glm::dvec3 middle(0.0);
                for (const auto& [voxel, value] : density.voxels) {
                    sum += static_cast<double>(value[0]);
                    for (int axis = 0; axis < 3; ++axis) {
                        middle[axis] += static_cast<double>(value[0])
                            * (voxel[static_cast<std::size_t>(axis)] * density.scale[0] + density.translation[0]);
                    }
                }
                const glm::dvec3 expected(turned(place, up));
                QVERIFY(sum > 0.0);
                QVERIFY2(glm::distance(middle / sum, expected) < 0.05,
                    qPrintable(QStringLiteral("%1").arg(glm::distance(middle / sum, expected))));
            }
        }
    }

    void aFileHoldsEveryVoxelWhereverItLies()
    {
        Volume volume;
        volume.first = {-3, -4100, 4090};
        volume.cells = {9, 11, 13};
        volume.cell = 0.5F;
        const std::size_t count = 9 * 11 * 13;
        for (std::size_t i = 0; i < count; ++i) {
            volume.density.push_back(i % 3 == 0 ? 0.0F : static_cast<float>(i));
            volume.velocity.emplace_back(static_cast<float>(i % 7), -1.0F, 2.0F);
        }
        for (const UpAxis up : kAllUpAxes) {
            const std::string bytes = encodeVdb(volume, up);
            const VdbGrid density = VdbReader(bytes).grids()[0];
            std::size_t i = 0;
            std::size_t seen = 0;
            for (int z = 0; z < 13; ++z) {
                for (int y = 0; y < 11; ++y) {
                    for (int x = 0; x < 9; ++x, ++i) {
                        const glm::ivec3 at = volume.first + glm::ivec3(x, y, z);
                        const std::array<int, 3> place =
                            up == UpAxis::Y ? std::array{at.x, at.y, at.z} : std::array{at.x, -at.z - 1, at.y};
                        const auto found = density.voxels.find(place);
                        QCOMPARE(found != density.voxels.end(), volume.density[i] > 0.0F);
                        if (found != density.voxels.end()) {
                            QCOMPARE(found->second[0], volume.density[i]);
                            ++seen;
                        }
                    }
                }
            }
            QCOMPARE(density.voxels.size(), seen);
        }
    }
};

QTEST_APPLESS_MAIN(VolumeTest)
#include "volume_test.moc"
