#include "ui/preview/picture_planner.h"

#include <algorithm>

namespace fumage::ui {

namespace {

/// Time for a picture while the hand moves: 30 frames/s, less what the screen needs.
constexpr qint64 kBudgetNs = 28'000'000;
/// Where nothing is simulated: 60 frames/s.
constexpr qint64 kLookBudgetNs = 13'000'000;
/// Share of a budget that particles may take; the rest is for pixels.
constexpr qint64 particleBudget(qint64 budgetNs)
{
    return budgetNs * 3 / 4;
}
constexpr qint64 kParticleBudgetNs = particleBudget(kBudgetNs);

/// In which a picture that needs a pre-roll is still said to come at once.
constexpr qint64 kSoonNs = 400'000'000;

constexpr int kCoarseAir = 20; ///< cells: some tens of milliseconds for two hundred steps

/// What the final quality adds would cost the motion more than it gives.
Scene sceneFor(const RenderRequest& request)
{
    Scene scene = *request.scene;
    if (request.previewQuality != PreviewQuality::Full) {
        scene.output.quality = std::min(scene.output.quality, Quality::Good);
    }
    return scene;
}

} // namespace

int PicturePlanner::particlesWhileDragging(const PicturePlan& plan, double preRoll) const
{
    const int all = plan.particles;
    if (all <= m_costs.particlesWithin(kParticleBudgetNs, plan.stepsEach, plan.drawnShare())) {
        return all;
    }
    // A drag of the look keeps the particles that its first picture has chosen.
    const std::optional<RunningSimulator>& thinned = m_simulators.thinned();
    if (thinned && thinned->simulation == plan.simulation && thinned->particles < all) {
        return thinned->particles;
    }
    return CostEstimate::halvedInto(all, m_costs.particlesWithin(kParticleBudgetNs, preRoll, plan.drawnShare()));
}

bool PicturePlanner::isAtHand(const PicturePlan& plan) const
{
    const RunningSimulator* complete = m_simulators.complete(plan);
    return complete != nullptr && complete->hasBegun
        && m_costs.particlesWithin(kLookBudgetNs / 4, plan.stepsEach, 0.0) >= plan.particles;
}

void PicturePlanner::drawWhatIsAffordable(PicturePlan& plan)
{
    const int affordable = m_costs.particlesWithin(particleBudget(kLookBudgetNs), 0.0, plan.drawnShare());
    if (plan.particles <= affordable) {
        m_sparse.reset();
        return;
    }
    // Pictures of a drag have the same ones, as long as twice as many cannot be had and they are not twice too many.
    const int chosen = CostEstimate::halvedInto(plan.particles, affordable);
    const bool goesOn = m_sparse && m_sparse->simulation == plan.simulation && m_sparse->of == plan.particles;
    if (!goesOn || chosen > m_sparse->particles || m_sparse->particles / 2 > affordable) {
        m_sparse = Sparse{plan.simulation, plan.particles, chosen};
    }
    plan.drawSparsely(m_sparse->particles);
}

int PicturePlanner::particlesToSettle(int all, double preRoll) const
{
    const int affordable = m_costs.particlesWithin(kSoonNs, preRoll);
    // Where the whole is not far off, it comes at once.
    constexpr int kNear = 3;
    if (all / kNear <= affordable) {
        return all;
    }
    return CostEstimate::halvedInto(all, affordable);
}

int PicturePlanner::particlesToPlay(const PicturePlan& plan, double preRoll, double stepsAFrame) const
{
    // Those that have begun go on: a new pre-roll for others would be seen.
    const std::optional<RunningSimulator>& settling = m_simulators.settling();
    if (settling && settling->simulation == plan.simulation && settling->coarseAir == plan.coarseAir
        && settling->particles <= plan.particles) {
        return settling->particles;
    }
    const int soon = m_costs.particlesWithin(kSoonNs, preRoll);
    return CostEstimate::halvedInto(
        plan.particles, std::min(soon, m_costs.particlesWithin(kParticleBudgetNs, stepsAFrame)));
}

bool PicturePlanner::lacksAir(const RenderRequest& request, const PicturePlan& plan, const Schedule& schedule) const
{
    const Air& air = plan.layers.front()->air;
    if (!air.enabled || air.resolution <= kCoarseAir
        || (request.previewQuality != PreviewQuality::Interactive && request.previewQuality != PreviewQuality::Playback
            && request.mayBake)) {
        return false;
    }
    const std::int64_t missing = m_shelf->missingSteps(plan.layers, request.frame);
    // The steps of one frame come with it.
    const bool areFew = request.previewQuality == PreviewQuality::Playback && request.mayBake
        && missing <= 2 * schedule.stepsPerFrame + 1;
    return missing > 0 && !areFew;
}

bool PicturePlanner::isSlowToBegin(const RenderRequest& request, const PicturePlan& plan) const
{
    const RunningSimulator* complete = m_simulators.complete(plan);
    const bool hasBegun = (complete != nullptr && complete->hasBegun) || request.prepared;
    return request.previewQuality == PreviewQuality::Playback && !hasBegun
        && m_costs.particlesWithin(kSoonNs, plan.stepsEach) < plan.particles;
}

void PicturePlanner::scaleDown(const RenderRequest& request, Quality quality, qint64 budgetNs, PicturePlan& plan) const
{
    const double pixels = static_cast<double>(request.width) * request.height;
    const int particles = plan.sparse.empty() ? plan.particles : plan.drawnParticles();
    const double share = plan.sparse.empty() ? plan.drawnShare() : 1.0;
    plan.scale = m_costs.scaleWithin(budgetNs, particles, plan.stepsEach, pixels, share);
    plan.phaseMix = PhaseMix::Choose;
    plan.complete = plan.keepsAll && plan.sparse.empty() && plan.scale == 1.0
        && quality == request.scene->output.quality
        && std::none_of(
            plan.layers.begin(), plan.layers.end(), [](const SampledEffect& layer) { return hasDetail(layer); });
}

PicturePlan PicturePlanner::planFor(const RenderRequest& request)
{
    Scene asked = sceneFor(request);
    const bool hasItsQuality = asked.output.quality == request.scene->output.quality;
    PicturePlan plan(asked, request.solo);
    plan.simulation = request.simulation;
    const Schedule schedule = plan.longestSchedule();
    plan.coarseAir = lacksAir(request, plan, schedule);
    if (plan.coarseAir) {
        asked.air.resolution = kCoarseAir;
        plan.takeLayersOf(asked);
    } else if (hasItsQuality) {
        m_simulators.renew(plan);
    }
    // Particles are of all ages: a pre-roll takes half a life each.
    const double preRoll = 0.5 * static_cast<double>(schedule.lifetimeSteps);
    const int all = plan.particles;
    const auto thinTo = [&](int count) {
        plan.keepsAll = count == all && !plan.coarseAir;
        plan.thinTo(count);
        plan.stepsEach = m_simulators.stepsEach(plan, request.frame, preRoll);
    };
    plan.stepsEach = m_simulators.stepsEach(plan, request.frame, preRoll);
    if (request.previewQuality != PreviewQuality::Interactive) {
        m_sparse.reset();
    }
    switch (request.previewQuality) {
    case PreviewQuality::Full:
        plan.settles = plan.coarseAir;
        plan.keepsAll = !plan.coarseAir;
        plan.complete = plan.keepsAll;
        break;
    case PreviewQuality::Intermediate:
        plan.settles = true;
        if (!isAtHand(plan)) {
            thinTo(particlesToSettle(all, preRoll));
        } else if (const int count = particlesToSettle(all, plan.stepsEach); count < all) {
            plan.drawSparsely(count);
        }
        plan.complete = plan.keepsAll && plan.sparse.empty() && hasItsQuality;
        break;
    case PreviewQuality::Interactive:
        if (isAtHand(plan)) {
            drawWhatIsAffordable(plan);
            scaleDown(request, asked.output.quality, kLookBudgetNs, plan);
        } else {
            thinTo(particlesWhileDragging(plan, preRoll));
            scaleDown(request, asked.output.quality, kBudgetNs, plan);
        }
        break;
    case PreviewQuality::Playback:
        if (plan.coarseAir || isSlowToBegin(request, plan)) {
            plan.settles = true;
            thinTo(particlesToPlay(plan, preRoll, static_cast<double>(schedule.stepsPerFrame)));
        }
        scaleDown(request, asked.output.quality, kBudgetNs, plan);
        break;
    }
    return plan;
}

} // namespace fumage::ui
