#include "core/noise/texture.h"

#include "core/base/hash.h"
#include "core/base/parallel.h"
#include "core/noise/row_kernel.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace fumage {

namespace {

/// Rows that one task bakes: enough to reuse lattice rows, few enough to share the work.
constexpr int kRowsATask = 128;

constexpr std::size_t kVectorPadding = 2 * kAlignment / sizeof(float);

/// One octave with everything that does not change from row to row.
class OctaveBaker {
public:
    OctaveBaker(const Noise& noise, const Octave& octave, int size, float depth)
        : m_noise(noise)
        , m_octave(octave)
        , m_size(size)
        , m_cellsAPixel(static_cast<float>(octave.period.y) / static_cast<float>(size))
        , m_z(depth * static_cast<float>(octave.period.z))
    {
        if (noise.basis != NoiseBasis::Simplex) {
            const bool cubicValues = noise.basis == NoiseBasis::Lattice && noise.interpolation == Interpolation::Cubic;
            m_positions = rowPositions(size, octave.period.x, noise.interpolation, cubicValues);
        }
        m_layer = static_cast<int>(m_z);
        m_fractionZ = m_z - std::floor(m_z);
    }

    /// Buffers of one task.
    struct Workspace {
        AlignedArray<float> storage; ///< of all rows
        LatticeRow below;
        LatticeRow above;
        RowCoefficients coefficients;
        float* line; ///< values at lattice columns
    };

    [[nodiscard]] Workspace workspace() const
    {
        Workspace out;
        const std::size_t padded = roundUp(static_cast<std::size_t>(m_octave.period.x) + kVectorPadding, RowPositions::kBlock);
        float** rows[] = {&out.below.x, &out.below.y, &out.below.z, &out.above.x, &out.above.y, &out.above.z,
            &out.coefficients.c0, &out.coefficients.c1, &out.coefficients.d0, &out.coefficients.d1, &out.line};
        out.storage.assign(std::size(rows) * padded, 0.0F);
        float* at = out.storage.data();
        for (float** row : rows) {
            *row = at;
            at += padded;
        }
        return out;
    }

    void add(int row, Workspace& workspace, float* values) const
    {
        const float y = (static_cast<float>(row) + 0.5F) * m_cellsAPixel;
        switch (m_noise.basis) {
        case NoiseBasis::Simplex: addSimplexRow(m_octave, m_size, y, m_z, values); return;
        case NoiseBasis::Gradient: prepareGradients(y, workspace); break;
        case NoiseBasis::Lattice: prepareValues(y, workspace); break;
        }
        addRow(m_positions, workspace.coefficients, values);
    }

private:
    void prepareGradients(float y, Workspace& workspace) const
    {
        const int row = static_cast<int>(y);
        const int next = row + 1 < m_octave.period.y ? row + 1 : 0;
        if (workspace.below.row != row || workspace.above.row != next) {
            if (workspace.above.row == row) {
                std::swap(workspace.below, workspace.above);
            } else {
                fillRow(row, workspace.below);
            }
            fillRow(next, workspace.above);
        }
        const float fy = y - static_cast<float>(row);
        fillGradientCoefficients(workspace.below, workspace.above, fy, interpolationWeight(m_noise.interpolation, fy), m_octave.amplitude, m_octave.period.x, workspace.coefficients);
    }

    void fillRow(int row, LatticeRow& out) const
    {
        fillGradientRow(m_octave, row, {m_layer % m_octave.period.z, (m_layer + 1) % m_octave.period.z}, m_fractionZ, interpolationWeight(m_noise.interpolation, m_fractionZ), out);
        out.row = row;
    }

