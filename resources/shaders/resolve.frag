#version 330 core
// Backdrop, exposure, view transform and the sRGB curve, as core/rendering/view_transform.cpp.
uniform sampler2D smoke; // linear, premultiplied
uniform vec3 background;
uniform bool checker;
uniform float gain; // of the exposure
uniform float backdropGain; // what leaves the backdrop as it is
uniform bool filmic;
uniform float height; // of the target, pixels

out vec4 colour;

const float kCheckerPixels = 16.0;
const float kCheckerDark = 0.10;
const float kCheckerLight = 0.16;

vec3 behind()
{
    if (!checker) {
        return background;
    }
    vec2 cell = floor(vec2(gl_FragCoord.x, height - gl_FragCoord.y) / kCheckerPixels);
    return vec3(mod(cell.x + cell.y, 2.0) < 0.5 ? kCheckerDark : kCheckerLight);
}

void main()
{
    vec4 light = texelFetch(smoke, ivec2(gl_FragCoord.xy), 0);
    vec3 linear = (light.rgb + behind() * backdropGain * (1.0 - light.a)) * gain;
    if (filmic) {
        linear = clamp(linear * (2.51 * linear + 0.03) / (linear * (2.43 * linear + 0.59) + 0.14), 0.0, 1.0);
    }
    linear = clamp(linear, 0.0, 1.0);
    vec3 curve = 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055;
    colour = vec4(mix(12.92 * linear, curve, vec3(greaterThan(linear, vec3(0.0031308)))), 1.0);
}
