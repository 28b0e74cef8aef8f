#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/lighting/detail_kernel.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "core/lighting/detail_kernel.h"
#include "core/lighting/detail_lookup-inl.h"
#include "core/lighting/phase_blend-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;

/// The noise of a phase as it is on average over a cell.
/// @param isFirst which phase each lane is in
HWY_INLINE V meanOverCell(const DetailField& detail, const AdvectedPlaces<V>& at, hn::Mask<D> isFirst, float cell)
{
    const D d;
    const auto shares = octaveShares(d, detail, at, hn::Set(d, cell));
    const Vec3<V> tiles = at.place * detail.tilesPerMetre + shiftOfChosen(d, detail, isFirst);
    V sum = hn::Zero(d);
    for (std::size_t level = 0; level < shares.size(); ++level) {
        if (hn::AllFalse(d, hn::Gt(shares[level], hn::Zero(d)))) {
            break; // nor is any finer one shown
        }
        const V finer = level + 1 < shares.size() ? shares[level + 1] : hn::Zero(d);
        const V noise = noiseAt(d, *detail.texture, static_cast<int>(level), tiles);
        sum = sum + (shares[level] - finer) * noise;
    }
    return sum;
}

HWY_INLINE V meanAt(const DetailField& detail, const Vec3<V>& place, float cell)
{
    const D d;
    if (detail.mix == PhaseMix::Choose) {
        const ChosenPlaces<D> chosen = chosenPlaces(d, detail, place, hn::Set(d, 0.5F));
        return meanOverCell(detail, chosen.at, chosen.isFirst, cell);
    }
    const std::array<AdvectedPhase, 2>& phases = *detail.phases;
    V sum = hn::Zero(d);
    for (std::size_t i = 0; i < phases.size(); ++i) {
        if (phases[i].weight >= kMinPhaseWeight) {
            const AdvectedPlaces<V> at = advectedPlaces(d, phases[i].map, place);
            sum = sum + phases[i].weight * meanOverCell(detail, at, allIn(d, i), cell);
        }
    }
    return evened(PhaseBlend(phases[0].weight, phases[1].weight), sum).value;
}

void putIntoLine(const DetailField& detail, float amount, int v, int w, LightGrid& grid)
{
    const D d;
    const GridShape& shape = grid.shape;
    const auto nu = static_cast<std::size_t>(shape.nu);
    float* HWY_RESTRICT line = grid.density.data()
        + (static_cast<std::size_t>(w) * static_cast<std::size_t>(shape.nv) + static_cast<std::size_t>(v)) * nu;
    const float mean = amount <= 1.0F ? 1.0F : (1.0F + amount) * (1.0F + amount) / (4.0F * amount); // t being even
    const glm::vec3 start = shape.origin + shape.cell * glm::vec3(0, v, w);
    const glm::vec3 first = start.x * shape.axes.u + start.y * shape.axes.v + start.z * shape.axes.w;
    const glm::vec3 step = shape.cell * shape.axes.u;
    for (std::size_t i = 0; i < nu; i += hn::Lanes(d)) {
        const V density = hn::LoadU(d, line + i);
        if (hn::AllFalse(d, hn::Gt(density, hn::Zero(d)))) {
            continue;
        }
        const V along = hn::Iota(d, static_cast<float>(i));
        const Vec3<V> place = along * broadcast(d, step) + first;
        const V factor = hn::Max(hn::Zero(d), meanAt(detail, place, shape.cell) * amount + 1.0F) * (1.0F / mean);
        // The next line belongs to another task.
        HWY_ALIGN float out[hn::MaxLanes(d)];
        hn::Store(density * factor, d, out);
        std::copy_n(out, std::min(hn::Lanes(d), nu - i), line + i);
    }
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
HWY_BEFORE_NAMESPACE();
namespace fumage {

HWY_EXPORT(putIntoLine);

void putDetailIntoLine(const DetailField& detail, float amount, int v, int w, LightGrid& grid)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(putIntoLine);
    kernel(detail, amount, v, w, grid);
}

float PhaseBlend::operator()(float sum) const
{
    namespace hn = hwy::HWY_NAMESPACE;
    return hn::GetLane(HWY_NAMESPACE::evened(*this, hn::Set(hn::CappedTag<float, 1>(), sum)).value);
}

std::array<float, DetailTexture::kLevels> octaveSharesAt(
    const DetailField& detail, const AdvectedPlace& at, float finest)
{
    namespace hn = hwy::HWY_NAMESPACE;
    const hn::CappedTag<float, 1> d;
    const auto vectors = [&](const glm::vec3& v) { return HWY_NAMESPACE::broadcast(d, v); };
    const HWY_NAMESPACE::AdvectedPlaces<hn::VFromD<decltype(d)>> lanes{
        vectors(at.place), vectors(at.slope[0]), vectors(at.slope[1]), vectors(at.slope[2])};
    const auto shares = HWY_NAMESPACE::octaveShares(d, detail, lanes, hn::Set(d, finest));
    std::array<float, DetailTexture::kLevels> out{};
    std::transform(shares.begin(), shares.end(), out.begin(), [](auto share) { return hn::GetLane(share); });
    return out;
}

} // namespace fumage
HWY_AFTER_NAMESPACE();
#endif
