#include "core/export/video/frame_rate.h"

#include "core/base/text.h"

#include <cmath>
#include <numeric>
#include <optional>

namespace fumage {

namespace {

constexpr int kThousand = 1000;
constexpr int kOfTelevision = 1001; ///< seconds in which television shows the frames of a thousand

/// A decimal number as a fraction: what is a thousandth less than a whole one is that of television.
std::optional<FrameRate> fractionOf(float number)
{
    if (!(number >= 1.0F) || !(number <= static_cast<float>(kMaxVideoRate))) {
        return std::nullopt;
    }
    const auto wanted = static_cast<double>(number);
    const auto above = static_cast<int>(std::ceil(wanted));
    constexpr double kWritten = 0.005; // half of a digit of 23.98
    const double television = static_cast<double>(above) * kThousand / kOfTelevision;
    if (wanted < above && std::abs(wanted - television) < kWritten) {
        return FrameRate{above * kThousand, kOfTelevision};
    }
    const auto thousandths = static_cast<int>(std::lround(wanted * kThousand));
    const int common = std::gcd(thousandths, kThousand);
    return FrameRate{thousandths / common, kThousand / common};
}

} // namespace

Result<FrameRate> parseFrameRate(std::string_view text)
{
    const Error malformed{ErrorCode::Syntax, makeMessage("the frame rate %1 is not understood", inQuotes(text)), {},
        makeMessage("Write 24, 23.976 or 24000/1001, from 1 to %1 frames a second", kMaxVideoRate)};
    const std::size_t slash = text.find('/');
    if (slash == std::string_view::npos) {
        const std::optional<float> number = parseFloat(trimmed(text));
        const std::optional<FrameRate> rate = number ? fractionOf(*number) : std::nullopt;
        return rate ? Result<FrameRate>(*rate) : malformed;
    }
    const std::optional<std::int64_t> frames = parseInteger(trimmed(text.substr(0, slash)));
    const std::optional<std::int64_t> seconds = parseInteger(trimmed(text.substr(slash + 1)));
    constexpr std::int64_t kMaxSeconds = 1'000'000;
    if (!frames || !seconds || *seconds < 1 || *seconds > kMaxSeconds || *frames < *seconds
        || *frames > *seconds * kMaxVideoRate) {
        return malformed;
    }
    return FrameRate{static_cast<int>(*frames), static_cast<int>(*seconds)};
}

std::string textOf(const FrameRate& rate)
{
    return std::to_string(rate.frames) + (rate.seconds == 1 ? std::string() : "/" + std::to_string(rate.seconds));
}

} // namespace fumage
