#include "core/noise/octave_rows.h"

#include "core/noise/row_kernel.h"

#include <cmath>
#include <limits>

namespace fumage {

namespace {

constexpr int kNoRow = std::numeric_limits<int>::min();

/// Memory for a number of rows of lattice points, with their margins.
class RowMemory {
public:
    RowMemory(const LatticePeriod& period, std::size_t rows)
        : m_stride(roundUp(kRowMargin + static_cast<std::size_t>(period.x) + kRowPadding, RowPositions::kBlock))
        , m_storage(rows * m_stride, 0.0F)
    {
    }

    [[nodiscard]] float* row(std::size_t i) { return m_storage.data() + i * m_stride + kRowMargin; }

private:
    std::size_t m_stride;
    AlignedArray<float> m_storage;
};

/// Which row of lattice points is kept where: in places that rows take in turn, so that as many neighbours never meet.
template <std::size_t kPlaces>
class RowPlaces {
public:
    /// Calls fill(place) where the row is not there yet.
    /// @return the place of a row, which need not lie within the period
    template <class Fill>
    std::size_t find(int row, const Fill& fill)
    {
        const std::size_t place = static_cast<unsigned>(row) % kPlaces;
        if (m_rows[place] != row) {
            fill(place);
            m_rows[place] = row;
        }
        return place;
    }

private:
    std::array<int, kPlaces> m_rows = [] {
        std::array<int, kPlaces> rows{};
        rows.fill(kNoRow);
        return rows;
    }();
};

class GradientOctave : public OctaveRows {
public:
    explicit GradientOctave(const OctaveSlice& slice)
        : m_slice(slice)
        , m_layer(static_cast<int>(slice.z))
        , m_fractionZ(slice.z - std::floor(slice.z))
        , m_memory(slice.octave.period, 3 * kRows + 4)
    {
        for (std::size_t i = 0; i < m_rows.size(); ++i) {
            m_rows[i] = {m_memory.row(3 * i), m_memory.row(3 * i + 1), m_memory.row(3 * i + 2)};
        }
        const std::size_t used = 3 * m_rows.size();
        m_coefficients = {m_memory.row(used), m_memory.row(used + 1), m_memory.row(used + 2), m_memory.row(used + 3)};
    }

    void add(int row, float* values) override
    {
        const float y = (static_cast<float>(row) + 0.5F) * m_slice.cellsAPixel;
        const int below = static_cast<int>(y);
        const float fy = y - static_cast<float>(below);
        const Interpolation kind = m_slice.noise.interpolation;
        fillGradientCoefficients(lattice(below), lattice(below + 1), fy, interpolationWeight(kind, fy), m_slice.octave.amplitude, m_slice.octave.period.x, m_coefficients);
        addRow(m_slice.positions, m_coefficients, values);
    }

private:
    static constexpr std::size_t kRows = 2;

    const GradientRow& lattice(int row)
    {
        const Octave& octave = m_slice.octave;
        return m_rows[m_places.find(row, [&](std::size_t place) {
            const std::array<int, 2> layers{m_layer % octave.period.z, (m_layer + 1) % octave.period.z};
            fillGradientRow(octave, wrapped(row, octave.period.y), layers, m_fractionZ, interpolationWeight(m_slice.noise.interpolation, m_fractionZ), m_rows[place]);
        })];
    }

    const OctaveSlice& m_slice;
    int m_layer;
    float m_fractionZ;
    RowMemory m_memory;
    std::array<GradientRow, kRows> m_rows{};
    RowPlaces<kRows> m_places;
    RowCoefficients m_coefficients{};
};

/// Values interpolated in y, then z, at lattice columns, and along x last: the order of valueNoise().
class ValueOctave : public OctaveRows {
public:
    explicit ValueOctave(const OctaveSlice& slice)
        : m_slice(slice)
        , m_memory(slice.octave.period, 2 * kMost * kMost + 4)
    {
        const auto layer = static_cast<int>(slice.z);
        const float fraction = slice.z - std::floor(slice.z);
        m_around.cubic = slice.noise.interpolation == Interpolation::Cubic;
        m_around.flat = fraction == 0.0F;
        m_around.alongZ = place(fraction);
        m_layers = m_around.flat ? 1 : points();
        m_firstLayer = m_around.flat ? layer : layer - before();
        const std::size_t used = 2 * kMost * kMost;
        m_coefficients = {m_memory.row(used), m_memory.row(used + 1), m_memory.row(used + 2), m_memory.row(used + 3)};
    }

