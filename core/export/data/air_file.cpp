#include "core/export/data/air_file.h"

#include "core/base/text.h"
#include "core/export/data/byte_writer.h"
#include "core/simulation/air_plan.h"
#include "core/simulation/air_cache.h"
#include "core/simulation/simulation_model.h"

namespace fumage {

namespace {

/// Calls visit(i, j, k) for all places below n, i fastest.
template <class Visit>
void inFileOrder(const glm::ivec3& n, const Visit& visit)
{
    for (int k = 0; k < n.z; ++k) {
        for (int j = 0; j < n.y; ++j) {
            for (int i = 0; i < n.x; ++i) {
                visit(glm::ivec3(i, j, k));
            }
        }
    }
}

std::string encodeFga(const AirField& air, float timeScale)
{
    constexpr float kCentimetres = 100.0F;
    const AirGrid& grid = air.grid;
    std::string out;
    const auto append = [&](const glm::vec3& ours) {
        for (const float number : {ours.x, ours.z, ours.y}) {
            out += formatFloat(number) + ",";
        }
    };
    append(glm::vec3(grid.cells));
    append(grid.corner * kCentimetres);
    append(grid.end() * kCentimetres);
    out += '\n';
    inFileOrder({grid.cells.x, grid.cells.z, grid.cells.y}, [&](const glm::ivec3& at) {
        append(glm::vec3(air.at(grid.centre({at.x, at.z, at.y}))) * (timeScale * kCentimetres));
        out += '\n';
    });
    return out;
}

std::string encodeVf(const AirField& air, float timeScale)
{
    const AirGrid& grid = air.grid;
    std::string out = "VF_V";
    for (int axis = 0; axis < 3; ++axis) {
        appendLittleEndian(out, static_cast<std::uint32_t>(grid.cells[axis]), 2);
    }
    inFileOrder(grid.cells, [&](const glm::ivec3& at) {
        const glm::vec4 velocity = timeScale * air.at(grid.centre({at.x, at.y, grid.cells.z - 1 - at.z}));
        for (const float number : {velocity.x, velocity.y, -velocity.z}) {
            appendLittleEndian(out, number);
        }
    });
    return out;
}

} // namespace

std::string_view fileEnding(AirFormat format)
{
    return format == AirFormat::Fga ? ".fga" : ".vf";
}

std::string encodeAir(const AirField& air, AirFormat format, float timeScale)
{
    return format == AirFormat::Fga ? encodeFga(air, timeScale) : encodeVf(air, timeScale);
}

Result<AirGrid> writeAir(const Scene& scene, const AirSequenceOptions& options, const ExportTask& task)
{
    if (!scene.air.enabled) {
        return Error{ErrorCode::OutOfRange, makeMessage("no air carries this smoke"), {},
            makeMessage("Switch it on with air.enabled")};
    }
    const std::vector<SampledEffect> layers = sampledLayers(scene);
    if (Status status = checkAir(layers); !status) {
        return status.error();
    }
    const std::shared_ptr<BakedAir> baked = airFor(layers, task.shelf);
    const auto stepOf = [&](int number) { return firstAirStep(layers) + number * scene.timeline.stepsPerFrame; };
    constexpr int kPercent = 100;
    const auto baking = [&](double share) {
        task.progress(ProgressPhase::Air, static_cast<int>(kPercent * share), kPercent);
    };
    const std::int64_t last = stepOf(options.frames.at(options.frames.count() - 1));
    AirGrid grid;
    const auto bytesOf = [&](int number) -> Result<std::string> {
        // The first time; what is baked stays.
        if (Status status = baked->bake(last, task.stop, baking); !status) {
            return status.error();
        }
        const Result<AirFieldPtr> air = baked->field(stepOf(number), task.stop);
        if (!air) {
            return air.error();
        }
        grid = air.value()->grid;
        return encodeAir(*air.value(), options.format, scene.timeline.timeScale);
    };
    const NumberedFiles files{
        options.output, options.frames, fileEnding(options.format), options.source, options.written};
    const Status written = writeNumbered(files, bytesOf, task);
    return written ? Result<AirGrid>(grid) : written.error();
}

} // namespace fumage
