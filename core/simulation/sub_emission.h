#pragma once

#include "core/base/result.h"
#include "core/base/task.h"
#include "core/simulation/simulation_model.h"

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace fumage {

/// What a particle's birth on one of another layer adds to its birth at the emitter.
struct SubEmission {
    glm::vec3 away{0.0F}; ///< from the emitter's place, m
    glm::vec3 velocity{0.0F}; ///< that it takes along, m/s
    bool isThere = false; ///< else there was nothing to be born on, and it is not born
};

/// Who knows where particles are born that are born on those of another layer.
class SubEmissionSource {
public:
    virtual ~SubEmissionSource() = default;

    /// @param child of the layer whose births they are, always the same
    /// @param step  of the child, at which the births appear
    /// @param first,last indices of the births [first, last)
    /// @param out   gets one a birth
    /// @error Cancelled; that of the air
    [[nodiscard]] virtual Status find(const SimulationModel& child, std::int64_t step, std::int64_t first,
        std::int64_t last, std::vector<SubEmission>& out, const Task& task) = 0;

protected:
    SubEmissionSource() = default;
    SubEmissionSource(const SubEmissionSource&) = default;
    SubEmissionSource& operator=(const SubEmissionSource&) = default;
};

} // namespace fumage
