#pragma once

#include "renderer/scene/builtin/scene_assembler.h"

#include <glm/glm.hpp>

// Parts of the built-in house.

namespace asos::builtin {

/// Appends one slope of a roof whose ridge runs along x, as overlapping courses of tiles (12
/// triangles each). `eave` and `ridge` are (distance from the ridge's plane, height) of the slope's
/// underside. `side` is +1 for the slope that falls towards +z and -1 for the other.
void add_tiled_slope(Mesh& mesh, glm::vec2 eave, glm::vec2 ridge, float half_length, float side,
                     int courses);

/// A window with mullions and shutters, around the origin and facing +z, for many instances.
struct WindowMeshes {
  int frame = -1;
  int pane = -1;
  int shutters = -1;
};
[[nodiscard]] WindowMeshes keep_window(SceneAssembler& stage);
void place_window(SceneAssembler& stage, const WindowMeshes& window, const glm::dmat4& placement,
                  int number);

/// A porch along the wall z = `wall`, from x0 to x1: deck, steps, posts, railing and lean-to roof.
void add_porch(SceneAssembler& stage, float x0, float x1, float wall);

/// Appends a field of sand as a mesh of 1,140 triangles: level under house and gazebo, with low
/// dunes around them. Smooth, with texture coordinates in metres along x and z, and tangents.
void add_sand(Mesh& mesh);

/// An eight-sided gazebo with posts, railing and conical roof, standing at `place`.
void add_gazebo(SceneAssembler& stage, glm::dvec3 place);

}  // namespace asos::builtin
