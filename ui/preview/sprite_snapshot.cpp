#include "ui/preview/sprite_snapshot.h"

#include <algorithm>

namespace fumage::ui {

namespace {

/// Where a surface stands in a list that has each once.
std::size_t placeOf(const SpriteSurface& surface, std::vector<SpriteSurface>& surfaces)
{
    const SpriteSurface shown{surface.picture == nullptr ? surface.texture : nullptr, surface.picture};
    const auto found = std::find(surfaces.begin(), surfaces.end(), shown);
    if (found == surfaces.end()) {
        surfaces.push_back(shown);
        return surfaces.size() - 1;
    }
    return static_cast<std::size_t>(found - surfaces.begin());
}

/// Adds a sprite to the run before it, or begins another: those that show nothing go with any.
void addToRuns(const Sprite& sprite, std::size_t surface, std::size_t at, std::vector<SpriteBatchSnapshot::Run>& runs)
{
    const bool isPlain = unpackTexture(sprite.texture).level == TextureRef::kPlain;
    if (runs.empty() || (!isPlain && runs.back().surface != surface)) {
        runs.push_back({at, 0, surface});
    }
    ++runs.back().count;
}

} // namespace

std::shared_ptr<const SpriteBatchSnapshot> snapshotOf(const Renderer& renderer)
{
    const SpriteLayers layers = renderer.layers();
    AlignedArray<DepthEntry> entries;
    AlignedArray<DepthEntry> scratch;
    bool hasDetail = false;
    auto snapshot = std::make_shared<SpriteBatchSnapshot>();
    std::vector<std::size_t> surfaces; // of each layer
    for (std::size_t layer = 0; layer < layers.size(); ++layer) {
        const SpriteBatch& batch = *layers[layer].batch;
        for (std::size_t i = 0; i < batch.sprites.size(); ++i) {
            if (batch.depth[i] != SpriteBatch::kHidden) {
                entries.push_back(depthEntry(batch.depth[i], SpriteNumber(layer, i).bits));
            }
        }
        hasDetail = hasDetail || !batch.details.empty();
        snapshot->styles.push_back(batch.style);
        surfaces.push_back(placeOf(renderer.surface(layer), snapshot->surfaces));
    }
    sortByDepth(entries, scratch);
    const std::size_t count = entries.size();
    snapshot->sprites.resize(count);
    snapshot->layers.resize(count);
    snapshot->details.resize(hasDetail ? count : 0);
    for (std::size_t i = 0; i < count; ++i) {
        const SpriteNumber from(entryIndex(entries[count - 1 - i]));
        const SpriteBatch& batch = *layers[from.layer()].batch;
        snapshot->sprites[i] = batch.sprites[from.slot()];
        snapshot->layers[i] = static_cast<std::uint32_t>(from.layer());
        if (!batch.details.empty()) {
            snapshot->details[i] = batch.details[from.slot()];
        }
        addToRuns(snapshot->sprites[i], surfaces[from.layer()], i, snapshot->runs);
    }
    snapshot->view = layers.front().batch->view;
    return snapshot;
}

} // namespace fumage::ui
