#version 330 core

// A rectangle without buffers: four vertices of a strip, numbered left to right, top to bottom.
uniform vec4 rect;  // left, top, right, bottom in clip coordinates

out vec2 texture_position;  // (0, 0) at the picture's top left

void main() {
  texture_position = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  gl_Position = vec4(mix(rect.xy, rect.zw, texture_position), 0.0, 1.0);
}
