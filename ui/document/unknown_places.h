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

/// What was said of some layers, as of a preset that has them and nothing else.
/// @param layers places, each once; the first of them becomes layer 0
[[nodiscard]] std::vector<UnknownMember> unknownOf(const Preset& preset, const std::vector<std::size_t>& layers);

/// Keeps what a file says of layers, and is not known here, with those layers wherever they go in the list, by their
/// names and seeds. What was said of a layer that is gone is said of none, until that layer is back.
class UnknownPlaces {
public:
    explicit UnknownPlaces(const Preset& preset) { reset(preset); }

    /// The layers are where the preset says.
    void reset(const Preset& preset);
    /// Says more of layers of a preset, which are there; what has been said already is not said again.
    void add(Preset& preset, const std::vector<UnknownMember>& more);
    /// The preset has got other layers: what is unknown finds its own. O(unknown members x layers).
    /// @param before how many layers there were
    void follow(Preset& preset, std::size_t before);

private:
    /// Adds the mark of a member of the preset.
    void addMark(const Preset& preset, const UnknownMember& member);

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
