#pragma once

#include "core/base/result.h"
#include "core/rendering/depth_sort.h"
#include "core/rendering/image.h"
#include "core/rendering/sprite_batch.h"
#include "core/rendering/tile.h"

#include <cstdint>
#include <limits>
#include <span>
#include <stop_token>
#include <vector>

#include <glm/vec3.hpp>

namespace fumage {

inline constexpr int kMaxImageEdge = 32768;
inline constexpr std::size_t kMaxImagePixels = std::size_t{1} << 28U;
static_assert(kMaxOutputEdge * kMaxSupersample <= kMaxImageEdge);
static_assert(kMaxImageEdge <= std::numeric_limits<decltype(SpriteBox::right)>::max());

/// Blends sprites into a picture, near to far, in linear premultiplied floats.
///
/// Sprites are binned into tiles that stay in the cache; each tile sorts its own by depth and stops once nothing behind
/// can be seen (transmittance under 1/1024 everywhere). A sprite over what is already there: C += T a c, T *= 1 - a
/// (Porter and Duff 1984, "under"). Keeps its buffers from one picture to the next. Not thread-safe; uses all threads
/// inside.
class Compositor {
public:
    /// @param layers drawn together, made for view.width by view.height pixels of their view
    /// @param image  resized; every pixel is written
    /// @error TooLarge, Cancelled
    /// O(sprites + covered pixels). The same bits for any thread count and instruction set.
    [[nodiscard]] Status compose(SpriteLayers layers, Image& image, const std::stop_token& stop = {});

    /// Several pictures of the same sprites in other colours: they are binned and sorted once, and their opacities
    /// found once. As compose() else.
    /// @param targets at most kPassTargets
    [[nodiscard]] Status composeAll(
        SpriteLayers layers, std::span<const RenderTarget> targets, const std::stop_token& stop = {});

private:
    /// Sprites of one layer that are binned by one task.
    struct Block {
        std::size_t layer;
        std::size_t first;
        std::size_t last; ///< exclusive
    };

    void countTiles(SpriteLayers layers, std::size_t tiles, int columns);
    void fillTiles(SpriteLayers layers, std::size_t firstTile, std::size_t lastTile, int columns);

    std::vector<std::uint32_t> m_counts; ///< block major: sprites of each block in each tile, then their offsets
    std::vector<std::uint64_t> m_tileTotals;
    AlignedArray<DepthEntry> m_entries;
    std::vector<std::uint64_t> m_tileStarts;
    std::vector<Block> m_blocks;
};

/// Puts a colour behind a picture with transparency, as light: for files of light. What is shown has it behind the view
/// transform, see encodeOver().
/// @param colour linear RGB
void fillBackground(Image& image, const glm::vec3& colour);

} // namespace fumage
