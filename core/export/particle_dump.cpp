#include "core/export/particle_dump.h"

#include "core/base/text.h"
#include "core/effect/sampling.h"
#include "core/lighting/appearance.h"
#include "core/simulation/simulator.h"

#include <array>
#include <bit>
#include <cstring>
#include <string_view>
#include <vector>

namespace fumage {

namespace {

constexpr std::array<std::string_view, 10> kColumns{"x", "y", "z", "vx", "vy", "vz", "age", "life", "alpha", "radius"};

struct Row {
    std::uint32_t id = 0;
    std::array<float, kColumns.size()> values{};
};

std::vector<Row> livingRows(const Frame& frame, const SampledEffect& effect)
{
    Appearance appearance;
    findAppearance(frame, effect, Axes{}, appearance);
    const Particles& p = frame.particles;
    std::vector<Row> rows;
    for (std::size_t i = 0; i < p.capacity; ++i) {
        const Lifecycle cycle = lifecycle(frame, i);
        if (cycle.alive) {
            rows.push_back({p.key[i], {p.x[i], p.y[i], p.z[i], p.vx[i], p.vy[i], p.vz[i], cycle.age, cycle.life, appearance.alpha[i], appearance.radius[i]}});
        }
    }
    return rows;
}

void appendLittleEndian(std::string& out, std::uint32_t bits)
{
    for (unsigned shift = 0; shift < 32U; shift += 8U) {
        out += static_cast<char>(bits >> shift & 255U);
    }
}

} // namespace

std::string_view fileEnding(ParticleFormat format)
{
    return format == ParticleFormat::Csv ? ".csv" : ".ply";
}

std::string dumpCsv(const Frame& frame, const SampledEffect& effect)
{
    std::string out = "id";
    for (const std::string_view column : kColumns) {
        out += ',';
        out += column;
    }
    out += '\n';
    for (const Row& row : livingRows(frame, effect)) {
        out += std::to_string(row.id);
        for (const float value : row.values) {
            out += ',';
            out += formatFloat(value);
        }
        out += '\n';
    }
    return out;
}

std::string dumpPly(const Frame& frame, const SampledEffect& effect)
{
    const std::vector<Row> rows = livingRows(frame, effect);
    std::string out = "ply\nformat binary_little_endian 1.0\ncomment Fumage frame " + std::to_string(frame.number) + "\nelement vertex " + std::to_string(rows.size()) + "\nproperty uint id\n";
    for (const std::string_view column : kColumns) {
        out += "property float " + std::string(column) + "\n";
    }
    out += "end_header\n";
    for (const Row& row : rows) {
        appendLittleEndian(out, row.id);
        for (const float value : row.values) {
            appendLittleEndian(out, std::bit_cast<std::uint32_t>(value));
        }
    }
    return out;
}

Result<std::string> dumpParticles(const Effect& effect, int frame, ParticleFormat format, const std::stop_token& stop)
{
    const SampledEffect smoke = sampled(effect);
    const Result<std::shared_ptr<const Frame>> simulated = Simulator(smoke).frame(frame, stop);
    if (!simulated) {
        return simulated.error();
    }
    return format == ParticleFormat::Csv ? dumpCsv(*simulated.value(), smoke) : dumpPly(*simulated.value(), smoke);
}

} // namespace fumage
