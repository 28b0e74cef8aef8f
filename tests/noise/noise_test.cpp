#include "tests/helpers.h"
#include "tests/noise/obvious_simplex.h"

#include "core/noise/texture.h"

#include <cmath>

using namespace fumage;
using namespace fumage::tests;

namespace {

Noise plain(NoiseBasis basis)
{
    Noise noise;
    noise.basis = basis;
    noise.octaves = 4;
    noise.wavelength = 0.25F;
    noise.warp = 0.0F;
    return noise;
}

/// Largest step between neighbouring pixels, inside and across the seam.
struct Steps {
    float inside = 0.0F;
    float seam = 0.0F;

    explicit Steps(const NoiseTile& tile)
    {
        const int n = tile.size;
        for (int i = 0; i < n; ++i) {
            for (int j = 0; j + 1 < n; ++j) {
                inside = std::max(
                    {inside, std::abs(tile.at(j, i) - tile.at(j + 1, i)), std::abs(tile.at(i, j) - tile.at(i, j + 1))});
            }
            seam = std::max(
                {seam, std::abs(tile.at(0, i) - tile.at(n - 1, i)), std::abs(tile.at(i, 0) - tile.at(i, n - 1))});
        }
    }
};

} // namespace

class NoiseTest : public QObject {
    Q_OBJECT

private slots:
    void tilesHaveNoSeam_data()
    {
        QTest::addColumn<int>("basis");
        QTest::addColumn<int>("size");
        for (const int size : {17, 64, 100, 129}) {
            QTest::addRow("lattice %d", size) << int(NoiseBasis::Lattice) << size;
            QTest::addRow("gradient %d", size) << int(NoiseBasis::Gradient) << size;
            QTest::addRow("simplex %d", size) << int(NoiseBasis::Simplex) << size;
        }
    }
    void tilesHaveNoSeam()
    {
        QFETCH(int, basis);
        QFETCH(int, size);
        Noise noise = plain(static_cast<NoiseBasis>(basis));
        for (const float wavelength : {0.25F, 0.29F}) {
            for (const float warp : {0.0F, 0.3F}) {
                noise.wavelength = wavelength;
                noise.warp = warp;
                const Steps steps(bakeNoise(noise, size, 0.3F).value());
                QVERIFY(steps.inside > 0.0F);
                QVERIFY2(steps.seam <= steps.inside * 1.05F,
                    qPrintable(QString("seam %1 inside %2").arg(steps.seam).arg(steps.inside)));
            }
        }
    }

    void slicesCloseTheirLoopInDepth()
    {
        for (const NoiseBasis basis : {NoiseBasis::Lattice, NoiseBasis::Gradient, NoiseBasis::Simplex}) {
            const NoiseTile first = bakeNoise(plain(basis), 48, 0.0F).value();
            const NoiseTile last = bakeNoise(plain(basis), 48, 1.0F).value();
            QVERIFY(sameBits(first.values, last.values));
        }
    }

    void slicesChangeSmoothlyWithDepth()
    {
        for (const NoiseBasis basis : {NoiseBasis::Lattice, NoiseBasis::Gradient, NoiseBasis::Simplex}) {
            const auto difference = [&](float a, float b) {
                const NoiseTile x = bakeFractal(plain(basis), 48, a).value();
                const NoiseTile y = bakeFractal(plain(basis), 48, b).value();
                double sum = 0.0;
                for (std::size_t i = 0; i < x.values.size(); ++i) {
                    sum += std::abs(static_cast<double>(x.values[i]) - static_cast<double>(y.values[i]));
                }
                return sum / static_cast<double>(x.values.size());
            };
            QVERIFY(difference(0.3F, 0.301F) > 0.0);
            QVERIFY(difference(0.3F, 0.301F) < 0.2 * difference(0.3F, 0.7F));
        }
    }

