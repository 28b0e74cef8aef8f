#version 330 core
// A quad around one particle. The members are those of fumage::Sprite.
layout(location = 0) in vec4 box; // centre, half width and height, in pixels
layout(location = 1) in vec4 matrix; // m00, m01, m10, m11
layout(location = 2) in vec4 direct; // colour of the sun's light, opacity
layout(location = 3) in vec3 ambient;
layout(location = 4) in uint packedLook;
layout(location = 5) in uvec4 packedDetail[8]; // the words of fumage::SpriteDetail
layout(location = 13) in uint ofLayer;

uniform vec2 size; // pixels of the view that the sprites were made for

flat out vec4 rows;
flat out vec4 sun;
flat out vec3 around;
flat out uint look;
flat out uint layerOf;
flat out uvec4 detail[8];
out vec2 offset; // from the centre, pixels

void main()
{
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    offset = corner * box.zw;
    vec2 at = box.xy + offset;
    gl_Position = vec4(at.x / size.x * 2.0 - 1.0, 1.0 - at.y / size.y * 2.0, 0.0, 1.0);
    rows = matrix;
    sun = direct;
    around = ambient;
    look = packedLook;
    layerOf = ofLayer;
    detail = packedDetail;
}
