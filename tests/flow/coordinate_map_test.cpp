#include "tests/flow/flow_helpers.h"
#include "tests/helpers.h"

#include "core/flow/coordinate_step.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

using namespace fumage;
using namespace fumage::tests;

namespace {

/// Not a multiple of any vector's length.
AirGrid grid()
{
    return {{19, 23, 17}, 0.125F, {-1.0F, 0.0F, -0.75F}};
}

/// A half float of a number that it holds.
std::uint16_t halfOf(float value)
{
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof(bits));
    if ((bits & 0x7fffffffU) == 0) {
        return 0;
    }
    return static_cast<std::uint16_t>((bits >> 16U & 0x8000U) | (((bits & 0x7fffffffU) - (112U << 23U)) >> 13U));
}

/// Air whose velocity at each node is told by its place; exact where halves hold it.
template <class Velocity>
AirField fieldOf(const AirGrid& on, const Velocity& velocity)
{
    AirField field(on);
    for (int k = 0; k <= on.cells.z; ++k) {
        for (int j = 0; j <= on.cells.y; ++j) {
            for (int i = 0; i <= on.cells.x; ++i) {
                const glm::vec3 u = velocity(on.corner + on.cell * glm::vec3(i, j, k));
                std::uint16_t* quad = field.quads.data() + field.plane * static_cast<std::size_t>(k)
                    + field.row * static_cast<std::size_t>(j) + 4 * static_cast<std::size_t>(i);
                for (int axis = 0; axis < 3; ++axis) {
                    quad[axis] = halfOf(u[axis]);
                }
            }
        }
    }
    return field;
}

CoordinateMap carried(const AirField& field, float dt, int steps)
{
    CoordinateMap map;
    map.seed(field.grid);
    CoordinateMap room;
    for (int i = 0; i < steps; ++i) {
        stepCoordinates(map, field, dt, room);
    }
    return map;
}

const std::vector<glm::vec3> kPlaces{{0.1F, 0.9F, 0.2F}, {-0.93F, 0.01F, -0.7F}, {0.7F, 2.2F, 0.99F}};

} // namespace

class CoordinateMapTest : public QObject {
    Q_OBJECT

private slots:
    void aSeedIsItsOwnPlace()
    {
        CoordinateMap map;
        map.seed(grid());
        for (const glm::vec3& place : {kPlaces[0], kPlaces[1], kPlaces[2], glm::vec3(-3.0F, 5.0F, 2.0F)}) {
            const AdvectedPlace at = advectedPlace(map, place);
            QVERIFY(glm::distance(at.place, place) < 1e-5F);
            for (int axis = 0; axis < 3; ++axis) {
                QVERIFY(glm::distance(at.slope[axis], glm::mat3(1.0F)[axis]) < 1e-4F);
            }
        }
    }

    /// X = x - u t, also where the wind comes from outside the box.
    void evenWindShiftsCoordinates()
    {
        const glm::vec3 wind{0.5F, -0.25F, 1.5F};
        const CoordinateMap map = carried(fieldOf(grid(), [&](const glm::vec3&) { return wind; }), 1.0F / 32.0F, 12);
        for (const glm::vec3& place : kPlaces) {
            const AdvectedPlace at = advectedPlace(map, place);
            QVERIFY(glm::distance(at.place, place - wind * (12.0F / 32.0F)) < 1e-5F);
            QVERIFY(glm::distance(at.slope[1], glm::vec3(0.0F, 1.0F, 0.0F)) < 1e-4F);
        }
    }

    /// u = (s y, 0, 0): X = x - s y t, dX/dy = -s t.
    void shearSlantsCoordinates()
    {
        const AirField field =
            fieldOf(grid(), [](const glm::vec3& place) { return glm::vec3(2.0F * place.y, 0.0F, 0.0F); });
        const AdvectedPlace at = advectedPlace(carried(field, 1.0F / 64.0F, 16), kPlaces[0]);
        QVERIFY(glm::distance(at.place, kPlaces[0] - glm::vec3(2.0F * 0.25F * kPlaces[0].y, 0.0F, 0.0F)) < 1e-4F);
        QVERIFY(glm::distance(at.slope[1], glm::vec3(-0.5F, 1.0F, 0.0F)) < 1e-3F);
        QVERIFY(near(glm::determinant(at.slope), 1.0, 1e-3)); // nothing is pressed together
    }

    void partsOfAStepCarryOneAfterTheOther()
    {
        AirField field = fieldOf(grid(), [](const glm::vec3&) { return glm::vec3(1.0F, 0.0F, 0.0F); });
        field.share = 0.25F;
        field.earlier.push_back(fieldOf(grid(), [](const glm::vec3&) { return glm::vec3(0.0F, 2.0F, 0.0F); }));
        field.earlier.back().share = 0.75F;
        const AdvectedPlace at = advectedPlace(carried(field, 0.1F, 1), kPlaces[0]);
        QVERIFY(glm::distance(at.place, kPlaces[0] - glm::vec3(0.025F, 0.15F, 0.0F)) < 1e-5F);
    }

    void everyInstructionSetGivesTheSameBits()
    {
        const AirField field = fieldOf(grid(), [](const glm::vec3& place) {
            return glm::vec3(std::floor(4.0F * place.y), 1.0F, std::floor(-8.0F * place.x)) * 0.25F;
        });
        const SimdGuard guard;
        AlignedArray<float> first;
        for (const std::string& target : availableSimdTargets()) {
            QVERIFY(forceSimdTarget(target).ok());
            const CoordinateMap map = carried(field, 0.05F, 3);
            if (first.empty()) {
                first = map.quads;
            }
            QVERIFY2(sameBits(map.quads, first), target.c_str());
        }
    }
};

QTEST_APPLESS_MAIN(CoordinateMapTest)
#include "coordinate_map_test.moc"
