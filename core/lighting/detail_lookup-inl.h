// Included once per SIMD target: reads the noise that the air carries, at a place a lane.

#if defined(FUMAGE_DETAIL_LOOKUP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_DETAIL_LOOKUP_INL_H
#undef FUMAGE_DETAIL_LOOKUP_INL_H
#else
#define FUMAGE_DETAIL_LOOKUP_INL_H
#endif

#include "core/base/math-inl.h"
#include "core/flow/coordinate_map-inl.h"
#include "core/lighting/detail_field.h"
#include "core/noise/detail_texture-inl.h"

#include <array>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

/// How likely each octave is to be shown where the air has been deformed: finer ones go first, since they would be
/// drawn out to hair, and all go that are finer than what a picture can show.
/// @param at slopes of the coordinates @param finest m
template <class D, class V = hn::VFromD<D>>
HWY_INLINE std::array<V, DetailTexture::kLevels> octaveShares(
    D d, const DetailField& detail, const AdvectedPlaces<V>& at, V finest)
{
    constexpr float kDrawnOut = 0.05F; // how soon an octave goes: the first by 1/e where |J|^2 has grown 17-fold
    constexpr float kMinPixelsAWave = 2.0F; // twice as many show all of an octave
    const V grown = (dot(at.alongX, at.alongX) + dot(at.alongY, at.alongY) + dot(at.alongZ, at.alongZ)) * (1.0F / 3.0F);
    V kept = exponential(d, hn::Max(hn::Zero(d), grown - 1.0F) * -kDrawnOut);
    V pixelsAWave = hn::Div(hn::Set(d, detail.wave), hn::Sqrt(grown) * finest);
    std::array<V, DetailTexture::kLevels> out;
    for (V& share : out) {
        share = kept * smoothStep(clamp01(d, pixelsAWave * (1.0F / kMinPixelsAWave) - 1.0F));
        const V squared = kept * kept; // waves half as long: four times the exponent
        kept = squared * squared;
        pixelsAWave = pixelsAWave * 0.5F;
    }
    return out;
}

/// The value of a level at a place, -1 to 1.
/// @param tiles where
template <class D, class V = hn::VFromD<D>>
HWY_INLINE V noiseAt(D d, const DetailTexture& texture, int level, const Vec3<V>& tiles)
{
    return samplesAt(d, texture, level, tiles * static_cast<float>(DetailTexture::size(level))).value;
}

/// Where coarse noise that rides on the first phase lets it be shown, where one is to be shown: neighbours show the
/// same, in as many places as the square of its weight.
/// @param random 0 to 1: edges between the two are not sharp
template <class D, class V = hn::VFromD<D>>
HWY_INLINE hn::Mask<D> showsFirst(D d, const DetailField& detail, const AdvectedPlaces<V>& inFirst, V random)
{
    constexpr glm::vec3 kElsewhere{0.37F, 0.71F, 0.13F}; // tiles: not by what the phase itself shows there
    constexpr float kLoose = 0.1F;
    const float weight = (*detail.phases)[0].weight;
    // Noise goes a little beyond 0 and 1: one that is not looked at is nowhere, also there.
    constexpr float kNowhere = -1.0F;
    constexpr float kEverywhere = 2.0F;
    const float share = weight < kMinPhaseWeight       ? kNowhere
        : (*detail.phases)[1].weight < kMinPhaseWeight ? kEverywhere
                                                       : weight * weight;
    const Vec3<V> tiles = inFirst.place * detail.tilesPerMetre + (detail.shift[0] + kElsewhere);
    const V even = noiseAt(d, *detail.texture, 0, tiles) * 0.5F + 0.5F;
    return hn::Lt(even + (random - even) * kLoose, hn::Set(d, share));
}

/// Places in the phase that each shows, where each is to show one.
template <class D, class V = hn::VFromD<D>>
struct ChosenPlaces {
    AdvectedPlaces<V> at;
    hn::Mask<D> isFirst;
};
template <class D, class V = hn::VFromD<D>>
HWY_INLINE ChosenPlaces<D> chosenPlaces(D d, const DetailField& detail, const Vec3<V>& place, V random)
{
    const AdvectedPlaces<V> first = advectedPlaces(d, (*detail.phases)[0].map, place);
    const auto isFirst = showsFirst(d, detail, first, random);
    if (hn::AllTrue(d, isFirst)) {
        return {first, isFirst};
    }
    const AdvectedPlaces<V> second = advectedPlaces(d, (*detail.phases)[1].map, place);
    const auto chosen = [&](const Vec3<V>& a, const Vec3<V>& b) HWY_ATTR {
        return Vec3<V>{
            hn::IfThenElse(isFirst, a.x, b.x), hn::IfThenElse(isFirst, a.y, b.y), hn::IfThenElse(isFirst, a.z, b.z)};
    };
    return {{chosen(first.place, second.place), chosen(first.alongX, second.alongX),
                chosen(first.alongY, second.alongY), chosen(first.alongZ, second.alongZ)},
        isFirst};
}

/// All lanes in one phase.
template <class D>
HWY_INLINE hn::Mask<D> allIn(D d, std::size_t phase)
{
    return hn::FirstN(d, phase == 0 ? hn::Lanes(d) : 0);
}

/// A number of the phase that each lane shows.
template <class D>
HWY_INLINE hn::VFromD<D> ofChosen(D d, hn::Mask<D> isFirst, float first, float second)
{
    return hn::IfThenElse(isFirst, hn::Set(d, first), hn::Set(d, second));
}

/// The shift of the phase that each lane shows, tiles.
template <class D>
HWY_INLINE Vec3<hn::VFromD<D>> shiftOfChosen(D d, const DetailField& detail, hn::Mask<D> isFirst)
{
    const glm::vec3& first = detail.shift[0];
    const glm::vec3& second = detail.shift[1];
    return {ofChosen(d, isFirst, first.x, second.x), ofChosen(d, isFirst, first.y, second.y),
        ofChosen(d, isFirst, first.z, second.z)};
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
