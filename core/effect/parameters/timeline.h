#pragma once

#include "core/effect/parameters/row.h"

namespace fumage {

template <>
inline constexpr Group<Timeline> kGroup<Timeline>{&Effect::timeline, "timeline", "Timeline", Scope::Scene};

template <>
inline constexpr std::array kRows<Timeline>{
    row<&Timeline::length>({
        .key = "timeline.length",
        .label = "Length",
        .synonyms = "duration frames end time long short",
        .hard = {1, 100000},
        .soft = {1, 600},
        .step = 1,
        .unit = Unit::Frames,
        .tip = "Frames from the first to the last; also the length of the loop.",
        .dirties = DirtyStage::Air,
        .varies = false,
    }),
    row<&Timeline::loop>({
        .key = "timeline.loop",
        .label = "Seamless loop",
        .synonyms = "loop seamless repeat cycle tile endless forever",
        .tip = "The frame after the last is the first again, to the bit.",
        .dirties = DirtyStage::Air,
        .varies = false,
        .essential = 10,
        .atExport = true,
    }),
    row<&Timeline::prewarm>({
        .key = "timeline.prewarm",
        .label = "Prewarm",
        .synonyms = "preroll pre-roll warmup start warm",
        .tip = "Frame 0 shows smoke that has been rising for a lifetime, instead of none.",
        .visible = when("timeline.loop", 0),
        .dirties = DirtyStage::Air,
        .varies = false,
    }),
    row<&Timeline::frameRate>({
        .key = "timeline.frame_rate",
        .label = "Frame rate",
        .synonyms = "fps speed fast slow playback",
        .hard = {1, 240},
        .soft = {12, 60},
        .step = 1,
        .unit = Unit::FramesPerSecond,
        .tip = "Frames a second.",
        .dirties = DirtyStage::Air,
        .varies = false,
        .live = Live::Fixed,
    }),
    row<&Timeline::timeScale>({
        .key = "timeline.time_scale",
        .since = 2,
        .label = "Time scale",
        .synonyms = "speed fast slow motion playback simulation faster slower tempo",
        .hard = {0.1, 4},
        .soft = {0.25, 4},
        .step = 0.05,
        .scale = Scale::Log,
        .tip = "Seconds of smoke in a second of film: 2 lets all of it happen twice as fast, 0.5 in slow motion. Key "
               "frames, start and length keep their frames.",
        .dirties = DirtyStage::Air,
        .varies = false,
        .live = Live::Fixed,
    }),
    row<&Timeline::stepsPerFrame>({
        .key = "timeline.steps_per_frame",
        .label = "Substeps",
        .synonyms = "substeps quality accuracy steps frame",
        .hard = {1, 32},
        .soft = {1, 8},
        .step = 1,
        .tip = "Steps of the simulation in a frame; more follow fast motion more closely.",
        .source = "2012 model, eq. IX and X (1 there)",
        .dirties = DirtyStage::Air,
        .varies = false,
        .live = Live::Fixed,
    }),
};

} // namespace fumage
