#include "core/export/data/particle_dump.h"

#include "core/system/file.h"
#include "core/base/text.h"
#include "core/effect/sampling.h"
#include "core/export/data/byte_writer.h"
#include "core/export/output_name.h"
#include "core/lighting/appearance.h"
#include "core/rendering/view_transform.h"
#include "core/rendering/scene_renderer.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <span>
#include <string_view>
#include <vector>

namespace fumage {

namespace {

constexpr std::array<std::string_view, 11> kColumns{
    "x", "y", "z", "vx", "vy", "vz", "age", "life", "alpha", "radius", "heat"};
constexpr std::array<std::string_view, 3> kColours{"red", "green", "blue"};

constexpr std::string_view kLayerColumn = "layer"; // its number from 1, where there are several

struct Row {
    std::size_t layer = 0;
    std::int32_t id = 0;
    std::array<float, kColumns.size()> values{};
    glm::vec3 colour{1.0F};
};

/// Counts births, so that importers can join the particles of successive frames. Not the key of a particle: where a
/// loop is shorter than a life, several are alive that have the same. Stays the same through a loop; at its start the
/// particles that lived through its end count anew.
std::int32_t idOf(const Frame& frame, std::size_t slot)
{
    constexpr std::int64_t kSigned = std::int64_t{1} << 31U; // many programs read no more
    const auto slots = static_cast<std::int64_t>(frame.particles.capacity);
    return static_cast<std::int32_t>(
        frame.model->schedule().birthIndex(frame.step, static_cast<std::int64_t>(slot), slots) % kSigned);
}

/// Adds the living particles of a layer.
void addRows(std::size_t layer, const LayerFrame& of, UpAxis up, std::vector<Row>& rows)
{
    const Frame& frame = *of.frame;
    const Effect& effect = *of.effect;
    const float timeScale = effect.timeline.timeScale;
    Appearance appearance;
    findAppearance(frame, *of.effect, Axes{}, appearance);
    const Particles& p = frame.particles;
    for (std::size_t i = 0; i < p.capacity; ++i) {
        const Lifecycle cycle = lifecycle(frame, i);
        if (cycle.alive) {
            const glm::vec3 at = turned({p.x[i], p.y[i], p.z[i]}, up);
            const glm::vec3 velocity = timeScale * turned({p.vx[i], p.vy[i], p.vz[i]}, up);
            rows.push_back({layer, idOf(frame, i),
                {at.x, at.y, at.z, velocity.x, velocity.y, velocity.z, cycle.age / timeScale, cycle.life,
                    appearance.alpha[i], appearance.radius[i], p.inAir() ? p.heat[i] : 0.0F},
                effect.look.colour * effect.look.colourGradient.at(cycle.life)});
        }
    }
}

std::vector<Row> livingRows(LayerFrames layers, UpAxis up, std::span<const std::size_t> numbers = {})
{
    std::vector<Row> rows;
    for (std::size_t layer = 0; layer < layers.size(); ++layer) {
        addRows(numbers.empty() ? layer : numbers[layer], layers[layer], up, rows);
    }
    return rows;
}

char inSrgb(float linear)
{
    constexpr float kFull = 255.0F;
    return static_cast<char>(static_cast<unsigned char>(std::clamp(srgbFromLinear(linear), 0.0F, 1.0F) * kFull + 0.5F));
}

} // namespace

std::string_view fileEnding(ParticleFormat format)
{
    switch (format) {
    case ParticleFormat::Csv: return ".csv";
    case ParticleFormat::Ply: return ".ply";
    case ParticleFormat::Pcache: return ".pcache";
    }
    return {};
}

std::string dumpCsv(LayerFrames layers, UpAxis up, std::span<const std::size_t> numbers)
{
    const bool several = layers.size() > 1;
    std::string out = several ? std::string(kLayerColumn) + ",id" : "id";
    for (const std::string_view column : kColumns) {
        out += ',';
        out += column;
    }
    for (const std::string_view colour : kColours) {
        out += ',';
        out += colour;
    }
    out += '\n';
    for (const Row& row : livingRows(layers, up, numbers)) {
        out += several ? std::to_string(row.layer + 1) + "," : "";
        out += std::to_string(row.id);
        for (const float value : row.values) {
            out += ',';
            out += formatFloat(value);
        }
        for (int i = 0; i < 3; ++i) {
            out += ',';
            out += formatFloat(row.colour[i]);
        }
        out += '\n';
    }
    return out;
}

std::string dumpPly(LayerFrames layers, UpAxis up, std::span<const std::size_t> numbers)
{
    const bool several = layers.size() > 1;
    const std::vector<Row> rows = livingRows(layers, up, numbers);
    std::string out = "ply\nformat binary_little_endian 1.0\ncomment Fumage frame "
        + std::to_string(layers.front().frame->number) + "\nelement vertex " + std::to_string(rows.size()) + "\n"
        + (several ? "property int " + std::string(kLayerColumn) + "\n" : "") + "property int id\n";
    for (const std::string_view column : kColumns) {
        out += "property float " + std::string(column) + "\n";
    }
    for (const std::string_view colour : kColours) {
        out += "property uchar " + std::string(colour) + "\n";
    }
    out += "end_header\n";
    for (const Row& row : rows) {
        if (several) {
            appendLittleEndian(out, static_cast<std::uint32_t>(row.layer + 1));
        }
        appendLittleEndian(out, static_cast<std::uint32_t>(row.id));
        for (const float value : row.values) {
            appendLittleEndian(out, value);
        }
        for (int i = 0; i < 3; ++i) {
            out += inSrgb(row.colour[i]);
        }
    }
    return out;
}

std::string dumpPcache(LayerFrames layers)
{
    constexpr std::array<std::string_view, 14> kProperties{"position.x", "position.y", "position.z", "velocity.x",
        "velocity.y", "velocity.z", "age", "lifetime", "size", "color.r", "color.g", "color.b", "color.a", "heat"};
    const std::vector<Row> rows = livingRows(layers, UpAxis::Y);
    std::string out = "pcache\nformat binary 1.0\ncomment Fumage frame " + std::to_string(layers.front().frame->number)
        + "\nelements " + std::to_string(rows.size()) + "\n";
    for (const std::string_view property : kProperties) {
        out += "property float " + std::string(property) + "\n";
    }
    out += "end_header\n";
    for (const Row& row : rows) {
        const auto [x, y, z, vx, vy, vz, age, life, alpha, radius, heat] = row.values;
        const float lifetime = life > 0.0F ? age / life : age;
        for (const float value : {x, y, -z, vx, vy, -vz, age, lifetime, 2.0F * radius, row.colour.r, row.colour.g,
                 row.colour.b, alpha, heat}) {
            appendLittleEndian(out, value);
        }
    }
    return out;
}

namespace {

/// Writes the particles of a scene's frames.
class Dumper {
public:
    Dumper(const Scene& scene, ParticleFormat format, UpAxis up, const std::shared_ptr<AirCache>& shelf)
        : m_smoke(scene, shelf)
        , m_numbers(scene.visibleLayers())
        , m_format(format)
        , m_up(up)
    {
    }

