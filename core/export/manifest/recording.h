#pragma once

#include <filesystem>

namespace fumage {

/// What is done about files beside writing them.
struct Recording {
    std::filesystem::path manifest; ///< that is written of them, see partOf(); empty: none
    bool skipExisting = false; ///< frames whose whole file is there stay as they are
};

} // namespace fumage
