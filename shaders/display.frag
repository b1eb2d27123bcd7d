#version 330 core

// The picture. Its texture holds display bytes, so there is nothing left to do: tone mapping runs
// on the processor, for changed tiles only.
uniform sampler2D picture;

in vec2 texture_position;
out vec4 colour;

void main() {
  colour = vec4(texture(picture, texture_position).rgb, 1.0);
}
