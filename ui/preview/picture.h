#pragma once

#include "ui/preview/sprite_snapshot.h"

#include "core/effect/effect.h"
#include "core/rendering/camera.h"
#include "core/rendering/renderer.h"
#include "core/scene/scene.h"
#include "core/simulation/scene_simulator.h"

#include <QImage>
#include <QMetaType>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace fumage::ui {

/// What lies behind smoke that is transparent.
struct Backdrop {
    enum class Kind {
        Colour,
        Checker,
    };
    Kind kind = Kind::Colour;
    glm::vec3 colour{0.012F, 0.015F, 0.021F}; ///< linear RGB; a dark blue grey
    friend bool operator==(const Backdrop&, const Backdrop&) = default;
};

/// How much a picture may give up to be there in time.
enum class PreviewQuality {
    Full, ///< all pixels and all particles; given up when something newer is asked for
    Playback, ///< fewer pixels where a frame would come late
    Interactive, ///< fewer pixels, and fewer but larger particles
    Intermediate, ///< as many particles as come soon; given up when something newer is asked for
};

/// What a picture is waiting for.
enum class Phase {
    Idle, ///< nothing
    Air, ///< the steps of the air that carries the smoke
    Steps, ///< the steps of the particles to the frame
    Light, ///< light and shadow, and the noise of the sprites
    Paint, ///< the pixels
};
/// Hears of the phases of a picture, on the thread that makes it.
/// @param share that is done, 0 to 1; below 0: not known
using WorkListener = std::function<void(Phase phase, double share)>;

/// A question which layer is seen at a place of a picture.
struct Pick {
    quint64 number = 0; ///< by which the answer is known; 0: nothing is asked
    glm::vec2 place{0.0F}; ///< from the left and from the top, shares of the picture
};
struct Picked {
    quint64 number = 0; ///< of the question; 0: nothing was asked
    std::optional<std::size_t> layer; ///< of the scene; none is seen there
};

struct RenderRequest {
    std::shared_ptr<const Scene> scene;
    std::size_t layer = 0; ///< of it that trails and arrows are about
    std::vector<std::size_t> solo; ///< layers that are looked at alone: the others are simulated, and neither drawn nor
                                   ///< in the light; empty: all that are visible
    quint64 revision = 0; ///< of all that is asked for: pictures of one revision and frame are alike
    quint64 simulation = 0; ///< of what moves particles: scenes of one simulation and count have the same ones, and a
                            ///< previewRenderer keeps them
    int frame = 0;
    int width = 1; ///< pixels of the screen
    int height = 1;
    Backdrop backdrop;
    PreviewQuality previewQuality = PreviewQuality::Full;
    bool mayBake = true; ///< else coarser air stands in for what is not baked, whatever the quality
    std::shared_ptr<SceneSimulator>
        prepared; ///< of this simulation, at a frame a moment ago; null: none. For the one who makes the picture
    bool trails = false; ///< find the ways of some particles
    bool air = false; ///< find what the air does that carries them
    bool sprites = false; ///< hand over the sprites instead of painting them
    Pick pick;
};

/// Where a particle has been, from its birth on, m.
using Trail = std::vector<glm::vec3>;

/// The air at a place.
struct AirArrow {
    glm::vec3 place; ///< m
    glm::vec3 velocity; ///< m/s
    float heat = 0.0F; ///< 1 at the source
    float gap = 0.0F; ///< to its neighbours, m
};

/// What a visible layer has of a picture.
struct LayerWork {
    std::size_t layer = 0; ///< of the scene
    int particles = 0; ///< alive at most
    double particleSteps = 0.0; ///< that were taken for this picture, of all its particles together
};

/// A picture of the smoke for the screen, or the sprites to make one.
struct Picture {
    QImage image; ///< opaque; smaller than the screen where the quality gives up pixels
    std::shared_ptr<const SpriteBatchSnapshot> sprites; ///< instead of the image, where sprites were asked for
    std::vector<Trail> trails; ///< where they were asked for
    std::vector<AirArrow> air; ///< where it was asked for and carries the smoke
    Picked picked;
    Output output; ///< exposure and view transform for the sprites
    Backdrop backdrop;
    quint64 revision = 0;
    int frame = 0;
    bool complete = false; ///< nothing was given up
    bool thinned = false; ///< fewer particles than the effect has, or coarser air
    bool coarseAir = false; ///< a coarser grid stands in
    qint64 bakeNs = 0; ///< that the air took for this picture
    int particles = 0; ///< alive at most, of all layers that are drawn
    std::vector<LayerWork> layers; ///< those that are visible, in their order
    qint64 stepNs = 0;
    RenderTimes times;
};
using PicturePtr = std::shared_ptr<const Picture>;

/// The camera's view in a window of another shape: the frame that is exported fits in, with its surroundings around it.
[[nodiscard]] View windowView(const Scene& scene, int frame, int width, int height);

/// Where the exported frame lies in such a window, in its pixels.
[[nodiscard]] QRectF exportFrame(const Scene& scene, int width, int height);

} // namespace fumage::ui
