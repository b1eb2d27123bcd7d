#pragma once

#include "renderer/scene/scene.h"

// Pictures of materials for the built-in scenes, made by code: square, the same every time, and
// without a seam where they are repeated.

namespace asos::builtin {

/// Sixteen planks one above the other, each of one length with its joint at another place; the
/// grain runs along u. sRGB.
[[nodiscard]] Image wood_planks();

/// Twelve rows of lapped boards, each with the shadow of the one above it. sRGB.
[[nodiscard]] Image clapboards();

/// The tangent-space normals of sand that the wind has rippled, on a square whose side is `metres`.
[[nodiscard]] Image sand_normals(double metres);

/// The same of metal that a round hammer has beaten.
[[nodiscard]] Image hammered_normals(double metres);

/// The same of metal that was brushed along u.
[[nodiscard]] Image brushed_normals(double metres);

}  // namespace asos::builtin
