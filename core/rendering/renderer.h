#pragma once

#include "core/base/result.h"
#include "core/rendering/compositor.h"
#include "core/simulation/frame.h"

#include <chrono>
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

/// Makes pictures of frames: looks, light, sprites, compositor, supersampling and background.
///
/// Keeps the noise texture until the noise changes, and all buffers. Not thread-safe; uses all threads inside.
class Renderer {
public:
    /// @param frame  the particles
    /// @param effect the look; its simulation part must be that of the frame
    /// @param width,height pixels; the picture is rendered effect.output.supersample times larger and averaged
    /// @param image  resized; linear premultiplied light, before exposure and view transform
    /// @error TooLarge before allocating, Cancelled
    /// A pure function of its arguments, to the bit.
    [[nodiscard]] Status render(const Frame& frame, const Effect& effect, int width, int height, Image& image, const std::stop_token& stop = {});

    [[nodiscard]] const RenderTimes& times() const { return m_times; }

private:
    [[nodiscard]] Status updateTexture(const Noise& noise, const std::stop_token& stop);

    Noise m_noise;
    std::optional<SpriteTexture> m_texture;
    Appearance m_appearance;
    LightGrid m_light;
    SpriteBatch m_batch;
    Compositor m_compositor;
    Image m_large;
    RenderTimes m_times;
};

} // namespace fumage
