#version 330 core

// A map of the picture's pixels, blended over it.
uniform sampler2D overlay;
uniform float opacity;

in vec2 texture_position;
out vec4 colour;

void main() {
  vec4 texel = texture(overlay, texture_position);
  colour = vec4(texel.rgb, texel.a * opacity);
}
