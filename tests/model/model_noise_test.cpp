// The noise of the 2012 model: interpolation kinds, smooth function, octaves and sharpness, against values found by hand.

#include "tests/helpers.h"

#include "core/noise/fractal.h"
#include "core/noise/texture.h"

#include <cmath>

using namespace fumage;
using namespace fumage::tests;

namespace {

Noise latticeNoise(Interpolation kind)
{
    Noise noise;
    noise.basis = NoiseBasis::Lattice;
    noise.interpolation = kind;
    noise.octaves = 1;
    noise.wavelength = 0.125F;
    noise.warp = 0.0F;
    noise.smooth = 0.0F;
    noise.sharpness = 1.0F;
    noise.coverage = 0.5F;
    return noise;
}

} // namespace

class ModelNoiseTest : public QObject {
    Q_OBJECT

private slots:
    void latticeValueIsFixedForASeed()
    {
        const LatticePeriod period{64, 64, 64};
        QCOMPARE(latticeValue(5, period, 3, 4, 0), latticeValue(5, period, 3, 4, 0));
        QVERIFY(latticeValue(5, period, 3, 4, 0) != latticeValue(6, period, 3, 4, 0));
        QVERIFY(latticeValue(5, period, 3, 4, 0) != latticeValue(5, period, 4, 3, 0));
    }

    void latticeValuesAreUniform()
    {
        const LatticePeriod period{256, 256, 1};
        std::vector<float> values;
        for (int y = 0; y < 256; ++y) {
            for (int x = 0; x < 256; ++x) {
                values.push_back(latticeValue(1, period, x, y, 0));
            }
        }
        const Moments m = Moments::of(values);
        QVERIFY(std::abs(m.mean - 0.5) < 5.0 * std::sqrt(1.0 / 12.0 / 65536.0));
        QVERIFY(std::abs(m.variance - 1.0 / 12.0) < 5.0 / 12.0 * std::sqrt(0.8 / 65536.0));
        QVERIFY(m.low >= 0.0 && m.high < 1.0);
    }

