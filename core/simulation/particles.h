#pragma once

#include "core/base/aligned_array.h"

#include <cstdint>
#include <limits>
#include <string_view>

namespace fumage {

/// The state of every particle at one step: a structure of arrays, one slot a particle, slot = birth index modulo capacity.
/// Arrays are padded to whole chunks; slots that are not alive hold zeros and kUnborn.
struct Particles {
    static constexpr std::int32_t kUnborn = std::numeric_limits<std::int32_t>::max();

    /// Slots that are stepped together: their arrays stay in the first-level cache.
    static constexpr std::size_t kChunk = 1024;

    // A new column needs its line in forEachColumn().
    AlignedArray<float> x, y, z; ///< position, m
    AlignedArray<float> vx, vy, vz; ///< velocity without the turbulence that carries the particle, m/s
    AlignedArray<float> rollX, rollY, rollZ; ///< how far the swirls have turned the particle, a rotation vector in radians; empty where nobody asks
    AlignedArray<float> relativeX, relativeY, relativeZ; ///< velocity against the air, m/s; empty where no air carries them
    AlignedArray<float> heat; ///< of the air at the particle, 1 at the source; empty where no air carries them
    AlignedArray<std::uint32_t> key; ///< random bits of the particle, see keyOf()
    AlignedArray<std::int32_t> birthStep; ///< kUnborn where the slot is empty
    std::size_t capacity = 0; ///< slots in use at most

    /// Makes room and empties every slot.
    /// @param rolls with room for rollX to rollZ
    /// @param inAir with room for relativeX to heat
    void reset(std::size_t slotCount, bool rolls = false, bool inAir = false);

    /// Empties slots [first, last).
    void clear(std::size_t first, std::size_t last);

    /// Takes the roll of slots [first, last) back to zero, where there is one.
    void clearRoll(std::size_t first, std::size_t last);

    /// Takes slots [first, last) over from particles with the same columns and at least as many slots.
    void copySlots(const Particles& from, std::size_t first, std::size_t last);

    /// Blocks of kChunk slots, which may be stepped in parallel.
    [[nodiscard]] std::size_t chunks() const { return x.size() / kChunk; }
    /// Whether the columns of the roll are there.
    [[nodiscard]] bool rolls() const { return !rollX.empty(); }
    /// Whether air carries them.
    [[nodiscard]] bool inAir() const { return !heat.empty(); }

    /// Memory of all columns.
    [[nodiscard]] std::size_t bytes() const;
};

/// Who has a column; where nobody asks for it, it has no slots.
enum class ColumnOf {
    All,
    Rolling,
    InAir
};

/// One column of Particles, whatever its type.
template <class T>
struct ParticleColumn {
    std::string_view name;
    AlignedArray<T> Particles::*member;
    T empty{}; ///< value of slots that are not alive
    ColumnOf owner = ColumnOf::All;

    [[nodiscard]] AlignedArray<T>& of(Particles& particles) const { return particles.*member; }
    [[nodiscard]] const AlignedArray<T>& of(const Particles& particles) const { return particles.*member; }
};

/// Calls visit(ParticleColumn) for every column: the one list of them, for all that has to treat each.
template <class Visit>
constexpr void forEachColumn(const Visit& visit)
{
    using Number = ParticleColumn<float>;
    visit(Number{"x", &Particles::x});
    visit(Number{"y", &Particles::y});
    visit(Number{"z", &Particles::z});
    visit(Number{"vx", &Particles::vx});
    visit(Number{"vy", &Particles::vy});
    visit(Number{"vz", &Particles::vz});
    visit(Number{"rollX", &Particles::rollX, 0.0F, ColumnOf::Rolling});
    visit(Number{"rollY", &Particles::rollY, 0.0F, ColumnOf::Rolling});
    visit(Number{"rollZ", &Particles::rollZ, 0.0F, ColumnOf::Rolling});
    visit(Number{"relativeX", &Particles::relativeX, 0.0F, ColumnOf::InAir});
    visit(Number{"relativeY", &Particles::relativeY, 0.0F, ColumnOf::InAir});
    visit(Number{"relativeZ", &Particles::relativeZ, 0.0F, ColumnOf::InAir});
    visit(Number{"heat", &Particles::heat, 0.0F, ColumnOf::InAir});
    visit(ParticleColumn<std::uint32_t>{"key", &Particles::key});
    visit(ParticleColumn<std::int32_t>{"birthStep", &Particles::birthStep, Particles::kUnborn});
}

} // namespace fumage
