#include "ui/gl/gl_objects.h"

#include <string>

namespace asos::ui::gl {

VertexArray make_vertex_array() {
  GLuint name = 0;
  glGenVertexArrays(1, &name);
  return VertexArray(name);
}

Texture make_rgba8_texture(int width, int height) {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  return Texture(name);
}

namespace {

Result<GLuint> compile(GLenum type, const char* source) {
  const GLuint shader = glCreateShader(type);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint compiled = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled) return shader;
  std::string log(4096, '\0');
  GLsizei length = 0;
  glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
  glDeleteShader(shader);
  log.resize(static_cast<std::size_t>(length));
  return unexpected(Error{"OpenGL shader", log});
}

}  // namespace

Result<Program> make_program(const char* vertex_source, const char* fragment_source) {
  const Result<GLuint> vertex = compile(GL_VERTEX_SHADER, vertex_source);
  if (!vertex) return unexpected(vertex.error());
  const Result<GLuint> fragment = compile(GL_FRAGMENT_SHADER, fragment_source);
  if (!fragment) {
    glDeleteShader(*vertex);
    return unexpected(fragment.error());
  }

  Program program(glCreateProgram());
  glAttachShader(program.name(), *vertex);
  glAttachShader(program.name(), *fragment);
  glLinkProgram(program.name());
  glDeleteShader(*vertex);
  glDeleteShader(*fragment);

  GLint linked = 0;
  glGetProgramiv(program.name(), GL_LINK_STATUS, &linked);
  if (linked) return program;
  std::string log(4096, '\0');
  GLsizei length = 0;
  glGetProgramInfoLog(program.name(), static_cast<GLsizei>(log.size()), &length, log.data());
  log.resize(static_cast<std::size_t>(length));
  return unexpected(Error{"OpenGL program", log});
}

}  // namespace asos::ui::gl