    void everySizeAndOctaveCountBakes()
    {
        for (const NoiseBasis basis : {NoiseBasis::Lattice, NoiseBasis::Gradient, NoiseBasis::Simplex}) {
            for (const int size : {1, 2, 3, 15, 16, 31, 33}) {
                Noise noise = plain(basis);
                noise.octaves = 10;
                noise.wavelength = 0.005F;
                noise.warp = 0.2F;
                const NoiseTile tile = bakeNoise(noise, size, 0.1F).value();
                QCOMPARE(tile.values.size(), static_cast<std::size_t>(size * size));
                for (const float value : tile.values) {
                    QVERIFY(value >= 0.0F && value <= 1.0F);
                }
            }
        }
    }

    void octavesHaveAComparableSpread()
    {
        // The scales of gradient and simplex noise are set so that one octave has a standard deviation of about 1/3.
        for (const NoiseBasis basis : {NoiseBasis::Gradient, NoiseBasis::Simplex}) {
            Noise noise = plain(basis);
            noise.octaves = 1;
            noise.wavelength = 1.0F / 64.0F;
            std::vector<float> all;
            for (const float depth : {0.03F, 0.21F, 0.47F, 0.81F}) {
                const NoiseTile tile = bakeFractal(noise, 512, depth).value();
                all.insert(all.end(), tile.values.begin(), tile.values.end());
            }
            const Moments m = Moments::of(all);
            QVERIFY2(std::abs(m.mean) < 0.02, qPrintable(QString::number(m.mean)));
            QVERIFY2(
                std::abs(std::sqrt(m.variance) - 1.0 / 3.0) < 0.04, qPrintable(QString::number(std::sqrt(m.variance))));
        }
    }

    void simplexNoiseIsTheSumOverTheCornersOfItsSimplices()
    {
        constexpr double kScale = 90.0; // makes the standard deviation about 1/3
        // Cells of whole (even and odd) and of broken numbers of pixels, wide and narrow; one cell, and one a pixel.
        for (const auto& [size, cells] :
            {std::pair{64, 2}, {48, 16}, {45, 15}, {75, 20}, {50, 49}, {33, 33}, {200, 100}, {19, 1}}) {
            for (const float depth : {0.0F, 0.11F, 0.3F, 0.5F, 0.97F}) {
                Noise noise = plain(NoiseBasis::Simplex);
                noise.octaves = 1;
                noise.wavelength = 1.0F / static_cast<float>(cells);
                const NoiseTile tile = bakeFractal(noise, size, depth).value();
                const Octave octave = fractalOctaves(noise, size).front();
                QCOMPARE(octave.period.x, cells);
                const auto z = static_cast<double>(depth * static_cast<float>(octave.period.z));
                for (int y = 0; y < size; ++y) {
                    for (int x = 0; x < size; ++x) {
                        const double expected =
                            kScale * obviousSimplex(octave, (x + 0.5) * cells / size, (y + 0.5) * cells / size, z);
                        const double seen = tile.at(x, y);
                        QVERIFY2(std::abs(seen - expected) < 5e-6,
                            qPrintable(QString("%1 pixels, %2 cells, depth %3: %4 is not %5")
                                           .arg(size)
                                           .arg(cells)
                                           .arg(depth)
                                           .arg(seen)
                                           .arg(expected)));
                    }
                }
            }
        }
    }

    void coverageAndSharpnessShiftTheGreys()
    {
        Noise noise = plain(NoiseBasis::Gradient);
        const auto mean = [&] { return Moments::of(bakeNoise(noise, 64, 0.0F).value().values).mean; };
        noise.coverage = 0.2F;
        const double thin = mean();
        noise.coverage = 0.8F;
        QVERIFY(thin < 0.35 && mean() > 0.65);
    }

    void tooLargeAndCancelledAreErrors()
    {
        QCOMPARE(bakeNoise(Noise{}, 4097, 0.0F).error().code, ErrorCode::TooLarge);
        QCOMPARE(bakeNoise(Noise{}, 0, 0.0F).error().code, ErrorCode::TooLarge);
        std::stop_source stop;
        stop.request_stop();
        QCOMPARE(bakeNoise(Noise{}, 64, 0.0F, stop.get_token()).error().code, ErrorCode::Cancelled);
    }
};

QTEST_GUILESS_MAIN(NoiseTest)
#include "noise_test.moc"