    Result<std::string> frame(int number, const Task& task)
    {
        const Result<SceneFrame> simulated = m_smoke.frame(number, task);
        if (!simulated) {
            return simulated.error();
        }
        const LayersAtFrame layers(simulated.value(), m_smoke.layers());
        switch (m_format) {
        case ParticleFormat::Csv: return dumpCsv(layers, m_up, m_numbers);
        case ParticleFormat::Ply: return dumpPly(layers, m_up, m_numbers);
        case ParticleFormat::Pcache: return dumpPcache(layers);
        }
        return std::string();
    }

private:
    SceneRenderer m_smoke;
    std::vector<std::size_t> m_numbers; ///< of the layers that are seen; empty: of the one that stands for none
    ParticleFormat m_format;
    UpAxis m_up;
};

} // namespace

Result<std::string> dumpParticles(
    const Scene& scene, int frame, ParticleFormat format, UpAxis up, const ExportTask& task)
{
    return Dumper(scene, format, up, task.shelf).frame(frame, task);
}

Status dumpSequence(const Scene& scene, const ParticleSequenceOptions& options, const ExportTask& task)
{
    Dumper dumper(scene, options.format, options.up, task.shelf);
    const auto bytesOf = [&](int number) { return dumper.frame(number, task); };
    const NumberedFiles files{
        options.output, options.frames, fileEnding(options.format), options.source, options.written};
    return writeNumbered(files, bytesOf, task);
}

} // namespace fumage
