#pragma once

#include "core/effect/effect.h"
#include "core/rendering/image.h"

#include <QString>

namespace fumage::tests {

/// How far apart two pictures are, in steps of 8 bits, over black.
struct PictureDifference {
    int largest = 0;
    double mean = 0.0;
};

/// Writes what a test saw and, where there is a reference of the same size, its difference from that, eight times as
/// strong:
///   folder/name.png, folder/name.expected.png, folder/name.difference.png
/// @return a sentence with figures and paths, for the one who reads that the test has failed
[[nodiscard]] QString showDifference(
    const Image& seen, const Output& output, const QString& reference, const QString& folder, const QString& name);

/// Writes a reference picture unless it is there already with the same pixels.
[[nodiscard]] bool writeReference(const Image& image, const Output& output, const QString& path);

} // namespace fumage::tests
