#include "core/rendering/pick.h"

#include "core/lighting/glow.h"
#include "core/rendering/compositor.h"
#include "core/rendering/passes.h"

#include <algorithm>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace fumage {

namespace {

constexpr int kAround = 1; ///< pixels to each side
constexpr int kEdge = 2 * kAround + 1;

/// The sprites of a batch that reach the pixels around one, in a picture of those alone.
SpriteBatch partAround(const SpriteBatch& batch, int x, int y)
{
    SpriteBatch part;
    part.style = batch.style;
    part.view = batch.view;
    part.view.width = kEdge;
    part.view.height = kEdge;
    for (std::size_t i = 0; i < batch.sprites.size(); ++i) {
        const SpriteBox& box = batch.boxes[i];
        const bool reaches = box.left <= box.right && box.left <= x + kAround && box.right >= x - kAround
            && box.top <= y + kAround && box.bottom >= y - kAround;
        if (!reaches || batch.depth[i] == SpriteBatch::kHidden) {
            continue;
        }
        Sprite sprite = batch.sprites[i];
        sprite.x -= static_cast<float>(x - kAround);
        sprite.y -= static_cast<float>(y - kAround);
        part.add(sprite, batch.depth[i]);
        if (!batch.details.empty()) {
            part.details.push_back(batch.details[i]);
        }
    }
    return part;
}

/// What a sprite that covers a pixel has to do with how it looks: its light, and that it stands before what is behind.
float weightOf(const Sprite& sprite)
{
    constexpr float kBody = 0.2F;
    const glm::vec3 light(sprite.direct[0] + sprite.ambient[0], sprite.direct[1] + sprite.ambient[1],
        sprite.direct[2] + sprite.ambient[2]);
    return kBody + glm::dot(light, kLuminance);
}

/// Colours in which a sprite of one layer is as bright as its weight, and those of the others are black.
std::vector<SpriteTarget> targetOf(std::size_t layer, const std::vector<SpriteBatch>& parts)
{
    std::vector<SpriteTarget> target(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        target[i].colours.resize(SpriteTarget::kStride * parts[i].sprites.size());
        for (std::size_t j = 0; j < parts[i].sprites.size(); ++j) {
            const float weight = i == layer ? weightOf(parts[i].sprites[j]) : 0.0F;
            std::fill_n(&target[i].colours[SpriteTarget::kStride * j], SpriteTarget::kStride, weight);
        }
    }
    return target;
}

float meanOf(const Image& image)
{
    float sum = 0.0F;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            sum += image.at(x, y).r;
        }
    }
    return sum / static_cast<float>(kEdge * kEdge);
}

} // namespace

std::optional<std::size_t> layerAt(SpriteLayers layers, int x, int y)
{
    std::vector<SpriteBatch> parts;
    for (const SpriteLayer& layer : layers) {
        parts.push_back(partAround(*layer.batch, x, y));
    }
    std::vector<SpriteLayer> drawn;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        drawn.push_back({&parts[i], layers[i].texture, layers[i].picture});
    }
    constexpr float kSeen = 0.002F; // of a weight: less is no step of eight bits
    float most = kSeen;
    std::optional<std::size_t> found;
    Compositor compositor;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        if (parts[i].sprites.empty()) {
            continue;
        }
        const std::vector<SpriteTarget> colours = targetOf(i, parts);
        Image image;
        const RenderTarget target{colours.data(), &image};
        if (!compositor.composeAll(drawn, {&target, 1})) {
            return std::nullopt;
        }
        if (const float share = meanOf(image); share > most) {
            most = share;
            found = i;
        }
    }
    return found;
}

} // namespace fumage
