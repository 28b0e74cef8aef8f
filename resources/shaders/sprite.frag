#version 330 core
// The profile, texture, erosion and shading of core/rendering/tile_kernel.cpp.
uniform sampler2DArray noise; // one layer a slice, one mip level a resolution
uniform bool square;
uniform float hardness;
uniform float textureAmount;
uniform float erosionSoftness;
uniform float textureScale;
uniform vec2 light; // way of the light on the screen, y down
uniform float relief;
uniform float roundness;

flat in vec4 rows;
flat in vec4 sun;
flat in vec3 around;
flat in uint look;
in vec2 offset;

out vec4 colour; // premultiplied

const uint kPlain = 15u;

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

void main()
{
    mat2 turn = mat2(rows.x, rows.z, rows.y, rows.w); // columns
    vec2 place = turn * offset;
    float mask = profile(place);
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
    vec2 way = turn * light * scale;
    vec2 slope = vec2(mix(g10 - g00, g11 - g01, part.y), row1 - row0) * texelsAcross;
    float shade = max(0.0, 1.0 + relief * dot(way, slope) - roundness * dot(way, place));
    colour = vec4((sun.rgb * shade + around) * a, a);
}