    /// Value noise along one row: values at lattice columns first, then the polynomial of each cell.
    void prepareValues(float y, Workspace& workspace) const
    {
        const int cells = m_octave.period.x;
        float* v = workspace.line;
        for (int i = 0; i < cells; ++i) {
            // At a lattice column only y and z are interpolated; the signed value is about 0 as that of gradients.
            v[i] = 2.0F * valueColumn(m_noise, m_octave.seed, m_octave.period, i, y, m_z) - 1.0F;
        }
        const auto at = [&](int i) { return v[(i + cells) % cells] * m_octave.amplitude; };
        RowCoefficients& out = workspace.coefficients;
        for (int i = 0; i < cells; ++i) {
            const auto c = static_cast<std::size_t>(i);
            out.c0[c] = at(i);
            if (m_noise.interpolation == Interpolation::Cubic) {
                const float a = at(i - 1);
                const float p = (at(i + 2) - at(i + 1)) - (a - at(i));
                out.c1[c] = at(i + 1) - a;
                out.d0[c] = (a - at(i)) - p;
                out.d1[c] = p;
            } else {
                out.c1[c] = 0.0F;
                out.d0[c] = at(i + 1) - at(i);
                out.d1[c] = 0.0F;
            }
        }
    }

    const Noise& m_noise;
    const Octave& m_octave;
    int m_size;
    float m_cellsAPixel;
    float m_z;
    int m_layer = 0;
    float m_fractionZ = 0.0F;
    RowPositions m_positions;
};

Error cancelled()
{
    return {ErrorCode::Cancelled, "baking the noise was cancelled", "", ""};
}

/// Calls body(row) for all rows of a tile in parallel blocks, each of which has its own state from makeState().
template <class MakeState, class Body>
void forRows(int size, const std::stop_token& stop, const MakeState& makeState, const Body& body)
{
    const int tasks = (size + kRowsATask - 1) / kRowsATask;
    parallelFor(static_cast<std::size_t>(tasks), [&](std::size_t task) {
        auto state = makeState();
        const int first = static_cast<int>(task) * kRowsATask;
        const int last = std::min(size, first + kRowsATask);
        for (int row = first; row < last && !stop.stop_requested(); ++row) {
            body(row, state);
        }
    });
}

int wrapped(int i, int size)
{
    const int rest = i % size;
    return rest < 0 ? rest + size : rest;
}

/// Catmull-Rom weights of four neighbours at t between the middle two (Keys 1981, a = -1/2).
std::array<float, 4> cubicWeights(float t)
{
    const float t2 = t * t;
    const float t3 = t2 * t;
    return {0.5F * (-t3 + 2.0F * t2 - t), 0.5F * (3.0F * t3 - 5.0F * t2 + 2.0F), 0.5F * (-3.0F * t3 + 4.0F * t2 + t), 0.5F * (t3 - t2)};
}

/// A repeating tile between its pixels.
float sampleCubic(const NoiseTile& tile, float x, float y)
{
    const float left = std::floor(x);
    const float bottom = std::floor(y);
    const std::array<float, 4> wx = cubicWeights(x - left);
    const std::array<float, 4> wy = cubicWeights(y - bottom);
    std::array<int, 4> columns{};
    for (int i = 0; i < 4; ++i) {
        columns[static_cast<std::size_t>(i)] = wrapped(static_cast<int>(left) + i - 1, tile.size);
    }
    float sum = 0.0F;
    for (int j = 0; j < 4; ++j) {
        const int row = wrapped(static_cast<int>(bottom) + j - 1, tile.size);
        float line = 0.0F;
        for (std::size_t i = 0; i < 4; ++i) {
            line += wx[i] * tile.at(columns[i], row);
        }
        sum += wy[static_cast<std::size_t>(j)] * line;
    }
    return sum;
}

/// Bends a tile by two others: each pixel is fetched from where the others point.
/// The factor takes their standard deviation of about 1/3 to 1, so that warp is the typical way in wavelengths.
NoiseTile warped(const Noise& noise, const NoiseTile& tile, const NoiseTile& bendX, const NoiseTile& bendY, const std::stop_token& stop)
{
    NoiseTile out;
    out.size = tile.size;
    out.values.resize(tile.values.size());
    const float reach = 3.0F * noise.warp * noise.wavelength * static_cast<float>(tile.size);
    forRows(
        tile.size, stop, [] { return 0; },
        [&](int y, int) {
            for (int x = 0; x < tile.size; ++x) {
                const float fromX = static_cast<float>(x) + reach * bendX.at(x, y);
                const float fromY = static_cast<float>(y) + reach * bendY.at(x, y);
                out.values[static_cast<std::size_t>(y) * static_cast<std::size_t>(tile.size) + static_cast<std::size_t>(x)] = sampleCubic(tile, fromX, fromY);
            }
        });
    return out;
}

/// The noise that bends another: two octaves of the same kind with a seed of its own.
Result<NoiseTile> bakeBend(const Noise& noise, std::uint32_t stream, int size, float depth, const std::stop_token& stop)
{
    constexpr int kBendOctaves = 2;
    Noise bend = noise;
    bend.octaves = std::min(noise.octaves, kBendOctaves);
    bend.seed = streamBits(noise.seed, stream);
    return bakeFractal(bend, size, depth, stop);
}

} // namespace

