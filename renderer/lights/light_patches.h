#pragma once

#include "renderer/lights/prepared_light.h"

#include <glm/glm.hpp>

#include <array>
#include <span>
#include <vector>

namespace asos {

/// A part of a light's surface, or of the directions to it, with two parameters from 0 to 1.
/// Integrals over the light are sums over patches.
struct LightPatch {
  static constexpr std::size_t nodes = 4;  ///< along each parameter
  static constexpr std::size_t cell_nodes = nodes * nodes;

  /// Directions to points of a patch, each with its solid angle.
  struct Cell {
    std::array<float, cell_nodes> x, y, z, solid_angle;
  };
  /// A square of the parameters.
  struct Square {
    float u = 0.0f, v = 0.0f, side = 1.0f;
  };

  enum class Kind {
    trapezoid,  ///< u across, v up
    sector,     ///< quarter of an ellipse: u from the centre, v around it
    cap,        ///< quarter of a cone's directions: 1 - cos is proportional to u * u
  };
  Kind kind = Kind::trapezoid;
  // Relative to the receiver; lengths are in units of the distance to the light's centre.
  glm::vec3 origin{0.0f};  ///< centre; cap: unit axis
  glm::vec3 x{0.0f}, y{0.0f};
  glm::vec3 facing{0.0f};  ///< its length is the area of a unit square of x and y
  bool two_sided = false;
  /// Trapezoid: x from left to left + width at its foot; the `_on` values are their changes from
  /// foot to top.
  float left = 0.0f, left_on = 0.0f, width = 0.0f, width_on = 0.0f, foot = 0.0f, height = 0.0f;
  float one_less_cosine = 0.0f;  ///< cap

  /// Returns the unit direction to a point; undefined for a receiver at that point.
  [[nodiscard]] glm::vec3 direction(float u, float v) const;
  /// Returns Gauss-Legendre nodes. Nodes that do not face the receiver have no solid angle.
  [[nodiscard]] Cell cell(const Square& square) const;

  /// Adds four copies of a patch, each turned by a right angle in the plane of x and y.
  static void add_quarters(LightPatch patch, std::vector<LightPatch>& patches);
  /// Adds a cone of directions about a unit axis. `one_less_cosine` is 1 - cos of its half angle.
  static void add_cap(glm::dvec3 axis, double one_less_cosine, std::vector<LightPatch>& patches);

  /// Returns a whole round light with four nodes for each quarter.
  [[nodiscard]] static Cell cell_of_quarters(std::span<const LightPatch, 4> quarters);

 private:
  void look_at_places(Cell& cell) const;
};

/// Finds the patches of a whole light with an extent, except segments, by the physical rule,
/// whether they are above the receiver's horizon or not. Inside a ball they are all directions
/// above the normal's horizon.
void find_light_patches(const PreparedLight& light, const Receiver& receiver,
                        std::vector<LightPatch>& patches);

}  // namespace asos
