#include "ui/preview/sprite_snapshot.h"

#include <algorithm>

namespace fumage::ui {

namespace {

/// Where a texture stands in a list that has each once.
std::size_t placeOf(
    const std::shared_ptr<const SpriteTexture>& texture, std::vector<std::shared_ptr<const SpriteTexture>>& textures)
{
    const auto found = std::find(textures.begin(), textures.end(), texture);
    if (found == textures.end()) {
        textures.push_back(texture);
        return textures.size() - 1;
    }
    return static_cast<std::size_t>(found - textures.begin());
}

/// Adds a sprite to the run before it, or begins another: those that show no texture go with any.
void addToRuns(const Sprite& sprite, std::size_t texture, std::size_t at, std::vector<SpriteBatchSnapshot::Run>& runs)
{
    const bool isPlain = unpackTexture(sprite.texture).level == TextureRef::kPlain;
    if (runs.empty() || (!isPlain && runs.back().texture != texture)) {
        runs.push_back({at, 0, texture});
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
    std::vector<std::size_t> textures; // of each layer
    for (std::size_t layer = 0; layer < layers.size(); ++layer) {
        const SpriteBatch& batch = *layers[layer].batch;
        for (std::size_t i = 0; i < batch.sprites.size(); ++i) {
            if (batch.depth[i] != SpriteBatch::kHidden) {
                entries.push_back(depthEntry(batch.depth[i], SpriteNumber(layer, i).bits));
            }
        }
        hasDetail = hasDetail || !batch.details.empty();
        snapshot->styles.push_back(batch.style);
        textures.push_back(placeOf(renderer.texture(layer), snapshot->textures));
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
        addToRuns(snapshot->sprites[i], textures[from.layer()], i, snapshot->runs);
    }
    snapshot->view = layers.front().batch->view;
    return snapshot;
}

} // namespace fumage::ui
