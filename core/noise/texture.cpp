#include "core/noise/texture.h"

#include "core/base/hash.h"
#include "core/base/parallel.h"
#include "core/noise/octave_rows.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace fumage {

namespace {

/// Rows that one task bakes: enough to reuse lattice rows, few enough to share the work.
constexpr int kRowsATask = 128;

Error cancelled()
{
    return {ErrorCode::Cancelled, makeMessage("baking the noise was cancelled"), {}, {}};
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

/// Catmull-Rom weights of four neighbours at t between the middle two (Keys 1981, a = -1/2).
std::array<float, 4> cubicWeights(float t)
{
    const float t2 = t * t;
    const float t3 = t2 * t;
    return {0.5F * (-t3 + 2.0F * t2 - t), 0.5F * (3.0F * t3 - 5.0F * t2 + 2.0F), 0.5F * (-3.0F * t3 + 4.0F * t2 + t),
        0.5F * (t3 - t2)};
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
NoiseTile warped(const Noise& noise, const NoiseTile& tile, const NoiseTile& bendX, const NoiseTile& bendY,
    const std::stop_token& stop)
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
                out.values[static_cast<std::size_t>(y) * static_cast<std::size_t>(tile.size)
                    + static_cast<std::size_t>(x)] = sampleCubic(tile, fromX, fromY);
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
        return Error{ErrorCode::TooLarge, makeMessage("a noise tile of %1 pixels", size), {},
            makeMessage("Choose 1 to %1", kMaxTextureSize)};
    }
    const auto edge = static_cast<std::size_t>(size);
    NoiseTile tile;
    tile.size = size;
    tile.values.resize(edge * edge);
    std::vector<OctaveSlice> slices;
    for (const Octave& octave : fractalOctaves(noise, size)) {
        slices.push_back(octaveSlice(noise, octave, size, depth - std::floor(depth)));
    }
    struct State {
        std::vector<std::unique_ptr<OctaveRows>> octaves;
        AlignedArray<float> line;
    };
    const auto makeState = [&] {
        State state;
        for (const OctaveSlice& slice : slices) {
            state.octaves.push_back(OctaveRows::of(slice));
        }
        state.line.resize(roundUp(edge, RowPositions::kBlock));
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
        for (const auto& octave : state.octaves) {
            octave->add(row, line);
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
