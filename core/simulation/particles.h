#pragma once

#include "core/base/aligned_array.h"

#include <cstdint>
#include <limits>
#include <string_view>

namespace fumage {

/// The state of every particle at one step: a structure of arrays, one slot a particle, slot = birth index modulo
/// capacity. Arrays are padded to whole chunks; slots that are not alive hold zeros and kUnborn.
struct Particles {
    static constexpr std::int32_t kUnborn = std::numeric_limits<std::int32_t>::max();

    /// Slots that are stepped together: their arrays stay in the first-level cache.
    static constexpr std::size_t kChunk = 1024;

    // A new column needs its line in forEachColumn().
    AlignedArray<float> x, y, z; ///< position, m
    AlignedArray<float> vx, vy, vz; ///< velocity without the turbulence that carries the particle, m/s
    AlignedArray<float> rollX, rollY,
        rollZ; ///< how far the swirls have turned the particle, a rotation vector in radians; empty where nobody asks
    AlignedArray<float> relativeX, relativeY,
        relativeZ; ///< velocity against the air, m/s; empty where no air carries them
    AlignedArray<float> heat; ///< of the air at the particle, 1 at the source; empty where no air carries them
    AlignedArray<float> shapeXX, shapeYY, shapeZZ, shapeXY, shapeXZ,
        shapeYZ; ///< squares of its axes, a symmetric tensor, 1 at birth; empty where nobody asks
    AlignedArray<std::uint32_t> key; ///< random bits of the particle, see keyOf()
    AlignedArray<std::int32_t> birthStep; ///< kUnborn where the slot is empty
    std::size_t capacity = 0; ///< slots in use at most

    /// Which columns there are besides those that all have.
    struct Columns {
        bool rolls = false; ///< rollX to rollZ
        bool inAir = false; ///< relativeX to heat
        bool deforms = false; ///< shapeXX to shapeYZ
        friend bool operator==(const Columns&, const Columns&) = default;
    };

    /// Makes room and empties every slot.
    void reset(std::size_t slotCount, const Columns& columns);
    void reset(std::size_t slotCount) { reset(slotCount, {}); }

    /// Adds columns that are missing, empty, and lets go of those that nobody needs; what all others hold stays.
    void setColumns(const Columns& columns);

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
    /// Whether the air deforms them.
    [[nodiscard]] bool deforms() const { return !shapeXX.empty(); }
    [[nodiscard]] Columns columns() const { return {rolls(), inAir(), deforms()}; }

    /// Memory of all columns.
    [[nodiscard]] std::size_t bytes() const;
};

/// Who has a column; where nobody asks for it, it has no slots.
enum class ColumnOf {
    All,
    Rolling,
    InAir,
    Deforming
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
    visit(Number{"shapeXX", &Particles::shapeXX, 1.0F, ColumnOf::Deforming});
    visit(Number{"shapeYY", &Particles::shapeYY, 1.0F, ColumnOf::Deforming});
    visit(Number{"shapeZZ", &Particles::shapeZZ, 1.0F, ColumnOf::Deforming});
    visit(Number{"shapeXY", &Particles::shapeXY, 0.0F, ColumnOf::Deforming});
    visit(Number{"shapeXZ", &Particles::shapeXZ, 0.0F, ColumnOf::Deforming});
    visit(Number{"shapeYZ", &Particles::shapeYZ, 0.0F, ColumnOf::Deforming});
    visit(ParticleColumn<std::uint32_t>{"key", &Particles::key});
    visit(ParticleColumn<std::int32_t>{"birthStep", &Particles::birthStep, Particles::kUnborn});
}

} // namespace fumage
