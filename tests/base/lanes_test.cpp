// Formulas over vectors of lanes give, lane for lane, the bits of the same formula over plain numbers, on every
// instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/base/lanes_test.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "core/base/hash-inl.h"
#include "core/base/math-inl.h"
#include "core/base/vector-inl.h"
#include "tests/base/lanes_test.h"

#include <array>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;

void vectorFormulas(const tests::VectorInput& in, tests::VectorRows& out)
{
    const D d;
    const float f = in.factor;
    const glm::vec3& g = in.same;
    for (std::size_t i = 0; i < tests::kLaneCount; i += hn::Lanes(d)) {
        const Vec3<V> p = load(d, in.px, in.py, in.pz, i);
        const Vec3<V> q = load(d, in.qx, in.qy, in.qz, i);
        const std::array<Vec3<V>, tests::kFormulas> rows{p + q, p - q, p * q, p * q.x, q.x * p, p * f, p + g, p - g,
            p * g, q.y * g, cross(p, q), broadcast(d, g), uniform(q.z), Vec3<V>{dot(p, q), dot(p, g), f / p.x},
            Vec3<V>{f + p.x, f - p.x, f * p.x}, Vec3<V>{p.x + f, p.x - f, p.x * f}};
        for (std::size_t row = 0; row < rows.size(); ++row) {
            store(rows[row], out[row].x, out[row].y, out[row].z, i);
        }
    }
}

void hashFormulas(const tests::HashInput& in, tests::HashRows& out)
{
    const D d;
    const hn::RebindToUnsigned<D> du;
    for (std::size_t i = 0; i < tests::kLaneCount; i += hn::Lanes(d)) {
        const auto low = hn::Load(du, &in.low[i]);
        const auto key = keysOf(in.seed, low, hn::Load(du, &in.high[i]));
        hn::Store(key, du, &out.key[i]);
        hn::Store(mixedBits(low), du, &out.mixed[i]);
        hn::Store((low & in.seed) ^ in.stream, du, &out.masked[i]);
        hn::Store(unitStream(d, key, in.stream), d, &out.unit[i]);
        hn::Store(signedStream(d, key, in.stream), d, &out.both[i]);
    }
}

