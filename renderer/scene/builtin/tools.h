#pragma once

#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <cstdint>

// Tools and metal work for the built-in workshop.

namespace asos::builtin {

/// The parts of tools by material.
struct ToolMeshes {
  Mesh blades;   ///< flat steel
  Mesh rods;     ///< round steel
  Mesh handles;  ///< plastic
  Mesh wood;
  Mesh cast;  ///< painted cast iron
};

// Tools hang on a board and face +z, with their upper end at `at`, `length` metres long.
void add_spanner(ToolMeshes& tools, glm::vec3 at, float length);
void add_screwdriver(ToolMeshes& tools, glm::vec3 at, float length);
void add_hammer(ToolMeshes& tools, glm::vec3 at, float length);
void add_saw(ToolMeshes& tools, glm::vec3 at, float length);
void add_square(ToolMeshes& tools, glm::vec3 at, float length);
void add_pliers(ToolMeshes& tools, glm::vec3 at, float length);
void add_chisel(ToolMeshes& tools, glm::vec3 at, float length);

/// A bench vice that stands at `foot` and opens towards +z.
void add_vice(ToolMeshes& tools, glm::vec3 foot);

/// A bowl, or a vase, that stands at `foot`: `size` is its largest radius.
void add_vessel(Mesh& mesh, glm::vec3 foot, float size, bool tall);

/// A gear with a vertical axis.
void add_gear(Mesh& mesh, glm::vec3 centre, float radius, int teeth);

/// Gives the vertices from `first` on, which form a surface of revolution, texture coordinates in
/// metres: u around the axis, measured at `radius`, and v along the outline. Flat ends get planar
/// coordinates, projected along the axis. Vertices at the seam are doubled.
void add_round_texcoords(Mesh& mesh, std::uint32_t first, glm::vec3 base, glm::vec3 axis,
                         float radius);

}  // namespace asos::builtin