    void add(int row, float* values) override
    {
        const float y = (static_cast<float>(row) + 0.5F) * m_slice.cellsAPixel;
        const int below = static_cast<int>(y);
        m_around.alongY = place(y - static_cast<float>(below));
        for (std::size_t k = 0; k < m_layers; ++k) {
            for (std::size_t j = 0; j < points(); ++j) {
                m_around.rows[k][j] = smooth(k, below - before() + static_cast<int>(j));
            }
        }
        fillValueCoefficients(m_around, m_slice.octave.amplitude, m_slice.octave.period.x, m_coefficients);
        (m_around.cubic ? addRow : addFlatRow)(m_slice.positions, m_coefficients, values);
    }

private:
    static constexpr std::size_t kMost = 4; ///< rows or layers, for cubic

    [[nodiscard]] std::size_t points() const { return m_around.cubic ? 4 : 2; }
    [[nodiscard]] int before() const { return m_around.cubic ? 1 : 0; }
    [[nodiscard]] float place(float t) const { return m_around.cubic ? t : interpolationWeight(m_slice.noise.interpolation, t); }

    const float* plain(std::size_t layer, int row)
    {
        const auto memory = [&](std::size_t place) { return m_memory.row(2 * (layer * kMost + place)); };
        return memory(m_plain[layer].find(row, [&](std::size_t place) {
            const LatticePeriod& period = m_slice.octave.period;
            fillValueRow(m_slice.octave, wrapped(row, period.y), wrapped(m_firstLayer + static_cast<int>(layer), period.z), memory(place));
        }));
    }

    const float* smooth(std::size_t layer, int row)
    {
        const float amount = m_slice.noise.smooth;
        if (amount == 0.0F) {
            return plain(layer, row);
        }
        const auto memory = [&](std::size_t place) { return m_memory.row(2 * (layer * kMost + place) + 1); };
        return memory(m_smooth[layer].find(row, [&](std::size_t place) {
            smoothValueRow({plain(layer, row - 1), plain(layer, row), plain(layer, row + 1)}, amount, m_slice.octave.period.x, memory(place));
        }));
    }

    const OctaveSlice& m_slice;
    RowMemory m_memory;
    ValueRows m_around;
    std::size_t m_layers = 1;
    int m_firstLayer = 0;
    std::array<RowPlaces<kMost>, kMost> m_plain;
    std::array<RowPlaces<kMost>, kMost> m_smooth;
    RowCoefficients m_coefficients{};
};

class SimplexOctave : public OctaveRows {
public:
    explicit SimplexOctave(const OctaveSlice& slice)
        : m_slice(slice)
    {
    }

    void add(int row, float* values) override { addSimplexRow(m_slice.octave, m_slice.size, (static_cast<float>(row) + 0.5F) * m_slice.cellsAPixel, m_slice.z, values); }

private:
    const OctaveSlice& m_slice;
};

} // namespace

OctaveSlice octaveSlice(const Noise& noise, const Octave& octave, int size, float depth)
{
    OctaveSlice slice{noise, octave, size, static_cast<float>(octave.period.y) / static_cast<float>(size), depth * static_cast<float>(octave.period.z), {}};
    if (noise.basis == NoiseBasis::Simplex) {
        return slice;
    }
    slice.positions = rowPositions(size, octave.period.x, CellBorders::OnPoints);
    if (noise.basis == NoiseBasis::Lattice && noise.interpolation == Interpolation::Cubic) {
        weighBySquare(slice.positions);
    } else {
        weighByInterpolation(slice.positions, noise.interpolation);
    }
    return slice;
}

std::unique_ptr<OctaveRows> OctaveRows::of(const OctaveSlice& slice)
{
    switch (slice.noise.basis) {
    case NoiseBasis::Lattice: return std::make_unique<ValueOctave>(slice);
    case NoiseBasis::Gradient: return std::make_unique<GradientOctave>(slice);
    case NoiseBasis::Simplex: break;
    }
    return std::make_unique<SimplexOctave>(slice);
}

} // namespace fumage
