#pragma once

#include "core/effect/curve.h"
#include "core/effect/gradient.h"
#include "core/effect/bitmap.h"

#include <cstdint>

#include <glm/vec3.hpp>

namespace fumage {

enum class EmitterShape {
    Rectangle,
    Disc,
    Sphere,
    Picture
};
enum class EmissionMode {
    Continuous,
    Burst
};
enum class MaskShape {
    Disc,
    Square,
    Picture
};
enum class NoiseBasis {
    Lattice,
    Gradient,
    Simplex
};
enum class Interpolation {
    Linear,
    Cosine,
    Cubic,
    Quintic
};
enum class CameraMode {
    Orbit,
    Fixed
};
enum class ViewTransform {
    Standard,
    Filmic
};
enum class EmissionColour {
    Gradient,
    BlackBody
};
enum class Quality {
    Draft,
    Good,
    Final
};
enum class Background {
    Transparent,
    Colour
};
enum class Coupling {
    Carried,
    Dragged,
    Free
};
enum class Obstacle {
    None,
    Box,
    Sphere
};

// The structs below are the document: plain data in the units that an artist sees (metres, seconds, degrees, linear
// RGB), and the only place with defaults. What each member means, its range and its unit stand in parameters/.

struct Emitter {
    EmitterShape shape = EmitterShape::Disc;
    glm::vec3 position{0.0F, 0.0F, 0.0F};
    glm::vec3 normal{0.0F, 1.0F, 0.0F};
    float width = 0.6F;
    float depth = 0.6F;
    float radius = 0.25F;
    int count = 100000;
    float rate = 1.0F;
    EmissionMode mode = EmissionMode::Continuous;
    float burstDuration = 0.2F;
    float start = 0.0F;
    float length = 0.0F;
    float speed = 1.0F;
    float velocityRandomness = 0.05F;
    float spread = 8.0F;
    float inherit = 0.0F;
    float parentLifeFrom = 0.0F;
    float parentLifeTo = 1.0F;
    bool subframe = true;
    std::uint32_t seed = 1;
    Bitmap picture;
    friend bool operator==(const Emitter&, const Emitter&) = default;
};

/// Whether an emitter is a rectangle of its width and depth, be all of it or a picture on it what gives birth.
[[nodiscard]] inline bool isRectangular(const Emitter& emitter)
{
    return emitter.shape == EmitterShape::Rectangle || emitter.shape == EmitterShape::Picture;
}

/// Whether the bright pixels of a picture give birth: one that is dark throughout, or none, leaves all of the
/// rectangle.
[[nodiscard]] inline bool isOnPicture(const Emitter& emitter)
{
    return emitter.shape == EmitterShape::Picture && emitter.picture.isBright();
}

struct Motion {
    float gravity = 0.0F;
    float mass = 1.0F;
    float randomness = 0.0F;
    float drag = 0.8F;
    float buoyancy = 1.1F;
    float cooling = 0.25F;
    float heatVariance = 0.35F;
    float rotation = 0.0F;
    float rotationJitter = 0.0F;
    float pull = 0.05F;
    Coupling coupling = Coupling::Carried;
    float restitution = 0.4F;
    float friction = 0.3F;
    friend bool operator==(const Motion&, const Motion&) = default;
};

struct Wind {
    float strength = 0.15F;
    float angle = 0.0F;
    float gust = 0.5F;
    float gustRate = 0.4F;
    friend bool operator==(const Wind&, const Wind&) = default;
};

struct Air {
    bool enabled = false;
    int resolution = 64;
    bool fit = true;
    glm::vec3 size{3.0F, 6.0F, 3.0F};
    glm::vec3 offset{0.0F, 0.0F, 0.0F};
    float buoyancy = 1.1F;
    float cooling = 0.25F;
    float drag = 0.8F;
    float vorticity = 0.15F;
    float turbulence = 0.0F;
    float turbulenceScale = 0.8F;
    bool ground = true;
    float groundHeight = 0.0F;
    float friction = 0.02F;
    Obstacle obstacle = Obstacle::None;
    glm::vec3 obstaclePosition{0.0F, 2.0F, 0.0F};
    glm::vec3 obstacleSize{0.6F, 0.6F, 0.6F};
    friend bool operator==(const Air&, const Air&) = default;
};

struct Source {
    float raggedness = 0.35F;
    float unevenness = 0.4F;
    float expansion = 0.0F;
    float surge = 0.0F;
    float surgeRate = 1.0F;
    bool feeds = true;
    friend bool operator==(const Source&, const Source&) = default;
};

struct Turbulence {
    float strength = 0.65F;
    float scale = 0.8F;
    int octaves = 4;
    float roughness = 0.75F;
    float lacunarity = 2.0F;
    float evolution = 1.0F;
    float onset = 0.2F;
    float growth = 0.0F;
    float drift = 1.4F;
    float detail = 1.0F;
    friend bool operator==(const Turbulence&, const Turbulence&) = default;
};

struct Vortex {
    float strength = 0.0F;
    float radius = 0.5F;
    float widening = 0.0F;
    glm::vec3 axis{0.0F, 1.0F, 0.0F};
    friend bool operator==(const Vortex&, const Vortex&) = default;
};

struct Rings {
    float strength = 0.9F;
    float speed = 1.5F;
    float radius = 0.45F;
    float widening = 0.12F;
    float spacing = 0.9F;
    float followers = 0.6F;
    float variance = 0.6F;
    friend bool operator==(const Rings&, const Rings&) = default;
};

struct Life {
    float initialAlpha = 0.1F;
    float fadeRate = 0.028F;
    float lifetimeVariance = 0.35F;
    Curve alphaCurve{{0.0F, 0.0F}, {0.02F, 1.0F}, {1.0F, 1.0F}};
    Curve sizeCurve{{0.0F, 0.6F}, {1.0F, 1.0F}};
    friend bool operator==(const Life&, const Life&) = default;
};

struct Look {
    float size = 0.15F;
    float sizeVariance = 0.25F;
    float opacity = 1.6F;
    float dilution = 0.6F;
    float overlap = 4.0F;
    float groundFade = 0.0F;
    float deformation = 1.0F;
    float deformationTime = 0.5F;
    float deformationLimit = 2.0F;
    glm::vec3 colour{0.82F, 0.82F, 0.82F};
    Gradient colourGradient{{0.0F, glm::vec3(1.0F)}};
    MaskShape mask = MaskShape::Disc;
    float softness = 1.0F;
    float texture = 0.35F;
    float erosion = 0.0F;
    float erosionSoftness = 0.6F;
    float textureScale = 0.6F;
    float textureRate = 0.4F;
    float rotationVariance = 1.0F;
    float spin = 0.0F;
    float spinVariance = 20.0F;
    float roll = 0.0F;
    float stretch = 0.0F;
    float relief = 0.0F;
    float roundness = 0.0F;
    float heatOpacity = 0.0F;
    float detail = 0.0F;
    float detailSize = 0.6F;
    float detailLife = 0.33F;
    float detailRelief = 1.0F;
    float detailEdge = 0.2F;
    float detailShadow = 1.0F;
    Bitmap picture;
    friend bool operator==(const Look&, const Look&) = default;
};

/// Whether particles look like a picture; without one they are squares.
[[nodiscard]] inline bool showsPicture(const Look& look)
{
    return look.mask == MaskShape::Picture && !look.picture.empty();
}

struct Noise {
    NoiseBasis basis = NoiseBasis::Gradient;
    Interpolation interpolation = Interpolation::Quintic;
    float smooth = 0.0F;
    float wavelength = 0.5F;
    int octaves = 5;
    float persistence = 0.55F;
    float lacunarity = 2.0F;
    float sharpness = 1.6F;
    float coverage = 0.5F;
    float warp = 0.15F;
    int resolution = 64;
    int slices = 32;
    float depth = 4.0F;
    std::uint32_t seed = 7;
    friend bool operator==(const Noise&, const Noise&) = default;
};

struct Glow {
    float emission = 0.0F;
    float emissionCooling = 2.0F;
    float hotCore = 0.0F;
    float flameOpacity = 1.0F;
    float fireLight = 1.0F;
    EmissionColour emissionColour = EmissionColour::Gradient;
    float temperature = 1900.0F;
    Gradient emissionGradient{{0.0F, glm::vec3(0.0F)}, {0.15F, glm::vec3(0.0F)}, {0.35F, glm::vec3(0.2F, 0.015F, 0.0F)},
        {0.6F, glm::vec3(1.0F, 0.22F, 0.02F)}, {0.8F, glm::vec3(1.0F, 0.62F, 0.18F)},
        {1.0F, glm::vec3(1.0F, 0.85F, 0.55F)}};
    friend bool operator==(const Glow&, const Glow&) = default;
};

struct Light {
    glm::vec3 direction{-0.6F, -0.64F, -0.48F};
    glm::vec3 colour{1.0F, 0.96F, 0.9F};
    float intensity = 1.25F;
    float shadow = 1.5F;
    float anisotropy = 0.3F;
    float scattering = 0.45F;
    float multipleScattering = 0.0F;
    glm::vec3 sky{0.42F, 0.52F, 0.68F};
    glm::vec3 ground{0.20F, 0.18F, 0.16F};
    float ambient = 0.48F;
    float occlusion = 0.7F;
    int resolution = 64;
    friend bool operator==(const Light&, const Light&) = default;
};

struct Camera {
    CameraMode mode = CameraMode::Orbit;
    glm::vec3 target{0.44F, 2.81F, -0.14F};
    float distance = 8.46F;
    float yaw = 0.0F;
    float pitch = 4.0F;
    float turntable = 0.0F;
    glm::vec3 position{0.0F, 2.8F, 9.0F};
    glm::vec3 view{0.0F, 0.0F, -1.0F};
    float focalLength = 50.0F;
    friend bool operator==(const Camera&, const Camera&) = default;
};

struct Timeline {
    int frameRate = 30;
    int stepsPerFrame = 1;
    float timeScale = 1.0F;
    int length = 150;
    bool loop = false;
    bool prewarm = true;
    friend bool operator==(const Timeline&, const Timeline&) = default;
};

struct Output {
    int width = 512;
    int height = 512;
    Quality quality = Quality::Good;
    int supersample = 1;
    float exposure = 0.0F;
    ViewTransform viewTransform = ViewTransform::Standard;
    Background background = Background::Transparent;
    glm::vec3 backgroundColour{0.05F, 0.1F, 0.18F};
    friend bool operator==(const Output&, const Output&) = default;
};

/// Everything that decides what a picture looks like. A frame is a pure function of it and the frame number.
struct Effect {
    Emitter emitter;
    Source source;
    Motion motion;
    Wind wind;
    Air air;
    Turbulence turbulence;
    Vortex vortex;
    Rings rings;
    Life life;
    Look look;
    Noise noise;
    Glow glow;
    Light light;
    Camera camera;
    Timeline timeline;
    Output output;
    friend bool operator==(const Effect&, const Effect&) = default;
};

/// Most particles an effect may ask for; the state of that many takes 128 MiB.
inline constexpr int kMaxParticles = 4'000'000;

/// Most octaves of turbulence: the constants of a step have room for as many.
inline constexpr int kMaxTurbulenceOctaves = 8;

/// Fewest and most cells along the longest side of the air.
inline constexpr int kMinAirResolution = 16;
inline constexpr int kMaxAirResolution = 128;

/// Most slices of the noise: a sprite has 7 bits for the one that it shows.
inline constexpr int kMaxNoiseSlices = 128;

/// Most pixels along an edge of the noise tile that particles show; each halving of it is a level that a sprite has 4
/// bits for.
inline constexpr int kMaxNoiseResolution = 512;

/// The most that an axis of a particle grows, and the least part of it that it shrinks to.
inline constexpr float kMaxDeformation = 8.0F;

/// Most cells along an edge of the density grid: what lights it has room for a line of as many.
inline constexpr int kMaxLightResolution = 256;

/// Longest edge of a picture that an effect may ask for, pixels.
inline constexpr int kMaxOutputEdge = 8192;

/// Most times that a picture is rendered larger before it is averaged.
inline constexpr int kMaxSupersample = 4;

} // namespace fumage
