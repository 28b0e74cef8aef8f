// Included once per SIMD target: one vector of space a lane, as three vectors of lanes.

#if defined(FUMAGE_VECTOR_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_VECTOR_INL_H
#undef FUMAGE_VECTOR_INL_H
#else
#define FUMAGE_VECTOR_INL_H
#endif

#include "core/base/lanes-inl.h"

#include <cstddef>

#include <glm/vec3.hpp>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

template <SimdVector V>
struct Vec3 {
    V x, y, z;
};

/// The same vector in every lane.
template <class D>
HWY_INLINE Vec3<hn::VFromD<D>> broadcast(D d, const glm::vec3& v)
{
    return {hn::Set(d, v.x), hn::Set(d, v.y), hn::Set(d, v.z)};
}

/// Three equal components.
template <SimdVector V>
HWY_INLINE Vec3<V> uniform(V v)
{
    return {v, v, v};
}

/// Element i and those after it of three columns, which are arrays or pointers aligned for the instruction set.
template <class D, class Column>
HWY_INLINE Vec3<hn::VFromD<D>> load(D d, const Column& x, const Column& y, const Column& z, std::size_t i)
{
    return {hn::Load(d, &x[i]), hn::Load(d, &y[i]), hn::Load(d, &z[i])};
}

template <SimdVector V, class Column>
HWY_INLINE void store(const Vec3<V>& v, Column& x, Column& y, Column& z, std::size_t i)
{
    const hn::DFromV<V> d;
    hn::Store(v.x, d, &x[i]);
    hn::Store(v.y, d, &y[i]);
    hn::Store(v.z, d, &z[i]);
}

template <SimdVector V>
HWY_INLINE Vec3<V> operator+(const Vec3<V>& a, const Vec3<V>& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <SimdVector V>
HWY_INLINE Vec3<V> operator-(const Vec3<V>& a, const Vec3<V>& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

/// Component by component, as GLM has it.
template <SimdVector V>
HWY_INLINE Vec3<V> operator*(const Vec3<V>& a, const Vec3<V>& b)
{
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}

template <SimdVector V>
HWY_INLINE Vec3<V> operator*(const Vec3<V>& a, V b)
{
    return {a.x * b, a.y * b, a.z * b};
}

template <SimdVector V>
HWY_INLINE Vec3<V> operator*(V a, const Vec3<V>& b)
{
    return {a * b.x, a * b.y, a * b.z};
}

template <SimdVector V>
HWY_INLINE Vec3<V> operator*(const Vec3<V>& a, float b)
{
    return a * everyLane<V>(b);
}

// With a vector that is the same in every lane.

template <SimdVector V>
HWY_INLINE Vec3<V> operator+(const Vec3<V>& a, const glm::vec3& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <SimdVector V>
HWY_INLINE Vec3<V> operator-(const Vec3<V>& a, const glm::vec3& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <SimdVector V>
HWY_INLINE Vec3<V> operator*(const Vec3<V>& a, const glm::vec3& b)
{
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}

template <SimdVector V>
HWY_INLINE Vec3<V> operator*(V a, const glm::vec3& b)
{
    return {a * b.x, a * b.y, a * b.z};
}

/// ax bx + ay by + az bz, summed in this order.
template <SimdVector V>
HWY_INLINE V dot(const Vec3<V>& a, const Vec3<V>& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <SimdVector V>
HWY_INLINE V dot(const Vec3<V>& a, const glm::vec3& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <SimdVector V>
HWY_INLINE Vec3<V> cross(const Vec3<V>& a, const Vec3<V>& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
