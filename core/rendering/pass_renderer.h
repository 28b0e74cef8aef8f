#pragma once

#include "core/lighting/six_way.h"
#include "core/rendering/passes.h"
#include "core/rendering/renderer.h"

#include <vector>

namespace fumage {

/// A layer's frame and those that are shown before and after it, which tell where its particles come from and go to.
struct LayerAmongOthers {
    const SampledEffect* effect = nullptr; ///< its look
    const Frame* now = nullptr;
    const Frame* previous = nullptr; ///< null: none
    const Frame* next = nullptr; ///< null: none
};

/// The layers of a picture, one or more, and when the pictures before and after it are shown.
struct FrameAmongOthers {
    std::vector<LayerAmongOthers> layers;
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
    [[nodiscard]] Status render(const FrameAmongOthers& all, int width, int height, PassSet passes, PassImages& images,
        const std::stop_token& stop = {});

    /// The pictures of one layer of the last frame by itself: under the light that all layers have, with nothing before
    /// or behind it. Of a frame of one layer they are those of render().
    /// @param layer  its place in the frame
    /// @error as of render()
    [[nodiscard]] Status renderAlone(std::size_t layer, PassImages& images, const std::stop_token& stop = {})
    {
        return paint(layer, 1, images, stop);
    }

    /// The sprites of the last frame, at supersample times its size.
    [[nodiscard]] SpriteLayers layers() const { return m_renderer.layers(); }

    /// What the look has made of the particles of a layer in the last frame.
    [[nodiscard]] const Appearance& appearance(std::size_t layer = 0) const { return m_renderer.appearance(layer); }

private:
    /// The colours of a layer in one of the targets.
    [[nodiscard]] SpriteTarget& target(PassTarget which, std::size_t layer)
    {
        return m_targets[static_cast<std::size_t>(which)][layer];
    }
    void makeTargets(const FrameAmongOthers& frames, PassSet passes);
    void makeSixWays(const FrameAmongOthers& frames);
    void makeTargetsOf(const FrameAmongOthers& frames, std::size_t layer, PassSet passes);
    void makeOtherSprites(
        const LayerAmongOthers& layer, const Effect& other, const LightGrid& light, std::size_t number);
    void take(const float (Sprite::*colour)[3], SpriteTarget& to);
    void fillColours(const FrameAmongOthers& frames, std::size_t layer, PassSet passes);
    [[nodiscard]] Status paint(std::size_t first, std::size_t count, PassImages& images, const std::stop_token& stop);

    /// The frame with each layer as it is then.
    [[nodiscard]] const FrameAmongOthers& atThatFrame(const FrameAmongOthers& frames);

    FrameAmongOthers m_now; ///< where anything changes from frame to frame
    std::vector<SampledEffect> m_effects; ///< that it looks at
    Camera m_cameraBefore; ///< of the frames beside
    Camera m_cameraAfter;
    Renderer m_renderer;
    Compositor m_compositor;
    std::vector<Appearance> m_inView; ///< of each layer, with bounds in the axes of the camera
    SixWayLight m_sixWay;
    LightWorkspace m_lightWorkspace;
    SpriteBatch m_other; ///< the sprites of a layer under other light
    LightGrid m_even; ///< the light of the frame as it first scatters it, but for the sun, which is everywhere
    std::array<std::vector<SpriteTarget>, kPassTargets> m_targets; ///< of each layer
    PassSet m_passes; ///< of the last frame
    int m_factor = 1; ///< by which it is rendered larger
    PassImages m_large;
    Particles m_previous; ///< those of other turns of a loop, in the slots of this one
    Particles m_next;
};

} // namespace fumage
