#include "core/export/data/vdb_file.h"

#include "core/base/hash.h"
#include "core/base/text.h"
#include "core/export/data/byte_writer.h"
#include "core/export/data/vdb_tree.h"
#include "core/export/layer_output.h"
#include "core/rendering/scene_renderer.h"
#include "core/rendering/sprite_texture.h"

#include <algorithm>
#include <array>
#include <functional>
#include <optional>

#include <half.h>

namespace fumage {

namespace {

using namespace vdb;

constexpr std::uint32_t kFormat = 224;
constexpr char kAllValues = 6; // NO_MASK_AND_ALL_VALS: each node has all of its values

void appendString(std::string& out, std::string_view text)
{
    appendLittleEndian(out, static_cast<std::uint32_t>(text.size()));
    out += text;
}

void append64(std::string& out, std::uint64_t bits)
{
    appendLittleEndian(out, static_cast<std::uint32_t>(bits));
    appendLittleEndian(out, static_cast<std::uint32_t>(bits >> 32U));
}

void appendDoubles(std::string& out, const glm::dvec3& numbers)
{
    for (int axis = 0; axis < 3; ++axis) {
        append64(out, std::bit_cast<std::uint64_t>(numbers[axis]));
    }
}

/// One column of a volume as a grid.
struct Column {
    std::string name;
    int channels = 1;
    std::function<glm::vec3(std::size_t)> at; ///< the numbers of a cell, of which the first channels count
};

void appendMetadata(std::string& out, const Column& column, const Tree& tree)
{
    const auto entry = [&](std::string_view name, std::string_view type) {
        appendString(out, name);
        appendString(out, type);
    };
    const auto text = [&](std::string_view name, std::string_view value) {
        entry(name, "string");
        appendString(out, value);
    };
    const auto place = [&](std::string_view name, const glm::ivec3& value) {
        entry(name, "vec3i");
        appendLittleEndian(out, std::uint32_t{12});
        for (int axis = 0; axis < 3; ++axis) {
            appendLittleEndian(out, static_cast<std::uint32_t>(value[axis]));
        }
    };
    const bool isVector = column.channels == 3;
    appendLittleEndian(out, std::uint32_t{isVector ? 8U : 7U});
    text("class", isVector ? "unknown" : "fog volume");
    place("file_bbox_max", tree.high);
    place("file_bbox_min", tree.low);
    text("file_compression", "none");
    entry("file_voxel_count", "int64");
    appendLittleEndian(out, std::uint32_t{8});
    append64(out, static_cast<std::uint64_t>(tree.voxels));
    entry("is_saved_as_half_float", "bool");
    appendLittleEndian(out, std::uint32_t{1});
    out += '\1';
    text("name", column.name);
    if (isVector) {
        text("vector_type", "contravariant relative");
    }
}

/// Index to place: scale, then shift. Voxel (0, 0, 0) has the origin as a corner, and lies in the positive directions
/// of it.
void appendTransform(std::string& out, double cell)
{
    appendString(out, "UniformScaleTranslateMap");
    appendDoubles(out, glm::dvec3(0.5 * cell));
    appendDoubles(out, glm::dvec3(cell)); // scale
    appendDoubles(out, glm::dvec3(cell)); // size of a voxel
    appendDoubles(out, glm::dvec3(1.0 / cell));
    appendDoubles(out, glm::dvec3(1.0 / (cell * cell)));
    appendDoubles(out, glm::dvec3(0.5 / cell));
}

/// The values of a node above the leaves: none counts.
void appendNothing(std::string& out, int bits, int channels)
{
    out += kAllValues;
    out.append((std::size_t{1} << static_cast<unsigned>(3 * bits)) * static_cast<std::size_t>(channels)
            * sizeof(std::uint16_t),
        '\0');
}

void appendTopology(std::string& out, const Column& column, const Tree& tree)
{
    appendLittleEndian(out, std::uint32_t{1}); // buffers a leaf
    for (int channel = 0; channel < column.channels; ++channel) {
        appendLittleEndian(out, 0.0F); // what lies outside
    }
    appendLittleEndian(out, std::uint32_t{0}); // tiles
    appendLittleEndian(out, static_cast<std::uint32_t>(tree.tops.size()));
    for (const Top& top : tree.tops) {
        for (int axis = 0; axis < 3; ++axis) {
            appendLittleEndian(out, static_cast<std::uint32_t>(top.first[axis]));
        }
        out += top.children.bytes();
        out += Mask(kTopBits).bytes();
        appendNothing(out, kTopBits, column.channels);
        for (const Middle& middle : top.middles) {
            out += middle.children.bytes();
            out += Mask(kMiddleBits).bytes();
            appendNothing(out, kMiddleBits, column.channels);
            for (const Leaf& leaf : middle.leaves) {
                out += leaf.voxels.bytes();
            }
        }
    }
}

void appendLeaf(std::string& out, const Column& column, const Leaf& leaf, const Placed& placed)
{
    out += leaf.voxels.bytes();
    out += kAllValues;
    forChildren(glm::ivec3(0), glm::ivec3((1 << kLeafBits) - 1), [&](const glm::ivec3& voxelAt) {
        const std::optional<std::size_t> place = placed.at(leaf.first + voxelAt);
        const glm::vec3 value = place ? column.at(*place) : glm::vec3(0.0F);
        for (int channel = 0; channel < column.channels; ++channel) {
            appendLittleEndian(out, half(value[channel]).bits(), 2);
        }
    });
}

void appendLeaves(std::string& out, const Column& column, const Tree& tree, const Placed& placed)
{
    for (const Top& top : tree.tops) {
        for (const Middle& middle : top.middles) {
            for (const Leaf& leaf : middle.leaves) {
                appendLeaf(out, column, leaf, placed);
            }
        }
    }
}

void appendGrid(std::string& out, const Column& column, const Tree& tree, const Placed& placed, float cell)
{
    appendString(out, column.name);
    appendString(out, column.channels == 3 ? "Tree_vec3s_5_4_3_HalfFloat" : "Tree_float_5_4_3_HalfFloat");
    appendString(out, {}); // it shares no tree
    std::array<std::uint64_t, 3> places{}; // of the grid, of its leaves, of its end
    const std::size_t table = out.size();
    out.append(places.size() * sizeof(std::uint64_t), '\0');
    places[0] = out.size();
    appendLittleEndian(out, std::uint32_t{0}); // not compressed
    appendMetadata(out, column, tree);
    appendTransform(out, static_cast<double>(cell));
    appendTopology(out, column, tree);
    places[1] = out.size();
    appendLeaves(out, column, tree, placed);
    places[2] = out.size();
    std::string bytes;
    for (const std::uint64_t place : places) {
        append64(bytes, place);
    }
    out.replace(table, bytes.size(), bytes);
}

/// A grid of each layer, with voxels where it has smoke.
void appendLayers(std::string& out, const Volume& volume, UpAxis up, std::span<const std::string> names)
{
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::vector<float>& density = volume.layers[i];
        const Placed placed(volume, density, up);
        const Column column{names[i], 1, [&](std::size_t cell) { return glm::vec3(density[cell]); }};
        appendGrid(out, column, treeOf(placed), placed, volume.cell);
    }
}

/// What all layers have together.
std::vector<Column> columnsOf(const Volume& volume, UpAxis up, bool hasDensity)
{
    std::vector<Column> columns;
    if (hasDensity) {
        columns.push_back({"density", 1, [&](std::size_t cell) { return glm::vec3(volume.density[cell]); }});
    }
    if (volume.hasTemperature) {
        columns.push_back({"temperature", 1, [&](std::size_t cell) { return glm::vec3(volume.temperature[cell]); }});
    }
    if (volume.hasFlames) {
        columns.push_back({"flames", 1, [&](std::size_t cell) { return glm::vec3(volume.flames[cell]); }});
    }
    columns.push_back({"vel", 3, [&volume, up](std::size_t cell) { return turned(volume.velocity[cell], up); }});
    return columns;
}

/// A name for what follows, by what it is: the same bytes have the same one.
std::string identityOf(std::string_view bytes)
{
    constexpr std::string_view kHex = "0123456789abcdef";
    std::array<std::uint32_t, 4> sums{1, 2, 3, 4};
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        sums[i % 4] = mixBits(sums[i % 4] ^ static_cast<unsigned char>(bytes[i]));
    }
    std::string out;
    for (std::size_t digit = 0; digit < 32; ++digit) {
        if (digit == 8 || digit == 12 || digit == 16 || digit == 20) {
            out += '-';
        }
        out += kHex[sums[digit / 8] >> 4U * (digit % 8) & 15U];
    }
    return out;
}

} // namespace

