#pragma once

#include "core/base/result.h"
#include "core/lighting/detail_field.h"
#include "core/lighting/fire_light.h"
#include "core/lighting/overlap.h"
#include "core/rendering/compositor.h"
#include "core/simulation/frame.h"

#include <chrono>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace fumage {

/// How long the parts of the last picture took.
struct RenderTimes {
    std::chrono::nanoseconds texture{0};
    std::chrono::nanoseconds light{0};
    std::chrono::nanoseconds sprites{0};
    std::chrono::nanoseconds composite{0};
};

/// Makes pictures of frames: looks, light, sprites, compositor and supersampling.
///
/// Keeps the noise texture until the noise changes, and all buffers. Not thread-safe; uses all threads inside.
class Renderer {
public:
    /// @param layers drawn together
    /// @param width,height pixels; the picture is rendered effect.output.supersample times larger and averaged
    /// @param image  resized; linear premultiplied light, before exposure, view transform and background
    /// @error TooLarge before allocating, OutOfRange where a particle is nowhere, Cancelled
    /// A pure function of its arguments and of setPhaseMix(), to the bit.
    [[nodiscard]] Status render(
        LayerFrames layers, int width, int height, Image& image, const std::stop_token& stop = {});

    /// The same of one layer.
    [[nodiscard]] Status render(const Frame& frame, const SampledEffect& effect, int width, int height, Image& image,
        const std::stop_token& stop = {})
    {
        const LayerFrame layer{&frame, &effect};
        return render({&layer, 1}, width, height, image, stop);
    }

    /// How detail that the air carries is shown from the next picture on; at first as a blend of both phases, as
    /// exports have it.
    void setPhaseMix(PhaseMix mix) { m_phaseMix = mix; }

    /// The first part of render(), for those who draw the sprites themselves or look through a view of their own:
    /// afterwards batch() and texture() hold what there is to draw.
    /// @error OutOfRange where a particle is nowhere, Cancelled
    [[nodiscard]] Status prepare(LayerFrames layers, const View& view, const std::stop_token& stop = {});

    /// The same of one layer.
    [[nodiscard]] Status prepare(
        const Frame& frame, const SampledEffect& effect, const View& view, const std::stop_token& stop = {})
    {
        const LayerFrame layer{&frame, &effect};
        return prepare({&layer, 1}, view, stop);
    }

    /// Paints what prepare() has left, at the size of its view, with transparency.
    /// @error TooLarge before allocating, Cancelled
    [[nodiscard]] Status composite(Image& image, const std::stop_token& stop = {});

    /// What there is to draw; valid after prepare() or render() and until the next of them.
    [[nodiscard]] SpriteLayers layers() const { return m_drawn; }
    /// The sprites of a layer; valid as layers() is.
    [[nodiscard]] const SpriteBatch& batch(std::size_t layer = 0) const { return m_layers[layer]->batch; }
    /// The noise that they show; null before the first picture.
    [[nodiscard]] std::shared_ptr<const SpriteTexture> texture(std::size_t layer = 0) const
    {
        return layer < m_layers.size() ? m_layers[layer]->surface.texture : nullptr;
    }
    /// The noise, or the picture in its place, that the sprites of a layer show; valid as layers() is.
    [[nodiscard]] const SpriteSurface& surface(std::size_t layer = 0) const { return m_layers[layer]->surface; }
    /// What the look has made of the particles; valid as layers() is, with bounds in the axes of the light.
    [[nodiscard]] const Appearance& appearance(std::size_t layer = 0) const { return m_layers[layer]->appearance; }
    /// The light that all sprites are in; valid as layers() is.
    [[nodiscard]] const LightGrid& light() const { return m_light; }
    /// The detail that the smoke of a layer has; null: none. Valid as layers() is.
    [[nodiscard]] const DetailField* detail(std::size_t layer = 0) const
    {
        return m_layers[layer]->detail ? &*m_layers[layer]->detail : nullptr;
    }
    /// How long the parts of the last picture took.
    [[nodiscard]] const RenderTimes& times() const { return m_times; }

private:
    /// What is kept of a layer from one picture to the next.
    struct Layer {
        Noise noise;
        Bitmap picture;
        SpriteSurface surface;
        std::shared_ptr<AdvectedCoordinates> coordinates; ///< of its detail, with all that have the same
        std::optional<DetailField> detail;
        Appearance appearance;
        std::size_t body = 0; ///< which of m_bodies it lies in, where it has detail
        SpriteBatch batch;
    };

    [[nodiscard]] Status updateTexture(const Noise& noise, Layer& layer, const std::stop_token& stop);
    static void updatePicture(const Look& look, Layer& layer);
    [[nodiscard]] Status updateDetail(LayerFrames layers, std::size_t number, const std::stop_token& stop);
    [[nodiscard]] Status findSmoke(LayerFrames layers, const glm::vec3& eye);
    void findBodies();

    PhaseMix m_phaseMix = PhaseMix::Blend;
    std::vector<std::unique_ptr<Layer>> m_layers; ///< of the last picture
    std::vector<LitLayer> m_lit;
    std::vector<AlignedArray<float>> m_bodies; ///< of each length of wave, see findBody()
    std::vector<SpriteLayer> m_drawn;
    LightGrid m_light;
    LightWorkspace m_lightWorkspace;
    FireWorkspace m_fireWorkspace;
    OverlapWorkspace m_overlapWorkspace;
    Compositor m_compositor;
    Image m_large;
    RenderTimes m_times;
};

} // namespace fumage
