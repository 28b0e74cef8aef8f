// Included once per SIMD target: the colour of particles in their light.

#if defined(FUMAGE_PARTICLE_LIGHT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_PARTICLE_LIGHT_INL_H
#undef FUMAGE_PARTICLE_LIGHT_INL_H
#else
#define FUMAGE_PARTICLE_LIGHT_INL_H
#endif

#include "core/lighting/glow-inl.h"
#include "core/lighting/grid_cell-inl.h"
#include "core/lighting/light_lookup-inl.h"
#include "core/lighting/particle_light.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

/// Where the particles of a block lie in the grid of their light, and what glows of them.
struct LitBlock {
    alignas(64) std::int32_t corner[kLitBlock];
    alignas(64) float fu[kLitBlock];
    alignas(64) float fv[kLitBlock];
    alignas(64) float fw[kLitBlock];
    alignas(64) float heat[kLitBlock]; ///< where particles glow
    alignas(64) float emission[kLitBlock]; ///< factor that makes up for opacity that flames lack; where particles glow

    /// What a grid has at particle i.
    /// @tparam Value float, or Float4 for four floats a cell
    template <class Value>
    [[nodiscard]] HWY_INLINE Value at(const GridShape& shape, const AlignedArray<float>& cells, std::size_t i) const
    {
        return trilinear<Value>(shape, cells.data(), corner[i], fu[i], fv[i], fw[i]);
    }
};

/// Finds place i of a block and those after it.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE void placeInLight(D d, const GridShape& shape, const Vec3<V>& position, std::size_t i, LitBlock& block)
{
    const GridCell<D> cell = gridCellAt(d, shape, position);
    hn::Store(cell.corner, hn::RebindToSigned<D>(), block.corner + i);
    store(cell.fraction, block.fu, block.fv, block.fw, i);
}

/// Finds what glows of place i of a block and those after it, which are particle `at` and those after it.
/// @param age s
template <class D, SimdVector VU, class V = hn::VFromD<D>>
HWY_INLINE void findGlow(D d, const ParticleLight& light, const Particles& particles, std::size_t at, VU key, V age,
    std::size_t i, LitBlock& block)
{
    const V heat = glowingHeat(d, light.glow, particles, at, key, age);
    hn::Store(heat, d, block.heat + i);
    hn::Store(1.0F / opaqueShare(d, light.glow, heat), d, block.emission + i);
}

/// Light of a particle by where it comes from, before its opacity.
struct LitColour {
    Float4 direct{}; ///< of the sun
    Float4 ambient{}; ///< of everything else
    float glow = 0.0F; ///< of itself, of which red has all that there is
};

HWY_INLINE LitColour litColourOf(
    const ParticleLight& job, const LightGrid& grid, const LitBlock& block, std::size_t i, float life)
{
    const Float4 light = block.at<Float4>(grid.shape, grid.light, i);
    const Float4 albedo = job.albedo[static_cast<std::size_t>(life * static_cast<float>(kColourTableSize - 1))];
    LitColour out;
    out.direct = albedo * job.sun * light[0];
    out.ambient = albedo * (job.sky * light[1] + job.ground * light[2]);
    if (job.isScattered) {
        const Float4 diffuse = block.at<Float4>(grid.shape, grid.diffuse, i);
        out.ambient += albedo * (job.sun * diffuse[0] + job.sky * diffuse[1] + job.ground * diffuse[2]);
    }
    if (job.isLitByFire) {
        out.ambient += albedo * job.fire * block.at<float>(grid.shape, grid.fire, i);
    }
    if (job.glows) {
        // Sky and ground together tell how open a place is.
        const float open = std::min(1.0F, light[1] + light[2]);
        const float heat = std::clamp(block.heat[i] * (1.0F - job.hotCore * open), 0.0F, 1.0F);
        const Float4 glow =
            job.emission[static_cast<std::size_t>(heat * static_cast<float>(kGlowTableSize - 1))] * block.emission[i];
        out.ambient += glow;
        out.glow = glow[0];
    }
    return out;
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
