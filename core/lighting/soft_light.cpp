#include "core/lighting/soft_light.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <array>

namespace fumage {

namespace {

/// out[i] = s a[i] + (1 - 2 s) b[i] + s c[i].
void mixLines(const float* a, const float* b, const float* c, std::size_t count, float s, float* out)
{
    for (std::size_t i = 0; i < count; ++i) {
        out[i] = b[i] + s * ((a[i] - b[i]) + (c[i] - b[i]));
    }
}

/// The same along a line, whose ends go on beyond it.
void softenAlong(const float* line, std::size_t count, std::size_t channels, float s, float* out)
{
    if (count == channels) {
        std::copy_n(line, count, out);
        return;
    }
    const std::size_t last = count - channels;
    mixLines(line, line, line + channels, channels, s, out);
    mixLines(line, line + channels, line + 2 * channels, last - channels, s, out + channels);
    mixLines(line + last - channels, line + last, line + last, channels, s, out + last);
}

} // namespace

void softenCells(const GridShape& shape, std::size_t channels, AlignedArray<float>& values, AlignedArray<float>& room)
{
    const std::size_t line = static_cast<std::size_t>(shape.nu) * channels;
    const auto lines = static_cast<std::size_t>(shape.nv);
    const auto planes = static_cast<std::size_t>(shape.nw);
    const std::size_t plane = line * lines;
    room.resize(plane * planes);
    const float finer = shape.finest / shape.cell;
    const float s = 0.25F * finer * finer;
    const auto clamped = [](std::size_t at, std::size_t count) { return std::min(at, count - 1); };
    parallelFor(planes, [&](std::size_t w) {
        std::array<float, kMaxLightResolution * 4>
            mixed; // NOLINT(cppcoreguidelines-pro-type-member-init): filled below
        const float* from = values.data() + w * plane;
        for (std::size_t v = 0; v < lines; ++v) {
            mixLines(from + (v == 0 ? 0 : v - 1) * line, from + v * line, from + clamped(v + 1, lines) * line, line, s,
                mixed.data());
            softenAlong(mixed.data(), line, channels, s, room.data() + w * plane + v * line);
        }
    });
    parallelFor(planes, [&](std::size_t w) {
        mixLines(room.data() + (w == 0 ? 0 : w - 1) * plane, room.data() + w * plane,
            room.data() + clamped(w + 1, planes) * plane, plane, s, values.data() + w * plane);
    });
}

void softenLight(LightGrid& grid, LightWorkspace& room)
{
    if (grid.shape.cells() > 1) {
        constexpr std::size_t kChannels = 4;
        softenCells(grid.shape, kChannels, grid.light, room.soft);
    }
}

} // namespace fumage
