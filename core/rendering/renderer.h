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
#include <stop_token>

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
    /// @param frame  the particles
    /// @param effect the look; its simulation part must be that of the frame
    /// @param width,height pixels; the picture is rendered effect.output.supersample times larger and averaged
    /// @param image  resized; linear premultiplied light, before exposure, view transform and background
    /// @error TooLarge before allocating, OutOfRange where a particle is nowhere, Cancelled
    /// A pure function of its arguments and of setPhaseMix(), to the bit.
    [[nodiscard]] Status render(const Frame& frame, const SampledEffect& effect, int width, int height, Image& image,
        const std::stop_token& stop = {});

    /// How detail that the air carries is shown from the next picture on; at first as a blend of both phases, as
    /// exports have it.
    void setPhaseMix(PhaseMix mix) { m_phaseMix = mix; }

    /// The first part of render(), for those who draw the sprites themselves or look through a view of their own:
    /// afterwards batch() and texture() hold what there is to draw.
    /// @error OutOfRange where a particle is nowhere, Cancelled
    [[nodiscard]] Status prepare(
        const Frame& frame, const SampledEffect& effect, const View& view, const std::stop_token& stop = {});

    /// Paints what prepare() has left, at the size of its view, with transparency.
    /// @error TooLarge before allocating, Cancelled
    [[nodiscard]] Status composite(Image& image, const std::stop_token& stop = {});

    /// Valid after prepare() or render() and until the next of them.
    [[nodiscard]] const SpriteBatch& batch() const { return m_batch; }
    /// The noise that the sprites of batch() show; null before the first picture.
    [[nodiscard]] const std::shared_ptr<const SpriteTexture>& texture() const { return m_texture; }
    /// What the look has made of the particles; valid as batch() is, with bounds in the axes of the light.
    [[nodiscard]] const Appearance& appearance() const { return m_appearance; }
    /// The light that the sprites of batch() are in; valid as batch() is.
    [[nodiscard]] const LightGrid& light() const { return m_light; }
    /// The detail that the smoke of batch() has; null: none. Valid as batch() is.
    [[nodiscard]] const DetailField* detail() const { return m_detail ? &*m_detail : nullptr; }
    /// How long the parts of the last picture took.
    [[nodiscard]] const RenderTimes& times() const { return m_times; }

private:
    [[nodiscard]] Status updateTexture(const Noise& noise, const std::stop_token& stop);
    [[nodiscard]] Status updateDetail(const Frame& frame, const Effect& effect, const std::stop_token& stop);

    PhaseMix m_phaseMix = PhaseMix::Blend;
    Noise m_noise;
    std::shared_ptr<const SpriteTexture> m_texture;
    std::unique_ptr<AdvectedCoordinates> m_coordinates; ///< where m_detail finds it, wherever the renderer is moved
    std::optional<DetailField> m_detail;
    Appearance m_appearance;
    LightGrid m_light;
    LightWorkspace m_lightWorkspace;
    FireWorkspace m_fireWorkspace;
    OverlapWorkspace m_overlapWorkspace;
    SpriteBatch m_batch;
    Compositor m_compositor;
    Image m_large;
    RenderTimes m_times;
};

} // namespace fumage
