#pragma once

#include "core/base/result.h"

#include <string>
#include <string_view>

namespace fumage {

/// Frames in so many seconds, as a fraction: 24000/1001 is the 23.976 of film on television.
struct FrameRate {
    int frames = 30;
    int seconds = 1;

    [[nodiscard]] double perSecond() const { return static_cast<double>(frames) / seconds; }
    friend bool operator==(const FrameRate&, const FrameRate&) = default;
};

/// Most frames a second.
inline constexpr int kMaxVideoRate = 240;

/// Reads "24", "12.5", "24000/1001", and 23.976, 23.98, 29.97, 59.94 and their like as the 1001st parts that they stand
/// for.
/// @error Syntax; OutOfRange beyond 1 to kMaxVideoRate
[[nodiscard]] Result<FrameRate> parseFrameRate(std::string_view text);
/// What parseFrameRate() reads: "24" or "24000/1001".
[[nodiscard]] std::string textOf(const FrameRate& rate);

} // namespace fumage
