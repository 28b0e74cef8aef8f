#include "core/noise/octave_rows.h"

#include "core/noise/row_kernel.h"
#include "core/noise/simplex_kernel.h"

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
        , m_plane(static_cast<int>(slice.z))
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
        fillGradientCoefficients(lattice(below), lattice(below + 1), fy, interpolationWeight(kind, fy),
            m_slice.octave.amplitude, m_slice.octave.period.x, m_coefficients);
        addRow(m_slice.positions, m_coefficients, values);
    }

private:
    static constexpr std::size_t kRows = 2;

    const GradientRow& lattice(int row)
    {
        const Octave& octave = m_slice.octave;
        return m_rows[m_places.find(row, [&](std::size_t place) {
            const std::array<int, 2> planes{m_plane % octave.period.z, (m_plane + 1) % octave.period.z};
            fillGradientRow(octave, wrapped(row, octave.period.y), planes, m_fractionZ,
                interpolationWeight(m_slice.noise.interpolation, m_fractionZ), m_rows[place]);
        })];
    }

    const OctaveSlice& m_slice;
    int m_plane;
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
        , m_memory(slice.octave.period, 2 * kMax * kMax + 4)
    {
        const auto plane = static_cast<int>(slice.z);
        const float fraction = slice.z - std::floor(slice.z);
        m_around.cubic = slice.noise.interpolation == Interpolation::Cubic;
        m_around.flat = fraction == 0.0F;
        m_around.alongZ = place(fraction);
        m_planes = m_around.flat ? 1 : points();
        m_firstPlane = m_around.flat ? plane : plane - before();
        const std::size_t used = 2 * kMax * kMax;
        m_coefficients = {m_memory.row(used), m_memory.row(used + 1), m_memory.row(used + 2), m_memory.row(used + 3)};
    }

    void add(int row, float* values) override
    {
        const float y = (static_cast<float>(row) + 0.5F) * m_slice.cellsAPixel;
        const int below = static_cast<int>(y);
        m_around.alongY = place(y - static_cast<float>(below));
        for (std::size_t k = 0; k < m_planes; ++k) {
            for (std::size_t j = 0; j < points(); ++j) {
                m_around.rows[k][j] = smooth(k, below - before() + static_cast<int>(j));
            }
        }
        fillValueCoefficients(m_around, m_slice.octave.amplitude, m_slice.octave.period.x, m_coefficients);
        (m_around.cubic ? addRow : addFlatRow)(m_slice.positions, m_coefficients, values);
    }

private:
    static constexpr std::size_t kMax = 4; ///< rows or planes, for cubic

    [[nodiscard]] std::size_t points() const { return m_around.cubic ? 4 : 2; }
    [[nodiscard]] int before() const { return m_around.cubic ? 1 : 0; }
    [[nodiscard]] float place(float t) const
    {
        return m_around.cubic ? t : interpolationWeight(m_slice.noise.interpolation, t);
    }

    const float* plain(std::size_t plane, int row)
    {
        const auto memory = [&](std::size_t place) { return m_memory.row(2 * (plane * kMax + place)); };
        return memory(m_plain[plane].find(row, [&](std::size_t place) {
            const LatticePeriod& period = m_slice.octave.period;
            fillValueRow(m_slice.octave, wrapped(row, period.y),
                wrapped(m_firstPlane + static_cast<int>(plane), period.z), memory(place));
        }));
    }

    const float* smooth(std::size_t plane, int row)
    {
        const float amount = m_slice.noise.smooth;
        if (amount == 0.0F) {
            return plain(plane, row);
        }
        const auto memory = [&](std::size_t place) { return m_memory.row(2 * (plane * kMax + place) + 1); };
        return memory(m_smooth[plane].find(row, [&](std::size_t place) {
            smoothValueRow({plain(plane, row - 1), plain(plane, row), plain(plane, row + 1)}, amount,
                m_slice.octave.period.x, memory(place));
        }));
    }

    const OctaveSlice& m_slice;
    RowMemory m_memory;
    ValueRows m_around;
    std::size_t m_planes = 1;
    int m_firstPlane = 0;
    std::array<RowPlaces<kMax>, kMax> m_plain;
    std::array<RowPlaces<kMax>, kMax> m_smooth;
    RowCoefficients m_coefficients{};
};