    void interpolationWeights_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<float>("quarter");
        QTest::newRow("linear") << int(Interpolation::Linear) << 0.25F;
        QTest::newRow("cosine") << int(Interpolation::Cosine) << 0.14644661F; // (1 - cos 45) / 2
        QTest::newRow("cubic") << int(Interpolation::Cubic) << 0.15625F; // 3/16 - 2/64
        QTest::newRow("quintic") << int(Interpolation::Quintic) << 0.10351563F; // 6/1024 - 15/256 + 10/64
    }
    void interpolationWeights()
    {
        QFETCH(int, kind);
        QFETCH(float, quarter);
        const auto k = static_cast<Interpolation>(kind);
        QVERIFY(near(interpolationWeight(k, 0.0F), 0.0F, 1e-7F));
        QVERIFY(near(interpolationWeight(k, 0.25F), quarter, 1e-6F));
        QVERIFY(near(interpolationWeight(k, 0.5F), 0.5F, 1e-6F));
        QVERIFY(near(interpolationWeight(k, 1.0F), 1.0F, 1e-6F));
    }

    void cubicGoesThroughItsPointsAndUsesTheOuterOnes()
    {
        QCOMPARE(interpolateCubic(9.0F, 2.0F, 5.0F, -3.0F, 0.0F), 2.0F);
        QCOMPARE(interpolateCubic(9.0F, 2.0F, 5.0F, -3.0F, 1.0F), 5.0F);
        // a = 0, b = 1, c = 2, d = 4: P = 2 - (-1) = 3, Q = -1 - 3 = -4, R = 2; at 1/2: 3/8 - 1 + 1 + 1 = 1.375.
        QVERIFY(near(interpolateCubic(0.0F, 1.0F, 2.0F, 4.0F, 0.5F), 1.375F, 1e-6F));
    }

    void valueNoiseMeetsTheLattice()
    {
        const LatticePeriod period{8, 8, 2};
        for (const Interpolation kind : {Interpolation::Linear, Interpolation::Cosine, Interpolation::Cubic, Interpolation::Quintic}) {
            QVERIFY(near(valueNoise(latticeNoise(kind), 3, period, 2.0F, 5.0F, 1.0F), latticeValue(3, period, 2, 5, 1), 1e-6F));
        }
    }

    void valueNoiseIsBilinearBetween()
    {
        const LatticePeriod period{8, 8, 1};
        const auto v = [&](int x, int y) { return latticeValue(3, period, x, y, 0); };
        const float bottom = v(2, 5) + 0.25F * (v(3, 5) - v(2, 5));
        const float top = v(2, 6) + 0.25F * (v(3, 6) - v(2, 6));
        QVERIFY(near(valueNoise(latticeNoise(Interpolation::Linear), 3, period, 2.25F, 5.5F, 0.0F), 0.5F * (bottom + top), 1e-6F));
    }

    void smoothKernelHasItsWeights()
    {
        const LatticePeriod period{16, 16, 1};
        const auto v = [&](int x, int y) { return latticeValue(9, period, x, y, 0); };
        const float corners = v(4, 4) + v(6, 4) + v(4, 6) + v(6, 6);
        const float edges = v(5, 4) + v(4, 5) + v(6, 5) + v(5, 6);
        const float smooth = corners / 16.0F + edges / 8.0F + v(5, 5) / 4.0F;
        QVERIFY(near(smoothedLatticeValue(9, period, 5, 5, 0, 1.0F), smooth, 1e-6F));
        QVERIFY(near(smoothedLatticeValue(9, period, 5, 5, 0, 0.5F), 0.5F * (smooth + v(5, 5)), 1e-6F));
        QCOMPARE(smoothedLatticeValue(9, period, 5, 5, 0, 0.0F), v(5, 5));
    }

    void smoothKernelWrapsAround()
    {
        const LatticePeriod period{16, 16, 1};
        const auto v = [&](int x, int y) { return latticeValue(9, period, x, y, 0); };
        const float corners = v(15, 15) + v(1, 15) + v(15, 1) + v(1, 1);
        const float edges = v(0, 15) + v(15, 0) + v(1, 0) + v(0, 1);
        QVERIFY(near(smoothedLatticeValue(9, period, 0, 0, 0, 1.0F), corners / 16.0F + edges / 8.0F + v(0, 0) / 4.0F, 1e-6F));
    }

    void octavesHaveTheirFrequenciesAndAmplitudes()
    {
        Noise noise = latticeNoise(Interpolation::Cosine);
        noise.octaves = 4;
        noise.wavelength = 0.25F;
        noise.persistence = 0.5F;
        noise.lacunarity = 2.0F;
        noise.depth = 3.0F;
        const std::vector<Octave> octaves = fractalOctaves(noise, 256);
        QCOMPARE(octaves.size(), std::size_t(4));
        for (std::size_t i = 0; i < 4; ++i) {
            QCOMPARE(octaves[i].period.x, 4 << i);
            QCOMPARE(octaves[i].period.y, 4 << i);
            QCOMPARE(octaves[i].period.z, 3 << i);
            QVERIFY(near(octaves[i].amplitude, 8.0F / 15.0F / static_cast<float>(1 << i), 1e-6F));
            for (std::size_t j = 0; j < i; ++j) {
                QVERIFY(octaves[i].seed != octaves[j].seed);
            }
        }
    }

    void octavesFinerThanAPixelAreLeftOut()
    {
        Noise noise = latticeNoise(Interpolation::Linear);
        noise.octaves = 8;
        noise.wavelength = 0.25F;
        QCOMPARE(fractalOctaves(noise, 16).size(), std::size_t(3)); // 4, 8 and 16 cells
    }

    void tileIsTheWeightedSumOfItsOctaves()
    {
        Noise noise = latticeNoise(Interpolation::Cosine);
        noise.octaves = 3;
        noise.persistence = 0.6F;
        constexpr int kSize = 48;
        const NoiseTile tile = bakeFractal(noise, kSize, 0.2F).value();
        const std::vector<Octave> octaves = fractalOctaves(noise, kSize);
        for (const auto& [x, y] : {std::pair{0, 0}, std::pair{17, 5}, std::pair{47, 47}, std::pair{30, 1}}) {
            float sum = 0.0F;
            for (const Octave& octave : octaves) {
                const float scale = static_cast<float>(octave.period.x) / kSize;
                const float value = valueNoise(noise, octave.seed, octave.period, (static_cast<float>(x) + 0.5F) * scale, (static_cast<float>(y) + 0.5F) * scale, 0.2F * static_cast<float>(octave.period.z));
                sum += octave.amplitude * (2.0F * value - 1.0F);
            }
            QVERIFY(near(tile.at(x, y), sum, 2e-5F));
        }
    }

    void everyInterpolationKindBakesWhatItDescribes_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<float>("smooth");
        QTest::addColumn<float>("depth");
        for (const auto& [name, kind] : {std::pair{"linear", Interpolation::Linear}, {"cosine", Interpolation::Cosine}, {"cubic", Interpolation::Cubic}, {"quintic", Interpolation::Quintic}}) {
            for (const float smooth : {0.0F, 0.7F}) {
                QTest::addRow("%s, smooth %g, on a layer", name, static_cast<double>(smooth)) << int(kind) << smooth << 0.5F;
                QTest::addRow("%s, smooth %g, between layers", name, static_cast<double>(smooth)) << int(kind) << smooth << 0.3F;
            }
        }
    }
    void everyInterpolationKindBakesWhatItDescribes()
    {
        QFETCH(int, kind);
        QFETCH(float, smooth);
        QFETCH(float, depth);
        // Cells of whole and of broken numbers of pixels, narrower and wider than a vector; one cell, and one a pixel.
        for (const auto& [size, cells] : {std::pair{40, 8}, {37, 5}, {96, 2}, {50, 49}, {33, 33}, {19, 1}}) {
            Noise noise = latticeNoise(static_cast<Interpolation>(kind));
            noise.smooth = smooth;
            noise.wavelength = 1.0F / static_cast<float>(cells);
            const NoiseTile tile = bakeFractal(noise, size, depth).value();
            const Octave octave = fractalOctaves(noise, size).front();
            QCOMPARE(octave.period.x, cells);
            const float scale = static_cast<float>(cells) / static_cast<float>(size);
            for (int y = 0; y < size; ++y) {
                for (int x = 0; x < size; ++x) {
                    const float value = valueNoise(noise, octave.seed, octave.period, (static_cast<float>(x) + 0.5F) * scale, (static_cast<float>(y) + 0.5F) * scale, depth * static_cast<float>(octave.period.z));
                    QVERIFY(near(tile.at(x, y), 2.0F * value - 1.0F, 2e-5F));
                }
            }
        }
    }

    void sharpnessRaisesContrastAboutTheMiddle()
    {
        QCOMPARE(sharpen(0.5F, 3.0F, 0.5F), 0.5F);
        QVERIFY(near(sharpen(0.6F, 2.0F, 0.5F), 0.7F, 1e-6F));
        QVERIFY(near(sharpen(0.4F, 2.0F, 0.5F), 0.3F, 1e-6F));
        QVERIFY(near(sharpen(0.3F, 1.0F, 0.5F), 0.3F, 1e-6F));
        QCOMPARE(sharpen(0.9F, 5.0F, 0.5F), 1.0F);
        QCOMPARE(sharpen(0.1F, 5.0F, 0.5F), 0.0F);
        QVERIFY(near(sharpen(0.5F, 2.0F, 0.7F), 0.7F, 1e-6F));
    }
};

QTEST_GUILESS_MAIN(ModelNoiseTest)
#include "model_noise_test.moc"
