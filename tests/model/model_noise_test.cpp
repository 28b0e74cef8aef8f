// The noise of the 2012 model: interpolation kinds, smooth function, octaves and sharpness, against values found by
// hand.

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

/// Standard deviation over some slices.
double deviation(const Noise& noise, int size)
{
    std::vector<float> all;
    for (const float depth : {0.05F, 0.3F, 0.55F, 0.8F}) {
        const NoiseTile tile = bakeFractal(noise, size, depth).value();
        all.insert(all.end(), tile.values.begin(), tile.values.end());
    }
    return std::sqrt(Moments::of(all).variance);
}

/// Root of the mean square difference of two tiles.
double difference(const NoiseTile& a, const NoiseTile& b)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        sum += std::pow(static_cast<double>(a.values[i]) - static_cast<double>(b.values[i]), 2.0);
    }
    return std::sqrt(sum / static_cast<double>(a.values.size()));
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
        for (const Interpolation kind :
            {Interpolation::Linear, Interpolation::Cosine, Interpolation::Cubic, Interpolation::Quintic}) {
            QVERIFY(near(
                valueNoise(latticeNoise(kind), 3, period, 2.0F, 5.0F, 1.0F), latticeValue(3, period, 2, 5, 1), 1e-6F));
        }
    }

    void valueNoiseIsBilinearBetween()
    {
        const LatticePeriod period{8, 8, 1};
        const auto v = [&](int x, int y) { return latticeValue(3, period, x, y, 0); };
        const float bottom = v(2, 5) + 0.25F * (v(3, 5) - v(2, 5));
        const float top = v(2, 6) + 0.25F * (v(3, 6) - v(2, 6));
        QVERIFY(near(valueNoise(latticeNoise(Interpolation::Linear), 3, period, 2.25F, 5.5F, 0.0F),
            0.5F * (bottom + top), 1e-6F));
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
        QVERIFY(near(
            smoothedLatticeValue(9, period, 0, 0, 0, 1.0F), corners / 16.0F + edges / 8.0F + v(0, 0) / 4.0F, 1e-6F));
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

    void contrastDoesNotDependOnTheSize_data()
    {
        QTest::addColumn<int>("basis");
        QTest::newRow("lattice") << int(NoiseBasis::Lattice);
        QTest::newRow("gradient") << int(NoiseBasis::Gradient);
        QTest::newRow("simplex") << int(NoiseBasis::Simplex);
    }
    void contrastDoesNotDependOnTheSize()
    {
        QFETCH(int, basis);
        Noise noise = latticeNoise(Interpolation::Quintic);
        noise.basis = static_cast<NoiseBasis>(basis);
        noise.octaves = 6;
        noise.wavelength = 0.05F; // 20 cells, and 640 in the last octave: a tile of 64 pixels shows two of six
        const double expected = deviation(noise, 1024);
        for (const int size : {64, 100, 128, 256, 512}) {
            const double seen = deviation(noise, size);
            QVERIFY2(std::abs(seen / expected - 1.0) < 0.03,
                qPrintable(QString("%1 at %2 pixels, %3 at 1024").arg(seen).arg(size).arg(expected)));
        }
    }

    void everyStepOfTheWavelengthChangesTheTile()
    {
        Noise noise = latticeNoise(Interpolation::Quintic);
        for (int percent = 100; percent > 10; --percent) {
            noise.wavelength = static_cast<float>(percent) / 100.0F;
            const NoiseTile tile = bakeFractal(noise, 48, 0.3F).value();
            noise.wavelength = static_cast<float>(percent - 1) / 100.0F;
            const double step = difference(tile, bakeFractal(noise, 48, 0.3F).value());
            QVERIFY2(step > 0.003, qPrintable(QString("%1 from %2 %").arg(step).arg(percent)));
        }
    }

    void everyStepOfTheLacunarityChangesTheTile()
    {
        Noise noise = latticeNoise(Interpolation::Quintic);
        noise.octaves = 3;
        for (int percent = 150; percent < 300; ++percent) {
            noise.lacunarity = static_cast<float>(percent) / 100.0F;
            const NoiseTile tile = bakeFractal(noise, 48, 0.3F).value();
            noise.lacunarity = static_cast<float>(percent + 1) / 100.0F;
            const double step = difference(tile, bakeFractal(noise, 48, 0.3F).value());
            QVERIFY2(step > 0.001, qPrintable(QString("%1 from %2 %").arg(step).arg(percent)));
        }
    }

    void smallStepsChangeTheTileALittle_data()
    {
        QTest::addColumn<int>("basis");
        QTest::newRow("lattice") << int(NoiseBasis::Lattice);
        QTest::newRow("gradient") << int(NoiseBasis::Gradient);
        QTest::newRow("simplex") << int(NoiseBasis::Simplex);
    }
    void smallStepsChangeTheTileALittle()
    {
        QFETCH(int, basis);
        constexpr float kStep = 1.0005F;
        Noise noise = latticeNoise(Interpolation::Quintic);
        noise.basis = static_cast<NoiseBasis>(basis);
        noise.octaves = 4;
        // Every member on its way past whole frequencies, also of octaves that become too fine for the tile.
        const auto sweep = [&](float Noise::*member, float from, float to) {
            Noise at = noise;
            for (at.*member = from; at.*member < to; at.*member *= kStep) {
                const NoiseTile tile = bakeFractal(at, 32, 0.3F).value();
                Noise next = at;
                next.*member *= kStep;
                const double step = difference(tile, bakeFractal(next, 32, 0.3F).value());
                if (step > 0.02) {
                    qWarning("%g at %g", step, static_cast<double>(at.*member));
                    return false;
                }
            }
            return true;
        };
        QVERIFY(sweep(&Noise::wavelength, 0.1F, 1.0F));
        QVERIFY(sweep(&Noise::lacunarity, 1.5F, 3.0F));
        QVERIFY(sweep(&Noise::depth, 1.0F, 5.0F));
    }

    void betweenWholeFrequenciesContrastIsTheSameEverywhere()
    {
        // Were the two lattices of a blend alike near the origin, the first quarter would have more contrast than the
        // last.
        Noise noise = latticeNoise(Interpolation::Quintic);
        noise.basis = NoiseBasis::Gradient;
        noise.depth = 2.5F;
        noise.wavelength = 1.0F / 4.5F;
        constexpr int kEdge = 32;
        double first = 0.0;
        double last = 0.0;
        for (std::uint32_t seed = 1; seed <= 400; ++seed) {
            noise.seed = seed;
            const NoiseTile tile = bakeFractal(noise, kEdge, 0.05F).value();
            for (int y = 0; y < kEdge / 2; ++y) {
                for (int x = 0; x < kEdge / 2; ++x) {
                    first += std::pow(static_cast<double>(tile.at(x, y)), 2.0);
                    last += std::pow(static_cast<double>(tile.at(x + kEdge / 2, y + kEdge / 2)), 2.0);
                }
            }
        }
        QVERIFY2(std::abs(std::sqrt(first / last) - 1.0) < 0.05, qPrintable(QString::number(std::sqrt(first / last))));
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
                const float value =
                    valueNoise(noise, octave.seed, octave.period, (static_cast<float>(x) + 0.5F) * scale,
                        (static_cast<float>(y) + 0.5F) * scale, 0.2F * static_cast<float>(octave.period.z));
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
        for (const auto& [name, kind] : {std::pair{"linear", Interpolation::Linear}, {"cosine", Interpolation::Cosine},
                 {"cubic", Interpolation::Cubic}, {"quintic", Interpolation::Quintic}}) {
            for (const float smooth : {0.0F, 0.7F}) {
                QTest::addRow("%s, smooth %g, on a plane", name, static_cast<double>(smooth))
                    << int(kind) << smooth << 0.5F;
                QTest::addRow("%s, smooth %g, between planes", name, static_cast<double>(smooth))
                    << int(kind) << smooth << 0.3F;
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
                    const float value =
                        valueNoise(noise, octave.seed, octave.period, (static_cast<float>(x) + 0.5F) * scale,
                            (static_cast<float>(y) + 0.5F) * scale, depth * static_cast<float>(octave.period.z));
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
