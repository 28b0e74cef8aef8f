#pragma once

#include "core/preset/preset.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace fumage::ui {

/// Whether what is unknown was said of a layer, and not of what all layers share.
[[nodiscard]] bool isOfLayer(const UnknownMember& member);

/// Keeps what a file says of layers, and is not known here, with those layers wherever they go in the list, by their
/// names and seeds. What was said of a layer that is gone is said of none, until that layer is back.
class UnknownPlaces {
public:
    explicit UnknownPlaces(const Preset& preset) { reset(preset); }

    /// The layers are where the preset says.
    void reset(const Preset& preset);
    /// The preset has got other layers: what is unknown finds its own. O(unknown members x layers).
    /// @param before how many layers there were
    void follow(Preset& preset, std::size_t before);

private:
    /// What a layer is known by.
    struct Mark {
        std::string name;
        std::uint32_t seed = 0;
        std::size_t place = 0;
        bool isThere = true;
    };
    std::vector<std::optional<Mark>> m_marks; ///< one for each unknown member; nothing: it is of no layer
};

} // namespace fumage::ui
