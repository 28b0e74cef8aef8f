#pragma once

#include "core/lighting/six_way.h"
#include "core/rendering/passes.h"
#include "core/rendering/renderer.h"

namespace fumage {

/// A frame and those that are shown before and after it, which tell where its particles come from and go to.
struct FrameAmongOthers {
    const Frame* now = nullptr;
    const Frame* previous = nullptr; ///< null: none
    const Frame* next = nullptr; ///< null: none
    int sincePrevious = 1; ///< frames from the one before, whatever a loop calls them
    int untilNext = 1;
};

/// Makes the targets of frames: the same sprites, in the same order, in several sets of colours. They are made, binned
/// and sorted once.
///
/// Light maps: the smoke is white, and a white light of intensity 1 lights it from each direction of the camera's
/// frame; what shadows, scatters and shades is the effect's own. Emission, albedo and temperature are what the sprites
/// have in them under other lights. Keeps its buffers. Not thread-safe.
class PassRenderer {
public:
    /// @param width,height pixels; rendered effect.output.supersample times larger and averaged
    /// @param passes  what the targets must do for
    /// @param images  the targets that are needed are resized and written, the others emptied; linear and
    /// premultiplied, without background
    /// @error TooLarge before allocating, Cancelled
    /// A pure function of its arguments, to the bit.
    [[nodiscard]] Status render(const FrameAmongOthers& frames, const SampledEffect& effect, int width, int height,
        PassSet passes, PassImages& images, const std::stop_token& stop = {});

    /// What the look has made of the particles of the last frame.
    [[nodiscard]] const Appearance& appearance() const { return m_renderer.appearance(); }

private:
    [[nodiscard]] SpriteTarget& target(PassTarget which) { return m_targets[static_cast<std::size_t>(which)]; }
    void makeTargets(const FrameAmongOthers& frames, const SampledEffect& effect, PassSet passes);
    void makeOtherSprites(const Frame& frame, const Effect& other, const LightGrid& light);
    void take(const float (Sprite::*colour)[3], SpriteTarget& to);
    void fillColours(const FrameAmongOthers& frames, const SampledEffect& effect, PassSet passes);

    Renderer m_renderer;
    Compositor m_compositor;
    Appearance m_inView; ///< with bounds in the axes of the camera
    SixWayLight m_sixWay;
    LightWorkspace m_lightWorkspace;
    SpriteBatch m_other; ///< the sprites under other light
    LightGrid m_even; ///< the light of the frame, but for the sun, which is everywhere
    std::array<SpriteTarget, kPassTargets> m_targets;
    PassImages m_large;
    Particles m_previous; ///< those of other turns of a loop, in the slots of this one
    Particles m_next;
};

} // namespace fumage
