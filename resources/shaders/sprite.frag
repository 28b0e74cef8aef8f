#version 330 core
// The profile, texture, erosion, shading and detail of core/rendering/tile_kernel.cpp.
uniform sampler2DArray noise; // one layer a slice, one mip level a resolution
uniform sampler3D billows; // value and slopes, as fumage::DetailTexture; its finest level is mip level 0
uniform sampler2D picture; // of the layer, premultiplied linear light, as fumage::SpritePicture
uniform bool hasDetail; // else what `detail` holds means nothing
uniform vec4 styles[3 * 64]; // of each layer the members of fumage::SpriteStyle

flat in vec4 rows;
flat in vec4 sun;
flat in vec3 around;
flat in uint look;
flat in uint layerOf;
flat in uvec4 detail[8];
in vec2 offset;

out vec4 colour; // premultiplied

const uint kPlain = 15u;

// The style of the sprite's layer; main() finds it.
bool square;
float hardness;
float textureAmount;
float erosionSoftness;
float textureScale;
vec2 light; // way of the light on the screen, y down
float relief;
float roundness;
float pictureReach; // 0: there is none

void findStyle()
{
    int first = 3 * int(layerOf);
    square = styles[first].x != 0.0;
    hardness = styles[first].y;
    textureAmount = styles[first].z;
    erosionSoftness = styles[first].w;
    textureScale = styles[first + 1].x;
    light = styles[first + 1].yz;
    relief = styles[first + 1].w;
    roundness = styles[first + 2].x;
    pictureReach = styles[first + 2].y;
}

float profile(vec2 place)
{
    if (square && (look >> 7u & 15u) != kPlain) {
        vec2 edges = vec2(inversesqrt(dot(rows.xy, rows.xy)), inversesqrt(dot(rows.zw, rows.zw))); // half of them, in pixels
        vec2 inside = clamp(edges * (1.0 - abs(place)) + 0.5, 0.0, 1.0);
        return inside.x * inside.y;
    }
    float inside = clamp(hardness * (1.0 - dot(place, place)), 0.0, 1.0);
    return inside * inside;
}

float texel(ivec2 at, int edge, int layer, int level)
{
    return texelFetch(noise, ivec3(at & (edge - 1), layer), level).r;
}

uint word(int index)
{
    return detail[index >> 2][index & 3];
}

float number(int index)
{
    return uintBitsToFloat(word(index));
}

vec3 way(int index)
{
    return vec3(number(index), number(index + 1), number(index + 2));
}

const int kPhaseWords = 12;
const int kCoarsest = 3; // mip level of it
const float kMostAlpha = 0.995;

uint byteOf(int which)
{
    return word(2 * kPhaseWords + 7) >> uint(8 * which) & 255u;
}

// The noise of one phase, and what its slope along the way of the light is worth.
vec2 phaseAt(int which)
{
    int first = which * kPhaseWords;
    int mip = kCoarsest - int(byteOf(which));
    int size = textureSize(billows, mip).x;
    vec3 at = way(first) + way(first + 3) * offset.x + way(first + 6) * offset.y;
    vec3 whole = floor(at);
    vec4 texel = texelFetch(billows, ivec3(whole) & (size - 1), mip);
    int light = int(word(first + 9));
    vec3 towards = vec3(light << 16 >> 24, light << 8 >> 24, light >> 24);
    float noiseHere = texel.r + dot(texel.gba, at - whole);
    return vec2(noiseHere * number(first + 11), dot(texel.gba, towards) * number(first + 10));
}

