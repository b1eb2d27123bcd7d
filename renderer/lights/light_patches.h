#pragma once

#include "renderer/lights/prepared_light.h"

#include <glm/glm.hpp>

#include <array>
#include <span>
#include <vector>

namespace asos {

/// A part of a light's surface, or of the directions to it, by two numbers from 0 to 1: what its
/// integrals are summed up over.
struct LightPatch {
  static constexpr std::size_t nodes = 4;  ///< along each parameter
  static constexpr std::size_t cell_nodes = nodes * nodes;

  /// Directions to points of a patch, and the solid angle that each stands for.
  struct Cell {
    std::array<float, cell_nodes> x, y, z, solid_angle;
  };
  /// A square of the parameters.
  struct Square {
    float u = 0.0f, v = 0.0f, side = 1.0f;
  };

  enum class Kind {
    trapezoid,  ///< u across, v up
    sector,     ///< quarter of an ellipse: u from the middle, v around it
    cap,        ///< quarter of a cone's directions: as much of 1 - cos as u * u
  };
  Kind kind = Kind::trapezoid;
  // As seen from the receiver; lengths are in units of the distance to the light's middle.
  glm::vec3 origin{0.0f};  ///< middle; cap: unit axis
  glm::vec3 x{0.0f}, y{0.0f};
  glm::vec3 facing{0.0f};  ///< by length the area of a unit square of x and y
  bool two_sided = false;
  /// Trapezoid: x from left to left + width, at its foot and further up by the second; y.
  float left = 0.0f, left_on = 0.0f, width = 0.0f, width_on = 0.0f, foot = 0.0f, height = 0.0f;
  float one_less_cosine = 0.0f;  ///< cap

  /// Unit; of a receiver at the very place any number.
  [[nodiscard]] glm::vec3 direction(float u, float v) const;
  /// By Gauss and Legendre's nodes. What does not face the receiver has no solid angle.
  [[nodiscard]] Cell cell(const Square& square) const;

  /// All of a round light, of whose quarters each has four nodes.
  [[nodiscard]] static Cell cell_of_quarters(std::span<const LightPatch, 4> quarters);

 private:
  void look_at_places(Cell& cell) const;
};

/// All of a light that has a size and is no segment, by the physical rule, as a receiver sees it,
/// which has it above the horizon or not. Within a ball all directions above the normal's horizon
/// are.
void find_light_patches(const PreparedLight& light, const Receiver& receiver,
                        std::vector<LightPatch>& patches);

}  // namespace asos
