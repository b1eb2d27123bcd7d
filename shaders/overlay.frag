#version 330 core

// A map of the picture's pixels over it: where its alpha is 1 it hides them, where it is 0 it
// darkens them by `dimming`.
uniform sampler2D overlay;
uniform float dimming;

in vec2 texture_position;
out vec4 colour;

void main() {
  vec4 texel = texture(overlay, texture_position);
  colour = vec4(texel.rgb, mix(dimming, 1.0, texel.a));
}
