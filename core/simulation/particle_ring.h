#pragma once

#include "core/simulation/particles.h"

#include <algorithm>
#include <cstdint>

namespace fumage {

/// Where particles lie: slots are a ring, and that of a particle is its birth index modulo the capacity.
class ParticleRing {
public:
    explicit ParticleRing(const Particles& particles)
        : m_capacity(static_cast<std::int64_t>(particles.capacity))
    {
    }

    [[nodiscard]] std::int64_t capacity() const { return m_capacity; }

    /// The slot of a particle.
    [[nodiscard]] std::size_t slotOf(std::int64_t birthIndex) const
    {
        return static_cast<std::size_t>(birthIndex % m_capacity);
    }

    /// Visits the particles [first, last) of consecutive birth index that fall into a chunk, lap by lap of the ring:
    /// visit(low, high, slot of low).
    template <class Visit>
    void forChunk(std::size_t chunk, std::int64_t first, std::int64_t last, const Visit& visit) const
    {
        const Slots own = slotsOf(chunk);
        for (std::int64_t lap = first / m_capacity * m_capacity; lap < last; lap += m_capacity) {
            const std::int64_t low = std::max(first, lap + own.begin);
            const std::int64_t high = std::min(last, lap + own.end);
            if (low < high) {
                visit(low, high, static_cast<std::size_t>(low - lap));
            }
        }
    }

    /// Whether any of the particles [first, last) falls into a chunk.
    [[nodiscard]] bool reaches(std::size_t chunk, std::int64_t first, std::int64_t last) const
    {
        bool any = false;
        forChunk(chunk, first, last, [&](std::int64_t, std::int64_t, std::size_t) { any = true; });
        return any;
    }

    /// Empties the slots of a chunk that none of the particles [first, last) has, and its padding.
    void clearOthers(Particles& particles, std::size_t chunk, std::int64_t first, std::int64_t last) const
    {
        if (last - first < m_capacity) {
            // The ring's free slots are those of the births that come next.
            forChunk(chunk, last, first + m_capacity, [&](std::int64_t low, std::int64_t high, std::size_t slot) {
                particles.clear(slot, slot + static_cast<std::size_t>(high - low));
            });
        }
        const Slots own = slotsOf(chunk);
        particles.clear(static_cast<std::size_t>(std::max(own.begin, own.end)), (chunk + 1) * Particles::kChunk);
    }

private:
    /// Slots [begin, end) of a chunk without padding.
    struct Slots {
        std::int64_t begin, end;
    };

    [[nodiscard]] Slots slotsOf(std::size_t chunk) const
    {
        const auto begin = static_cast<std::int64_t>(chunk * Particles::kChunk);
        return {begin, std::min(begin + static_cast<std::int64_t>(Particles::kChunk), m_capacity)};
    }

    std::int64_t m_capacity;
};

} // namespace fumage
