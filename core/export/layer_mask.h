#pragma once

#include "core/base/aligned_array.h"

#include <string>

namespace fumage {

/// What a layer gives to the alpha of a sheet: how much of it is seen, the others hiding what they hide.
struct LayerMask {
    std::string layer; ///< as the scene has it; may be empty
    std::string target; ///< of an EXR: "mask_flames"
    RawArray<float> values; ///< width * height of the sheet, in [0, 1], rows from the top
};

} // namespace fumage
