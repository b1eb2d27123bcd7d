#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <initializer_list>

namespace asos::ui {

/// A small drawing in the current Dear ImGui window with its colours, 16 units wide and 6 high; y
/// down.
class Sketch {
 public:
  /// Reserves the space, `width` window units wide.
  explicit Sketch(float width);

  enum class Ink { plain, dim, accent, warm, faint };
  void line(glm::vec2 from, glm::vec2 to, Ink ink = Ink::plain) const;
  void box(glm::vec2 lo, glm::vec2 hi, Ink ink = Ink::plain) const;
  void filled(glm::vec2 lo, glm::vec2 hi, Ink ink, float alpha = 1.0f) const;
  void disc(glm::vec2 at, float radius, Ink ink, float alpha = 1.0f) const;
  void ring(glm::vec2 at, float radius, Ink ink = Ink::plain) const;
  void shape(std::initializer_list<glm::vec2> corners, Ink ink, float alpha = 1.0f) const;
  void words(glm::vec2 middle, const char* text, Ink ink = Ink::dim) const;
  /// A square split `levels` times into quadrants, towards the point.
  void split_square(glm::vec2 lo, float side, glm::vec2 towards, int levels) const;

 private:
  [[nodiscard]] glm::vec2 at(glm::vec2 place) const { return lo_ + place * unit_; }
  [[nodiscard]] std::uint32_t colour(Ink ink, float alpha = 1.0f) const;

  glm::vec2 lo_;
  float unit_;
};

/// A pixel's pyramid from the eye through the picture to an edge.
void draw_pyray(const Sketch& sketch);

}  // namespace asos::ui
