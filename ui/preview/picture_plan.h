#pragma once

#include "ui/preview/picture.h"

#include "core/effect/sampling.h"
#include "core/simulation/schedule.h"

#include <vector>

namespace fumage::ui {

/// What of a scene a picture simulates and draws, and what it gives up to be there in time.
struct PicturePlan {
    PicturePlan() = default;
    /// All that a scene has.
    /// @param solo see RenderRequest::solo
    PicturePlan(const Scene& scene, const std::vector<std::size_t>& solo);

    /// Gives particles up, see thinLayers().
    void thinTo(int most);
    /// Draws a share of the particles that are simulated.
    /// @param most of all layers
    void drawSparsely(int most);
    /// Takes the layers as they are in another scene, which differs in its surroundings.
    void takeLayersOf(const Scene& scene);
    /// The schedule of the layer whose particles live longest.
    [[nodiscard]] Schedule longestSchedule() const;
    /// Share of the particles that is drawn.
    [[nodiscard]] double drawnShare() const;
    /// How many are drawn.
    [[nodiscard]] int drawnParticles() const;
    /// The layers as they are drawn.
    [[nodiscard]] const std::vector<SampledEffect>& looks() const { return sparse.empty() ? layers : sparse; }

    quint64 simulation = 0;
    std::vector<SampledEffect> layers; ///< that are simulated, thinned where need be
    std::vector<SampledEffect> sparse; ///< the same, where not all of their particles are drawn; else empty
    std::vector<SampledEffect> muted; ///< those that are not, as they would be
    std::vector<std::size_t> drawn; ///< places in layers: those that no solo hides
    int particles = 0; ///< of all layers
    double scale = 1.0; ///< of the picture's edge
    double stepsEach = 1.0; ///< that particles have to take, on average
    bool keepsAll = true; ///< particles
    bool coarseAir = false; ///< the air of a coarser grid stands in until there is time for its own
    bool settles = false; ///< particles as few as come soon, see PreviewQuality::Intermediate
    PhaseMix phaseMix = PhaseMix::Blend;
    bool complete = true; ///< and pixels, and both phases of the detail
};

} // namespace fumage::ui
