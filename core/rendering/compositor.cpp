#include "core/rendering/compositor.h"

#include "core/base/parallel.h"
#include "core/rendering/tile_kernel.h"

#include <algorithm>
#include <memory>

namespace fumage {

namespace {

/// Sprites that are binned by one task.
constexpr std::size_t kBlock = 16384;

/// Tiles are painted in groups whose lists take at most this many entries (128 MiB), whatever the size of the picture.
constexpr std::uint64_t kMaxEntries = std::uint64_t{1} << 24U;

int tilesAcross(int pixels, int tile)
{
    return (pixels + tile - 1) / tile;
}

/// Calls visit(sprite, tile) for some sprites and the tiles that each touches, in their order.
template <class Visit>
void forTiles(const SpriteBatch& batch, std::size_t first, std::size_t last, int columns, const Visit& visit)
{
    for (std::size_t i = first; i < last; ++i) {
        const SpriteBox box = batch.boxes[i];
        if (box.left > box.right) {
            continue;
        }
        const std::size_t right = box.right / Tile::kWidth;
        const std::size_t bottom = box.bottom / Tile::kHeight;
        for (std::size_t row = box.top / Tile::kHeight; row <= bottom; ++row) {
            for (std::size_t column = box.left / Tile::kWidth; column <= right; ++column) {
                visit(i, row * static_cast<std::size_t>(columns) + column);
            }
        }
    }
}

struct Workspace {
    Tile tile;
    AlignedArray<DepthEntry> scratch;
};

} // namespace

void Compositor::countTiles(SpriteLayers layers, std::size_t tiles, int columns)
{
    m_blocks.clear();
    for (std::size_t layer = 0; layer < layers.size(); ++layer) {
        const std::size_t sprites = layers[layer].batch->boxes.size();
        for (std::size_t first = 0; first < sprites; first += kBlock) {
            m_blocks.push_back({layer, first, std::min(sprites, first + kBlock)});
        }
    }
    m_counts.assign(m_blocks.size() * tiles, 0U);
    parallelFor(m_blocks.size(), [&](std::size_t number) {
        std::uint32_t* counts = m_counts.data() + number * tiles;
        const Block& block = m_blocks[number];
        forTiles(*layers[block.layer].batch, block.first, block.last, columns,
            [&](std::size_t, std::size_t tile) { ++counts[tile]; });
    });
    // Counts become the offset of each block within its tile: entries of a tile lie in the order of their slots.
    m_tileTotals.assign(tiles, 0U);
    for (std::size_t tile = 0; tile < tiles; ++tile) {
        std::uint32_t sum = 0;
        for (std::size_t block = 0; block < m_blocks.size(); ++block) {
            std::uint32_t& count = m_counts[block * tiles + tile];
            const std::uint32_t here = count;
            count = sum;
            sum += here;
        }
        m_tileTotals[tile] = sum;
    }
}

void Compositor::fillTiles(SpriteLayers layers, std::size_t firstTile, std::size_t lastTile, int columns)
{
    m_tileStarts.assign(lastTile - firstTile + 1, 0U);
    for (std::size_t tile = firstTile; tile < lastTile; ++tile) {
        m_tileStarts[tile - firstTile + 1] = m_tileStarts[tile - firstTile] + m_tileTotals[tile];
    }
    if (m_entries.size() < m_tileStarts.back()) {
        m_entries.resize(m_tileStarts.back());
    }
    const std::size_t tiles = m_tileTotals.size();
    parallelFor(m_blocks.size(), [&](std::size_t number) {
        std::vector<std::uint32_t> at(m_counts.begin() + static_cast<std::ptrdiff_t>(number * tiles + firstTile),
            m_counts.begin() + static_cast<std::ptrdiff_t>(number * tiles + lastTile));
        const Block& block = m_blocks[number];
        const SpriteBatch& batch = *layers[block.layer].batch;
        forTiles(batch, block.first, block.last, columns, [&](std::size_t sprite, std::size_t tile) {
            if (tile >= firstTile && tile < lastTile) {
                m_entries[m_tileStarts[tile - firstTile] + at[tile - firstTile]++] =
                    depthEntry(batch.depth[sprite], SpriteNumber(block.layer, sprite).bits);
            }
        });
    });
}

Status Compositor::compose(SpriteLayers layers, Image& image, const std::stop_token& stop)
{
    const RenderTarget own{nullptr, &image};
    return composeAll(layers, {&own, 1}, stop);
}

Status Compositor::composeAll(SpriteLayers layers, std::span<const RenderTarget> targets, const std::stop_token& stop)
{
    const int width = layers.front().batch->view.width;
    const int height = layers.front().batch->view.height;
    if (width < 1 || height < 1 || width > kMaxImageEdge || height > kMaxImageEdge
        || static_cast<std::size_t>(width) * static_cast<std::size_t>(height) > kMaxImagePixels) {
        return Error{ErrorCode::TooLarge, makeMessage("a picture of %1 x %2 pixels", width, height), {},
            makeMessage("Choose a smaller size or less supersampling")};
    }
    for (const RenderTarget& target : targets) {
        target.image->resize(width, height);
    }
    const int columns = tilesAcross(width, Tile::kWidth);
    const int rows = tilesAcross(height, Tile::kHeight);
    const auto tiles = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    countTiles(layers, tiles, columns);

    PerThread<Workspace> workspaces;
    for (std::size_t first = 0; first < tiles;) {
        std::size_t last = first;
        std::uint64_t entries = 0;
        do {
            entries += m_tileTotals[last++];
        } while (last < tiles && entries + m_tileTotals[last] <= kMaxEntries);
        fillTiles(layers, first, last, columns);
        parallelFor(last - first, [&](std::size_t index) {
            if (stop.stop_requested()) {
                return;
            }
            Workspace& workspace = workspaces.local();
            const auto tile = static_cast<int>(first + index);
            workspace.tile.left = tile % columns * Tile::kWidth;
            workspace.tile.top = tile / columns * Tile::kHeight;
            workspace.tile.right = std::min(width, workspace.tile.left + Tile::kWidth);
            workspace.tile.bottom = std::min(height, workspace.tile.top + Tile::kHeight);
            const std::span<DepthEntry> list(m_entries.data() + m_tileStarts[index], m_tileTotals[first + index]);
            sortByDepth(list, workspace.scratch);
            paintTile(layers, targets, list, workspace.tile);
        });
        if (stop.stop_requested()) {
            return Error{ErrorCode::Cancelled, makeMessage("painting was cancelled"), {}, {}};
        }
        first = last;
    }
    return Done{};
}

void fillBackground(Image& image, const glm::vec3& colour)
{
    parallelFor(static_cast<std::size_t>(image.height), [&](std::size_t y) {
        float* pixel = image.row(static_cast<int>(y));
        for (int x = 0; x < image.width; ++x, pixel += 4) {
            const float through = 1.0F - pixel[3];
            pixel[0] += through * colour.r;
            pixel[1] += through * colour.g;
            pixel[2] += through * colour.b;
            pixel[3] = 1.0F;
        }
    });
}

} // namespace fumage
