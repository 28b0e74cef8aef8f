#include "core/simulation/simulator.h"

#include "core/simulation/air_plan.h"

#include <algorithm>

namespace fumage {

namespace {

/// Checkpoints a lifetime: a jump steps an eighth of a pre-roll at most once they are there.
constexpr std::int64_t kCheckpointsALifetime = 8;

} // namespace

Simulator::Simulator(const SampledEffect& effect, std::size_t checkpointBytes, const std::shared_ptr<AirCache>& shelf)
    : m_airStatus(checkAir(effect))
    , m_model(std::make_shared<const SimulationModel>(effect, m_airStatus ? airFor({&effect, 1}, shelf) : nullptr))
    , m_checkpoints(checkpointBytes)
{
}

Simulator::Simulator(std::shared_ptr<const SimulationModel> model, std::size_t checkpointBytes)
    : m_airStatus(Done{})
    , m_model(std::move(model))
    , m_subEmitter(m_model->parent() ? std::make_unique<SubEmitter>(*m_model) : nullptr)
    , m_checkpoints(checkpointBytes)
{
}

int Simulator::inLoop(int number) const
{
    return m_model->schedule().loopSteps != 0 ? number % m_model->effect()->timeline.length : number;
}

double Simulator::stepsTo(int number) const
{
    number = inLoop(number);
    const std::int64_t step = m_model->schedule().stepOfFrame(number);
    const std::int64_t lifetime = m_model->schedule().lifetimeSteps;
    const std::shared_ptr<const Frame> start = nearestBefore(number);
    // Particles are of all ages: a pre-roll takes half a life each.
    return start && start->step >= step - lifetime ? static_cast<double>(step - start->step)
                                                   : 0.5 * static_cast<double>(lifetime);
}

std::shared_ptr<const Frame> Simulator::nearestBefore(int number) const
{
    std::shared_ptr<const Frame> checkpoint = m_checkpoints.nearestBefore(number);
    const bool latestIsNearer =
        m_latest && m_latest->number <= number && (!checkpoint || checkpoint->number < m_latest->number);
    return latestIsNearer ? m_latest : checkpoint;
}

std::shared_ptr<Frame> Simulator::blankFrame()
{
    for (const std::shared_ptr<Frame>& frame : m_pool) {
        if (frame.use_count() == 1) {
            return frame;
        }
    }
    // All are in use elsewhere, as checkpoints perhaps: the oldest makes room for a new one.
    constexpr std::size_t kFramesReused = 4;
    if (m_pool.size() == kFramesReused) {
        m_pool.erase(m_pool.begin());
    }
    return m_pool.emplace_back(std::make_shared<Frame>());
}

Result<std::shared_ptr<const Frame>> Simulator::frame(int number, const Task& task)
{
    if (!m_airStatus) {
        return m_airStatus.error();
    }
    const Schedule& schedule = m_model->schedule();
    number = inLoop(number);
    const std::shared_ptr<const Frame> start = nearestBefore(number);
    if (start && start->number == number) {
        return start;
    }
    const std::int64_t step = schedule.stepOfFrame(number);
    const std::int64_t preRollStart = step - schedule.lifetimeSteps;
    const std::shared_ptr<Frame> next = blankFrame();
    const Status status = start && start->step >= preRollStart
        ? advanceInto(*m_model, start->particles, next->particles, start->step, step, m_subEmitter.get(), task)
        : advanceFromNothing(*m_model, next->particles, step, m_subEmitter.get(), task);
    if (!status) {
        return status.error();
    }
    next->model = m_model;
    next->number = number;
    next->step = step;
    m_latest = next;
    m_checkpoints.offer(m_latest,
        static_cast<int>(
            std::max<std::int64_t>(1, schedule.lifetimeSteps / schedule.stepsPerFrame / kCheckpointsALifetime)));
    return m_latest;
}

} // namespace fumage
