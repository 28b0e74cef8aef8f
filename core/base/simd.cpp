#include "core/base/simd.h"

#include "core/base/joined.h"
#include "core/base/text.h"

#include <array>
#include <cstdint>

#include <hwy/highway.h>

namespace fumage {

namespace {

struct NamedTarget {
    std::string_view name;
    std::int64_t bit;
};

constexpr std::array kTargets{
    NamedTarget{"avx512", HWY_AVX3},
    NamedTarget{"avx2", HWY_AVX2},
    NamedTarget{"sse4", HWY_SSE4},
    NamedTarget{"ssse3", HWY_SSSE3},
    NamedTarget{"neon", HWY_NEON},
    NamedTarget{"baseline", HWY_EMU128 | HWY_SCALAR},
};

bool available(const NamedTarget& target)
{
    return (hwy::SupportedTargets() & HWY_TARGETS & target.bit) != 0;
}

} // namespace

std::vector<std::string> availableSimdTargets()
{
    std::vector<std::string> names;
    for (const NamedTarget& target : kTargets) {
        if (available(target)) {
            names.emplace_back(target.name);
        }
    }
    return names;
}

Status forceSimdTarget(std::string_view name)
{
    hwy::SetSupportedTargetsForTest(0);
    std::int64_t chosen = 0;
    for (const NamedTarget& target : kTargets) {
        if (target.name == name && available(target)) {
            chosen = hwy::SupportedTargets() & HWY_TARGETS & target.bit;
        }
    }
    if (chosen == 0 && !name.empty()) {
        return Error{ErrorCode::UnknownName, makeMessage("this machine has no instruction set %1", inQuotes(name)), {},
            makeMessage("Choose one of %1", joined(availableSimdTargets()))};
    }
    hwy::SetSupportedTargetsForTest(chosen);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    return Done{};
}

} // namespace fumage
