#pragma once

#include "core/effect/parameters/row.h"

/// Rows of the look that say what shape particles have.
namespace fumage {

inline constexpr std::array<std::string_view, 3> kMaskShapes{"disc", "square", "picture"};

template <>
inline constexpr Group<Look> kGroup<Look>{&Effect::look, "look", "Look", Scope::Layer};

inline constexpr Parameter kMaskRow = row<&Look::mask>({
    .key = "look.mask",
    .label = "Particle shape",
    .synonyms = "shape sprite square round mask picture image leaf debris",
    .tip = "A soft round puff, the bare square of the 2012 model, or a picture.",
    .choices = kMaskShapes,
    .dirties = DirtyStage::Shade,
    .animates = Animates::Frame,
});

inline constexpr Parameter kPictureRow = row<&Look::picture>({
    .key = "look.picture",
    .since = 2,
    .label = "Picture",
    .synonyms = "image leaf leaves debris sprite texture map flake petal feather png file",
    .tip = "A PNG that particles look like, as leaves or debris: its alpha is their shape, its colours are "
           "multiplied with that of the smoke. It turns and stretches with them, its longer edge as wide as they "
           "are; noise, erosion, relief, roundness and detail do not show in it. Without one they are squares.",
    .visible = when("look.mask", MaskShape::Picture),
    .dirties = DirtyStage::Shade,
    .varies = false,
});

} // namespace fumage