/// A sum over the lattice points around, line by line of them along x: all that a line has in common, its distance
/// above all, is found once a row.
class SimplexOctave : public OctaveRows {
public:
    explicit SimplexOctave(const OctaveSlice& slice)
        : m_slice(slice)
        , m_memory(slice.octave.period, 3 * kMaxPlanes * kRows + 1)
        , m_height(m_memory.row(3 * kMaxPlanes * kRows))
    {
        const auto nearest = static_cast<int>(2.0F * slice.z);
        for (int z = nearest - 1; z <= nearest + 2; ++z) {
            const float dz = slice.z - 0.5F * static_cast<float>(z);
            if (dz * dz < kReach) {
                Plane plane{wrapped(z, 2 * slice.octave.period.z), z % 2 != 0, dz, {}, {}};
                for (std::size_t i = 0; i < kRows; ++i) {
                    const std::size_t first = 3 * (m_planes.size() * kRows + i);
                    plane.lines[i] = {m_memory.row(first), m_memory.row(first + 1), m_memory.row(first + 2)};
                }
                m_planes.push_back(plane);
            }
        }
    }

    void add(int row, float* values) override
    {
        for (Plane& plane : m_planes) {
            const CellPlace y = placeInCells(row, m_slice.size, m_slice.octave.period.y,
                plane.between ? CellBorders::BetweenPoints : CellBorders::OnPoints);
            const int below = plane.between ? y.cell - 1 : y.cell;
            addLine(plane, below, y.fraction, values);
            addLine(plane, below + 1, y.fraction - 1.0F, values);
        }
    }

private:
    static constexpr float kReach = 0.5F; ///< square of the way to the furthest point that counts
    static constexpr std::size_t kMaxPlanes = 3; ///< that are less than sqrt(1/2) away and half a unit apart
    static constexpr std::size_t kRows = 2;

    /// Lines of one z, a unit apart in y.
    struct Plane {
        int z = 0; ///< in halves, within the period
        bool between = false; ///< lines and their points lie half a unit from whole places
        float dz = 0.0F;
        RowPlaces<kRows> places;
        std::array<GradientRow, kRows> lines{};
    };

    void addLine(Plane& plane, int row, float dy, float* values)
    {
        const float reach = kReach - (dy * dy + plane.dz * plane.dz);
        if (reach <= 0.0F) {
            return;
        }
        const LatticePeriod& period = m_slice.octave.period;
        const GradientRow& line = plane.lines[plane.places.find(row, [&](std::size_t place) {
            const int y = 2 * wrapped(row, period.y) + (plane.between ? 1 : 0);
            fillSimplexLine(m_slice.octave, {y, plane.z, plane.between}, plane.lines[place]);
        })];
        fillSimplexHeights(line, dy, plane.dz, period.x, m_height);
        // A point more than half a cell away is out of reach where its line is that far away: only the nearest one
        // counts.
        if (reach <= 0.25F) {
            addNearestPoints(plane.between ? m_slice.positions : m_slice.around, line.x, m_height, reach, values);
        } else if (plane.between) {
            addPairsOfPoints(m_slice.around, line.x - 1, m_height - 1, reach, values);
        } else {
            addPairsOfPoints(m_slice.positions, line.x, m_height, reach, values);
        }
    }

    const OctaveSlice& m_slice;
    RowMemory m_memory;
    float* m_height;
    std::vector<Plane> m_planes;
};

} // namespace

OctaveSlice octaveSlice(const Noise& noise, const Octave& octave, int size, float depth)
{
    OctaveSlice slice{noise, octave, size, static_cast<float>(octave.period.y) / static_cast<float>(size),
        depth * static_cast<float>(octave.period.z), {}, {}};
    slice.positions = rowPositions(size, octave.period.x, CellBorders::OnPoints);
    if (noise.basis == NoiseBasis::Simplex) {
        slice.around = rowPositions(size, octave.period.x, CellBorders::BetweenPoints);
    } else if (noise.basis == NoiseBasis::Lattice && noise.interpolation == Interpolation::Cubic) {
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
