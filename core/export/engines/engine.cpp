#include "core/export/engines/engine.h"

namespace fumage {

namespace {

struct Names {
    std::string_view name;
    std::string_view title;
};

constexpr std::array<Names, kEngines> kNames{{
    {"generic", ""},
    {"unity", "Unity"},
    {"unreal", "Unreal Engine"},
    {"godot", "Godot 4"},
    {"godot3", "Godot 3"},
    {"effekseer", "Effekseer"},
    {"pixi", "PixiJS, Phaser"},
    {"defold", "Defold"},
    {"web", "HTML, WebGL"},
}};

} // namespace

std::string_view nameOf(Engine engine)
{
    return kNames[static_cast<std::size_t>(engine)].name;
}

std::string_view titleOf(Engine engine)
{
    return kNames[static_cast<std::size_t>(engine)].title;
}

PassSet passesFor(Engine engine)
{
    switch (engine) {
    case Engine::Unity:
    case Engine::Unreal: return {Pass::Colour, Pass::SixWayA, Pass::SixWayB, Pass::Motion};
    case Engine::Godot:
    case Engine::Godot3:
    case Engine::Web: return {Pass::Colour, Pass::Motion};
    case Engine::Generic:
    case Engine::Effekseer:
    case Engine::Pixi:
    case Engine::Defold: break;
    }
    return {Pass::Colour};
}

BlendSpace blendSpaceOf(Engine engine)
{
    const bool isLinear = engine == Engine::Unity || engine == Engine::Unreal || engine == Engine::Godot;
    return isLinear ? BlendSpace::Linear : BlendSpace::Encoded;
}

bool blendsStraight(Engine engine)
{
    return engine == Engine::Effekseer; // its Blend; there are Add, Subtract and Multiply beside it
}

PassStyle styleFor(Engine engine, ImageFormat format)
{
    PassStyle style;
    if (engine == Engine::Unreal) {
        style.layout = SixWayLayout::EmberGen;
        style.vectors = VectorSigns::Unreal;
        style.normals = NormalGreen::DirectX;
    }
    style.premultiplied = holdsFloats(format);
    return style;
}

} // namespace fumage
