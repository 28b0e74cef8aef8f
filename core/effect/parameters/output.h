#pragma once

#include "core/effect/parameters/row.h"

namespace fumage {

inline constexpr std::array<std::string_view, 3> kQualities{"draft", "good", "final"};
inline constexpr std::array<std::string_view, 2> kViewTransforms{"standard", "filmic"};
inline constexpr std::array<std::string_view, 2> kBackgrounds{"transparent", "colour"};

template <>
inline constexpr Group<Output> kGroup<Output>{&Effect::output, "output", "Output", Scope::Scene};

template <>
inline constexpr std::array kRows<Output>{
    row<&Output::width>({
        .key = "output.width",
        .label = "Width",
        .synonyms = "resolution size pixels wide",
        .hard = {1, kMaxOutputEdge},
        .soft = {64, 2048},
        .step = 1,
        .unit = Unit::Pixels,
        .tip = "Width of a frame.",
        .dirties = DirtyStage::Shade,
        .varies = false,
        .atExport = true,
    }),
    row<&Output::height>({
        .key = "output.height",
        .label = "Height",
        .synonyms = "resolution size pixels tall high",
        .hard = {1, kMaxOutputEdge},
        .soft = {64, 2048},
        .step = 1,
        .unit = Unit::Pixels,
        .tip = "Height of a frame.",
        .dirties = DirtyStage::Shade,
        .varies = false,
        .atExport = true,
    }),
    row<&Output::quality>({
        .key = "output.quality",
        .label = "Quality",
        .synonyms = "draft final preview particles",
        .tip = "Draft: a quarter of the particles. Final: eight times as many. The smoke keeps its form and density.",
        .choices = kQualities,
        .varies = false,
        .atExport = true,
    }),
    row<&Output::supersample>({
        .key = "output.supersample",
        .label = "Supersampling",
        .synonyms = "antialias anti-aliasing smooth aa",
        .hard = {1, kMaxSupersample},
        .step = 1,
        .tip = "Renders this many times larger and averages.",
        .dirties = DirtyStage::Shade,
        .varies = false,
        .atExport = true,
    }),
    row<&Output::exposure>({
        .key = "output.exposure",
        .label = "Exposure",
        .synonyms = "bright dark brightness gamma light dim flash",
        .hard = {-20, 20},
        .soft = {-4, 4},
        .step = 0.05,
        .unit = Unit::Stops,
        .tip = "Brightness in stops; one more doubles it. Not applied to EXR, which is linear.",
        .dirties = DirtyStage::Shade,
        .animates = Animates::Frame,
        .varies = false,
    }),
    row<&Output::viewTransform>({
        .key = "output.view_transform",
        .label = "View transform",
        .synonyms = "tone mapping filmic color management gamma",
        .tip = "Standard is plain sRGB; filmic rolls bright light off softly.",
        .choices = kViewTransforms,
        .dirties = DirtyStage::Shade,
        .animates = Animates::Frame,
        .varies = false,
    }),
    row<&Output::background>({
        .key = "output.background",
        .label = "Background",
        .synonyms = "transparent alpha backdrop",
        .tip = "Keep transparency, or put a colour behind the smoke.",
        .choices = kBackgrounds,
        .dirties = DirtyStage::Shade,
        .animates = Animates::Frame,
        .varies = false,
        .atExport = true,
    }),
    row<&Output::backgroundColour>({
        .key = "output.background_colour",
        .label = "Background colour",
        .synonyms = "color backdrop behind",
        .kind = Kind::Colour,
        .hard = kColours,
        .soft = kUnit,
        .step = 0.01,
        .tip = "The colour behind the smoke.",
        .visible = when("output.background", Background::Colour),
        .dirties = DirtyStage::Shade,
        .animates = Animates::Frame,
        .varies = false,
        .atExport = true,
    }),
};

} // namespace fumage
