#pragma once

#include "renderer/result.h"
#include "ui/gl/gl.h"

#include <utility>

namespace asos::ui::gl {

/// Owns an OpenGL name and deletes it. The context has to be current when it is destroyed.
template <void (*destroy)(GLuint)>
class Object {
 public:
  Object() = default;
  explicit Object(GLuint name) : name_(name) {}
  Object(Object&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  Object& operator=(Object&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  ~Object() {
    if (name_ != 0) destroy(name_);
  }

  [[nodiscard]] GLuint name() const { return name_; }

 private:
  GLuint name_ = 0;
};

inline void delete_texture(GLuint name) {
  glDeleteTextures(1, &name);
}
inline void delete_program(GLuint name) {
  glDeleteProgram(name);
}
inline void delete_vertex_array(GLuint name) {
  glDeleteVertexArrays(1, &name);
}

using Texture = Object<delete_texture>;
using Program = Object<delete_program>;
using VertexArray = Object<delete_vertex_array>;

[[nodiscard]] VertexArray make_vertex_array();
/// An RGBA8 texture of this size, clamped at its edges, with undefined contents.
[[nodiscard]] Texture make_rgba8_texture(int width, int height);
/// Compiles and links; the error is the driver's message.
[[nodiscard]] Result<Program> make_program(const char* vertex_source, const char* fragment_source);

}  // namespace asos::ui::gl
