#version 330 core
// Backdrop, exposure, view transform and the sRGB curve, as encodeOver() in core/rendering/view_transform.cpp.
uniform sampler2D smoke; // linear, premultiplied
uniform vec3 background;
uniform bool checker;
uniform float gain; // of the exposure
uniform bool filmic;
uniform float height; // of the target, pixels

out vec4 colour;

const float kCheckerPixels = 16.0;
const float kCheckerDark = 0.10;
const float kCheckerLight = 0.16;
const float kHalfWhite = 12.0;
const float kWhitePoint = 96.0;
const float kLeastAlpha = 1e-6;
const float kLit = 1.0;
const float kBurning = 3.0;

vec3 behind()
{
    if (!checker) {
        return clamp(background, 0.0, 1.0);
    }
    vec2 cell = floor(vec2(gl_FragCoord.x, height - gl_FragCoord.y) / kCheckerPixels);
    return vec3(mod(cell.x + cell.y, 2.0) < 0.5 ? kCheckerDark : kCheckerLight);
}

float brightest(vec3 light)
{
    return max(max(light.r, light.g), light.b);
}

vec3 shown(vec3 light)
{
    if (!filmic) {
        return clamp(light, 0.0, 1.0);
    }
    float most = max(brightest(light), 1e-20);
    float bounded = min(most, kWhitePoint);
    float curved = clamp(bounded * (2.51 * bounded + 0.03) / (bounded * (2.43 * bounded + 0.59) + 0.14), 0.0, 1.0);
    float power = pow(bounded / kHalfWhite, 4.0);
    float powerAtWhite = pow(kWhitePoint / kHalfWhite, 4.0);
    float white = clamp(power * (1.0 + power / (powerAtWhite * powerAtWhite)) / (1.0 + power), 0.0, 1.0);
    return clamp(curved * mix(light / most, vec3(1.0), white), 0.0, 1.0);
}

void main()
{
    vec4 here = texelFetch(smoke, ivec2(gl_FragCoord.xy), 0);
    vec3 light = here.rgb * gain;
    float alpha = clamp(here.a, 0.0, 1.0);
    float thick = max(alpha, kLeastAlpha);
    vec3 glow = shown(light);
    float most = brightest(glow);
    vec3 covered = filmic ? shown(light / thick) * alpha : min(glow, alpha);
    float uncovered = clamp((most - alpha) / max(most, kLeastAlpha) * 4.0, 0.0, 1.0);
    float share = uncovered * smoothstep(kLit, kBurning, brightest(light) / thick);
    float through = 1.0 - (alpha + share * max(0.0, most - alpha));
    vec3 linear = clamp(mix(covered, glow, share) + behind() * through, 0.0, 1.0);
    vec3 curve = 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055;
    colour = vec4(mix(12.92 * linear, curve, vec3(greaterThan(linear, vec3(0.0031308)))), 1.0);
}