void mathFormulas(const std::array<float, tests::kLaneCount>& x, tests::MathRows& out)
{
    const D d;
    for (std::size_t i = 0; i < tests::kLaneCount; i += hn::Lanes(d)) {
        const V v = hn::LoadU(d, &x[i]);
        const SineCosine<V> turn = sinCos(d, v);
        hn::Store(turn.sine, d, &out.sine[i]);
        hn::Store(turn.cosine, d, &out.cosine[i]);
        hn::Store(exponential(d, v), d, &out.exponential[i]);
        hn::Store(logarithm(d, v), d, &out.logarithm[i]);
    }
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE || defined(Q_MOC_RUN)

#include "tests/helpers.h"

#include "core/base/math.h"

#include <bit>

#include <glm/geometric.hpp>

namespace fumage {

HWY_EXPORT(vectorFormulas);
HWY_EXPORT(hashFormulas);
HWY_EXPORT(mathFormulas);

namespace tests {

namespace {

/// The formulas of vectorFormulas(), as GLM has them.
std::array<glm::vec3, kFormulas> formulas(const glm::vec3& p, const glm::vec3& q, const glm::vec3& g, float f)
{
    return {p + q, p - q, p * q, p * q.x, q.x * p, p * f, p + g, p - g, p * g, q.y * g, glm::cross(p, q), g,
        glm::vec3(q.z), glm::vec3(glm::dot(p, q), glm::dot(p, g), f / p.x), glm::vec3(f + p.x, f - p.x, f * p.x),
        glm::vec3(p.x + f, p.x - f, p.x * f)};
}

float randomFloat(std::uint32_t index)
{
    return 100.0F * signedFloat(mixBits(index + 1U));
}

bool sameBits(float a, float b)
{
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

} // namespace

class LanesTest : public QObject {
    Q_OBJECT

private slots:
    void everyTarget_data()
    {
        QTest::addColumn<QString>("target");
        for (const std::string& name : availableSimdTargets()) {
            QTest::newRow(name.c_str()) << QString::fromStdString(name);
        }
    }

    void vectorsFollowGlm_data() { everyTarget_data(); }
    void vectorsFollowGlm()
    {
        QFETCH(QString, target);
        const SimdGuard guard;
        QVERIFY(forceSimdTarget(target.toStdString()).ok());
        VectorInput in;
        std::uint32_t drawn = 0;
        for (auto* column : {&in.px, &in.py, &in.pz, &in.qx, &in.qy, &in.qz}) {
            for (float& value : *column) {
                value = randomFloat(drawn++);
            }
        }
        VectorRows rows{};
        HWY_DYNAMIC_DISPATCH(vectorFormulas)
        (in, rows);
        for (std::size_t i = 0; i < kLaneCount; ++i) {
            const auto expected =
                formulas({in.px[i], in.py[i], in.pz[i]}, {in.qx[i], in.qy[i], in.qz[i]}, in.same, in.factor);
            for (std::size_t row = 0; row < kFormulas; ++row) {
                const bool same = sameBits(rows[row].x[i], expected[row].x) && sameBits(rows[row].y[i], expected[row].y)
                    && sameBits(rows[row].z[i], expected[row].z);
                QVERIFY2(same, qPrintable(QString("formula %1, lane %2").arg(row).arg(i)));
            }
        }
    }

    void randomBitsFollowTheirScalarForm_data() { everyTarget_data(); }
    void randomBitsFollowTheirScalarForm()
    {
        QFETCH(QString, target);
        const SimdGuard guard;
        QVERIFY(forceSimdTarget(target.toStdString()).ok());
        HashInput in;
        for (std::uint32_t i = 0; i < kLaneCount; ++i) {
            in.low[i] = mixBits(i);
            in.high[i] = i;
        }
        HashRows rows{};
        HWY_DYNAMIC_DISPATCH(hashFormulas)
        (in, rows);
        for (std::size_t i = 0; i < kLaneCount; ++i) {
            const std::uint32_t key = keyOf(in.seed, static_cast<std::uint64_t>(in.high[i]) << 32U | in.low[i]);
            QCOMPARE(rows.key[i], key);
            QCOMPARE(rows.mixed[i], mixBits(in.low[i]));
            QCOMPARE(rows.masked[i], (in.low[i] & in.seed) ^ in.stream);
            QVERIFY(sameBits(rows.unit[i], unitFloat(streamBits(key, in.stream))));
            QVERIFY(sameBits(rows.both[i], 2.0F * unitFloat(streamBits(key, in.stream)) - 1.0F));
        }
    }

    void functionsFollowTheirScalarForm_data() { everyTarget_data(); }
    void functionsFollowTheirScalarForm()
    {
        QFETCH(QString, target);
        const SimdGuard guard;
        QVERIFY(forceSimdTarget(target.toStdString()).ok());
        std::array<float, kLaneCount> x{};
        for (std::size_t i = 0; i < kLaneCount; ++i) {
            x[i] = randomFloat(static_cast<std::uint32_t>(i));
        }
        MathRows rows{};
        HWY_DYNAMIC_DISPATCH(mathFormulas)
        (x, rows);
        for (std::size_t i = 0; i < kLaneCount; ++i) {
            QVERIFY(sameBits(rows.sine[i], portableSin(x[i])));
            QVERIFY(sameBits(rows.cosine[i], portableCos(x[i])));
            QVERIFY(sameBits(rows.exponential[i], portableExp(x[i])));
            QVERIFY(sameBits(rows.logarithm[i], portableLog(x[i])));
        }
    }
};

} // namespace tests
} // namespace fumage

QTEST_GUILESS_MAIN(fumage::tests::LanesTest)
#include "lanes_test.moc"
#endif