std::string_view nameOf(DensityGrids grids)
{
    return grids == DensityGrids::Layers ? "layers" : "together";
}

std::vector<std::string> namesOfGrids(const Scene& scene)
{
    std::vector<std::string> names;
    for (const WrittenLayer& layer : writtenLayers(scene)) {
        std::string name = "density_";
        for (const char letter : layer.word) {
            const bool isPlain = (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9');
            name += isPlain ? std::string(1, letter) : name.ends_with('_') ? std::string() : std::string(1, '_');
        }
        while (std::ranges::find(names, name) != names.end()) {
            name += "_" + std::to_string(layer.index + 1);
        }
        names.push_back(std::move(name));
    }
    return names;
}

std::string encodeVdb(const Volume& volume, UpAxis up, std::span<const std::string> layers)
{
    const Placed placed(volume, volume.density, up);
    const Tree tree = treeOf(placed);
    const std::vector<Column> columns = columnsOf(volume, up, layers.empty());
    std::string out;
    append64(out, 0x56444220); // " BDV"
    appendLittleEndian(out, kFormat);
    appendLittleEndian(out, std::uint32_t{10}); // of the library that writes alike
    appendLittleEndian(out, std::uint32_t{0});
    out += '\1'; // grids say where they end
    const std::size_t identity = out.size();
    out.append(identityOf({}).size(), '0');
    appendLittleEndian(out, std::uint32_t{0}); // metadata of the file
    appendLittleEndian(out, static_cast<std::uint32_t>(layers.size() + columns.size()));
    appendLayers(out, volume, up, layers);
    for (const Column& column : columns) {
        appendGrid(out, column, tree, placed, volume.cell);
    }
    const std::string name = identityOf(out);
    out.replace(identity, name.size(), name);
    return out;
}

Result<float> writeVolumes(const Scene& scene, const VolumeSequenceOptions& options, const ExportTask& task)
{
    if (options.longest < kMinVolumeCells || options.longest > kMaxVolumeCells) {
        return Error{ErrorCode::OutOfRange, makeMessage("a volume of %1 cells", options.longest), {},
            makeMessage("Use %1 to %2 cells along the longest edge", kMinVolumeCells, kMaxVolumeCells)};
    }
    if (options.voxel && !(*options.voxel >= kMinVoxel && *options.voxel <= kMaxVoxel)) {
        return Error{ErrorCode::OutOfRange, makeMessage("voxels of %1 m", formatFloat(*options.voxel)), {},
            makeMessage("Use %1 to %2 m", formatFloat(kMinVoxel), formatFloat(kMaxVoxel))};
    }
    const std::vector<SampledEffect> layers = sampledLayers(scene);
    std::vector<GreyCounts> greys;
    for (const SampledEffect& layer : layers) {
        Result<GreyCounts> found = greysShown(layer.strongest(), task.stop);
        if (!found) {
            return found.error();
        }
        greys.push_back(std::move(found).value());
    }
    SceneSimulator simulator(layers, Simulator::kDefaultCheckpointBytes, task.shelf);
    const Result<float> voxel =
        options.voxel ? Result<float>(*options.voxel) : voxelFor(simulator, layers, options.longest, task);
    if (!voxel) {
        return voxel.error();
    }
    const bool hasLayers = options.density == DensityGrids::Layers;
    const VolumeColumns columns = volumeColumns(layers);
    const std::vector<std::string> names = hasLayers ? namesOfGrids(scene) : std::vector<std::string>();
    const NumberedFiles files{options.output, options.frames, kVdbEnding, options.source, options.written};
    const auto bytesOf = [&](int number) -> Result<std::string> {
        const Result<SceneFrame> frame = simulator.frame(number, task);
        if (!frame) {
            return frame.error();
        }
        const Result<Volume> volume = volumeOf(LayersAtFrame(frame.value(), layers), voxel.value(), greys,
            hasLayers ? LayerDensities::Yes : LayerDensities::No, columns);
        return volume ? Result<std::string>(encodeVdb(volume.value(), options.up, names)) : volume.error();
    };
    const Status written = writeNumbered(files, bytesOf, task);
    return written ? voxel : written.error();
}

} // namespace fumage