Result<NoiseTile> bakeFractal(const Noise& noise, int size, float depth, const std::stop_token& stop)
{
    if (size < 1 || size > kMaxTextureSize) {
        return Error{ErrorCode::TooLarge, "a noise tile of " + std::to_string(size) + " pixels", "", "Choose 1 to " + std::to_string(kMaxTextureSize)};
    }
    const auto edge = static_cast<std::size_t>(size);
    NoiseTile tile;
    tile.size = size;
    tile.values.resize(edge * edge);
    const std::vector<Octave> octaves = fractalOctaves(noise, size);
    std::vector<OctaveBaker> bakers;
    for (const Octave& octave : octaves) {
        bakers.emplace_back(noise, octave, size, depth - std::floor(depth));
    }
    struct State {
        std::vector<OctaveBaker::Workspace> octaves;
        AlignedArray<float> line;
    };
    const auto makeState = [&] {
        State state;
        for (const OctaveBaker& baker : bakers) {
            state.octaves.push_back(baker.workspace());
        }
        state.line.resize(edge + kVectorPadding);
        return state;
    };
    // Rows that are whole vectors are summed in place, where resize() has left zeros.
    const bool inPlace = edge % RowPositions::kBlock == 0;
    forRows(size, stop, makeState, [&](int row, State& state) {
        float* to = tile.values.data() + static_cast<std::size_t>(row) * edge;
        float* line = inPlace ? to : state.line.data();
        if (!inPlace) {
            std::fill(state.line.begin(), state.line.end(), 0.0F);
        }
        for (std::size_t i = 0; i < bakers.size(); ++i) {
            bakers[i].add(row, state.octaves[i], line);
        }
        if (!inPlace) {
            std::copy_n(line, edge, to);
        }
    });
    if (stop.stop_requested()) {
        return cancelled();
    }
    return tile;
}

Result<NoiseTile> bakeNoise(const Noise& noise, int size, float depth, const std::stop_token& stop)
{
    Result<NoiseTile> baked = bakeFractal(noise, size, depth, stop);
    if (!baked) {
        return baked;
    }
    NoiseTile tile = std::move(baked).value();
    if (noise.warp > 0.0F) {
        constexpr std::uint32_t kBendXStream = 1001;
        constexpr std::uint32_t kBendYStream = 1002;
        const Result<NoiseTile> bendX = bakeBend(noise, kBendXStream, size, depth, stop);
        const Result<NoiseTile> bendY = bakeBend(noise, kBendYStream, size, depth, stop);
        if (!bendX || !bendY) {
            return cancelled();
        }
        tile = warped(noise, tile, bendX.value(), bendY.value(), stop);
    }
    for (float& value : tile.values) {
        value = sharpen(0.5F + 0.5F * value, noise.sharpness, noise.coverage);
    }
    return stop.stop_requested() ? Result<NoiseTile>(cancelled()) : Result<NoiseTile>(std::move(tile));
}

} // namespace fumage