// As paintCoherent() in core/rendering/coherent_sprite-inl.h.
vec4 coherent(float mask, bool showsFirst, bool showsSecond)
{
    int rest = 2 * kPhaseWords;
    vec2 here = vec2(0.0);
    if (showsFirst) {
        here += phaseAt(0);
    }
    if (showsSecond) {
        here += phaseAt(1);
    }
    float gain = number(rest + 2);
    float bend = number(rest + 4);
    float size = abs(here.x);
    float beyond = max(0.0, size - number(rest + 3));
    float even = (size * gain - beyond * beyond * bend) * (here.x < 0.0 ? -1.0 : 1.0);
    float bent = even * number(rest) + 1.5;
    float low = clamp(bent, 0.0, 1.0);
    float factor = low * low * 0.5 + max(0.0, bent - 1.0);
    float a = min(mask * sun.a * number(rest + 1) * factor, kMostAlpha);
    float shade = max(0.0, (gain - 2.0 * beyond * bend) * here.y + 1.0);
    return vec4((sun.rgb * shade + around * max(0.0, 1.0 + even * number(rest + 6))) * a, a);
}

// As paintPictured() in core/rendering/pictured_sprite-inl.h.
vec4 pictured(vec2 place, float mask)
{
    int level = int(look >> 7u & 15u);
    ivec2 last = textureSize(picture, level) - 1;
    vec2 at = (place + 1.0) * pictureReach / float(1 << level) - 0.5;
    vec2 whole = floor(at);
    vec2 part = at - whole;
    ivec2 near = clamp(ivec2(whole), ivec2(0), last);
    ivec2 far = clamp(ivec2(whole) + 1, ivec2(0), last);
    vec4 above = mix(texelFetch(picture, near, level), texelFetch(picture, ivec2(far.x, near.y), level), part.x);
    vec4 below = mix(texelFetch(picture, ivec2(near.x, far.y), level), texelFetch(picture, far, level), part.x);
    vec4 here = mix(above, below, part.y) * mask * sun.a;
    return vec4((sun.rgb + around) * here.rgb, here.a);
}

void main()
{
    findStyle();
    mat2 turn = mat2(rows.x, rows.z, rows.y, rows.w); // columns
    vec2 place = turn * offset;
    float mask = profile(place);
    if (hasDetail) {
        bool showsFirst = byteOf(2) != 0u;
        bool showsSecond = byteOf(3) != 0u;
        if (showsFirst || showsSecond) {
            colour = coherent(mask, showsFirst, showsSecond);
            return;
        }
    }
    if (pictureReach > 0.0) {
        colour = pictured(place, mask);
        return;
    }
    uint level = look >> 7u & 15u;
    if (level == kPlain) {
        float a = sun.a * mask;
        colour = vec4((sun.rgb + around) * a, a);
        return;
    }
    int layer = int(look & 127u);
    int edge = textureSize(noise, int(level)).x;
    float texelsAcross = 0.5 * textureScale * float(edge);
    vec2 start = vec2(look >> 11u & 255u, look >> 19u & 255u) / 256.0 * float(edge) - 0.5;
    vec2 at = place * texelsAcross + start;
    vec2 whole = floor(at);
    vec2 part = at - whole;
    ivec2 base = ivec2(whole);
    float g00 = texel(base, edge, layer, int(level));
    float g10 = texel(base + ivec2(1, 0), edge, layer, int(level));
    float g01 = texel(base + ivec2(0, 1), edge, layer, int(level));
    float g11 = texel(base + ivec2(1, 1), edge, layer, int(level));
    float row0 = mix(g00, g10, part.x);
    float row1 = mix(g01, g11, part.x);
    float grey = mix(row0, row1, part.y);
    float erosion = float(look >> 27u) / 31.0;
    float kept = clamp((grey - erosion) / erosionSoftness, 0.0, 1.0);
    float a = mask * sun.a * (1.0 - textureAmount + textureAmount * kept);

    float scale = inversesqrt(abs(rows.x * rows.w - rows.y * rows.z));
    vec2 lightHere = turn * light * scale;
    vec2 slope = vec2(mix(g10 - g00, g11 - g01, part.y), row1 - row0) * texelsAcross;
    float shade = max(0.0, 1.0 + relief * dot(lightHere, slope) - roundness * dot(lightHere, place));
    colour = vec4((sun.rgb * shade + around) * a, a);
}
