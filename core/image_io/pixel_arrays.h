#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace fumage {

/// Most pixels of a picture that is read, and most numbers of all its channels.
inline constexpr std::size_t kMaxReadPixels = std::size_t{1} << 26U;
inline constexpr std::size_t kMaxReadNumbers = std::size_t{1} << 28U;

/// Straight RGBA of 16 bits, rows from the top: what 8 bits say times 257, grey in all three colours, and without alpha
/// 65535.
struct RgbaPixels {
    int width = 0;
    int height = 0;
    std::vector<std::uint16_t> values;
};

/// The numbers of an EXR, rows from the top.
struct ExrNumbers {
    struct Channel {
        std::string name; ///< with that of its target, as in "motion.X"
        std::vector<float> values;
    };
    int width = 0;
    int height = 0;
    std::vector<Channel> channels; ///< by name
};

} // namespace fumage
