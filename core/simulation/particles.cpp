#include "core/simulation/particles.h"

#include <algorithm>

namespace fumage {

namespace {

constexpr std::size_t columnCount()
{
    std::size_t count = 0;
    forEachColumn([&](const auto& /*column*/) { ++count; });
    return count;
}
static_assert(sizeof(Particles) == columnCount() * sizeof(AlignedArray<float>) + sizeof(std::size_t),
    "a member of Particles has no line in forEachColumn()");

template <class T>
void fillSlots(AlignedArray<T>& values, std::size_t first, std::size_t last, T value)
{
    if (!values.empty()) {
        std::fill(values.data() + first, values.data() + last, value);
    }
}

bool hasColumnsOf(ColumnOf owner, const Particles::Columns& columns)
{
    switch (owner) {
    case ColumnOf::Rolling: return columns.rolls;
    case ColumnOf::InAir: return columns.inAir;
    case ColumnOf::Deforming: return columns.deforms;
    case ColumnOf::All: break;
    }
    return true;
}

} // namespace

void Particles::reset(std::size_t slotCount, const Columns& columns)
{
    capacity = slotCount;
    const std::size_t padded = roundUp(slotCount, kChunk);
    forEachColumn([&](const auto& column) {
        column.of(*this).assign(hasColumnsOf(column.owner, columns) ? padded : 0, column.empty);
    });
}

void Particles::setColumns(const Columns& wanted)
{
    const std::size_t padded = x.size();
    forEachColumn([&](const auto& column) {
        auto& values = column.of(*this);
        const std::size_t size = hasColumnsOf(column.owner, wanted) ? padded : 0;
        if (values.size() != size) {
            values.assign(size, column.empty);
        }
    });
}

void Particles::clear(std::size_t first, std::size_t last)
{
    forEachColumn([&](const auto& column) { fillSlots(column.of(*this), first, last, column.empty); });
}

void Particles::clearRoll(std::size_t first, std::size_t last)
{
    forEachColumn([&](const auto& column) {
        if (column.owner == ColumnOf::Rolling) {
            fillSlots(column.of(*this), first, last, column.empty);
        }
    });
}

void Particles::copySlots(const Particles& from, std::size_t first, std::size_t last)
{
    forEachColumn([&](const auto& column) {
        const auto& values = column.of(from);
        if (!values.empty()) {
            std::copy_n(values.data() + first, last - first, column.of(*this).data() + first);
        }
    });
}

std::size_t Particles::bytes() const
{
    std::size_t sum = 0;
    forEachColumn([&](const auto& column) { sum += column.of(*this).size() * sizeof(column.empty); });
    return sum;
}

} // namespace fumage
