// The air as engines read it, against the field that it was written from.
#include "tests/helpers.h"

#include "core/system/file.h"
#include "core/export/data/air_file.h"
#include "core/simulation/air_cache.h"

#include <QDir>
#include <QTemporaryDir>
#include <cstring>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr int kFrame = 12;

/// A leaning plume in a box of three different edges.
Effect plume()
{
    Effect effect = thesisEffect(200);
    effect.air.enabled = true;
    effect.air.resolution = 24;
    effect.air.fit = false;
    effect.air.size = {2.0F, 4.0F, 3.0F};
    effect.wind.strength = 1.0F;
    effect.wind.angle = 30.0F;
    effect.motion.buoyancy = effect.air.buoyancy = 2.0F;
    return effect;
}

AirFieldPtr fieldOf(const Effect& effect)
{
    const SampledEffect smoke = sampled(effect);
    AirCache shelf;
    const SimulationModel model(smoke, shelf.airOf(smoke));
    return model.air()->field(model.schedule().stepOfFrame(kFrame)).value();
}

/// Whether a number in a file is that of the field: Unreal's have six digits and centimetres.
bool same(double written, float ours)
{
    return near(written, static_cast<double>(ours), 1e-5 * (1.0 + std::abs(static_cast<double>(ours))));
}

/// Some places of a grid, its corners among them.
template <class Visit>
void atSomeCells(const glm::ivec3& cells, const Visit& visit)
{
    for (const int i : {0, cells.x / 3, cells.x - 1}) {
        for (const int j : {0, cells.y / 2, cells.y - 1}) {
            for (const int k : {0, cells.z / 4, cells.z - 1}) {
                visit(glm::ivec3(i, j, k));
            }
        }
    }
}

} // namespace

class AirFileTest : public QObject {
    Q_OBJECT

private slots:
    void fgaIsInUnrealsAxes()
    {
        const AirFieldPtr air = fieldOf(plume());
        const AirGrid& grid = air->grid;
        QVERIFY(grid.cells.x != grid.cells.y && grid.cells.y != grid.cells.z);
        const QByteArray text = QByteArray::fromStdString(encodeAir(*air, AirFormat::Fga)).replace('\n', "");
        QVERIFY(text.endsWith(','));
        QList<double> numbers;
        for (const QByteArray& number : text.chopped(1).split(',')) {
            bool ok = false;
            numbers << number.toDouble(&ok);
            QVERIFY(ok);
        }
        QCOMPARE(numbers.size(), 9 + 3 * grid.cells.x * grid.cells.y * grid.cells.z);
        QCOMPARE(numbers.first(3), (QList<double>{double(grid.cells.x), double(grid.cells.z), double(grid.cells.y)}));
        const std::array<float, 6> box{
            grid.corner.x, grid.corner.z, grid.corner.y, grid.end().x, grid.end().z, grid.end().y};
        for (int i = 0; i < 6; ++i) {
            QVERIFY(same(numbers[3 + i], 100.0F * box[static_cast<std::size_t>(i)]));
        }
        double most = 0.0;
        atSomeCells(grid.cells, [&](const glm::ivec3& cell) {
            const glm::vec4 ours = air->at(grid.centre(cell));
            const qsizetype at = 9 + 3 * ((qsizetype(cell.y) * grid.cells.z + cell.z) * grid.cells.x + cell.x);
            QVERIFY(same(numbers[at], 100.0F * ours.x));
            QVERIFY(same(numbers[at + 1], 100.0F * ours.z));
            QVERIFY(same(numbers[at + 2], 100.0F * ours.y));
            most = std::max(most, std::abs(numbers[at + 2]));
        });
        QVERIFY(most > 1.0); // cm/s: it moves
    }

    void volumeFileIsInUnitysAxes()
    {
        const AirFieldPtr air = fieldOf(plume());
        const AirGrid& grid = air->grid;
        const std::string bytes = encodeAir(*air, AirFormat::Vf);
        QCOMPARE(bytes.substr(0, 4), std::string("VF_V"));
        QCOMPARE(
            bytes.size(), std::size_t(10) + std::size_t(12) * std::size_t(grid.cells.x * grid.cells.y * grid.cells.z));
        const auto byte = [&](std::size_t at) { return static_cast<int>(static_cast<unsigned char>(bytes[at])); };
        for (int axis = 0; axis < 3; ++axis) {
            const auto at = static_cast<std::size_t>(4 + 2 * axis);
            QCOMPARE(byte(at) + 256 * byte(at + 1), grid.cells[axis]);
        }
        atSomeCells(grid.cells, [&](const glm::ivec3& cell) {
            const glm::vec4 ours = air->at(grid.centre(cell));
            const int turned = grid.cells.z - 1 - cell.z;
            const auto at =
                static_cast<std::size_t>(10 + 12 * ((turned * grid.cells.y + cell.y) * grid.cells.x + cell.x));
            std::array<float, 3> theirs{};
            std::memcpy(theirs.data(), bytes.data() + at, sizeof(theirs)); // these tests run on little-endian machines
            QCOMPARE(theirs[0], ours.x);
            QCOMPARE(theirs[1], ours.y);
            QCOMPARE(theirs[2], -ours.z);
        });
    }

    void framesAreFiles()
    {
        const QTemporaryDir folder;
        AirSequenceOptions options;
        options.output = folder.filePath("air_##.vf").toStdString();
        options.format = AirFormat::Vf;
        options.frames = {10, kFrame, 2};
        const Result<AirGrid> grid = writeAir(plume(), options);
        QVERIFY(grid.ok());
        const AirFieldPtr air = fieldOf(plume());
        QVERIFY(grid.value() == air->grid);
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList({"air_10.vf", "air_12.vf"}));
        QVERIFY(readFile(folder.filePath("air_12.vf").toStdString(), std::size_t{1} << 26U).value()
            == encodeAir(*air, AirFormat::Vf));
    }

    void whereNothingCanBeWrittenNothingIsBaked()
    {
        const QTemporaryDir folder;
        const std::string source = folder.filePath("air_10.fga").toStdString();
        QVERIFY(writeFileAtomically(source, std::string_view("{}")).ok());
        AirSequenceOptions options;
        options.frames = {10, kFrame, 2};
        int told = 0;
        const auto count = [&](ProgressPhase, int, int) { ++told; };

        options.output = folder.filePath("air_##.fga").toStdString();
        options.source = source;
        const Result<AirGrid> overSource = writeAir(plume(), options, count);
        QVERIFY(!overSource.ok());
        QCOMPARE(overSource.error().code, ErrorCode::WouldOverwrite);
        QCOMPARE(readFile(source, 10).value(), std::string("{}"));

        options.output = source + "/below_a_file/air_##.fga";
        options.source.clear();
        QVERIFY(!writeAir(plume(), options, count).ok());
        QCOMPARE(told, 0);
    }

    void smokeWithoutAirHasNone()
    {
        const QTemporaryDir folder;
        AirSequenceOptions options;
        options.output = folder.filePath("air.fga").toStdString();
        Effect effect = plume();
        effect.air.enabled = false;
        const Result<AirGrid> grid = writeAir(effect, options);
        QVERIFY(!grid.ok());
        QCOMPARE(grid.error().code, ErrorCode::OutOfRange);
        QVERIFY(grid.error().text().find("air.enabled") != std::string::npos);
        QVERIFY(QDir(folder.path()).isEmpty());
    }
};

QTEST_APPLESS_MAIN(AirFileTest)
#include "air_file_test.moc"
