#pragma once

#include "renderer/reflections/mirror_plane.h"
#include "renderer/reflections/mirrored_pyray.h"
#include "renderer/shading/footprint.h"
#include "renderer/shading/surface.h"

#include <optional>

namespace asos {

/// Returns the mirror at a point whose hit is `hit`. With `bent`, it includes the turn of its
/// normals across the pyray's patch. Without, it is the tangent plane, which lies behind a concave
/// surface. For flat triangles the plane is the triangle's own, in double precision.
[[nodiscard]] MirrorSurface mirror_surface(const World& world, const Hit& hit,
                                           const SurfacePoint& point, const IncidentPyray& pyray,
                                           bool bent);

/// Returns a ray that leaves the surface in a unit direction. It starts exactly at the surface,
/// since a start above it would shift the reflection. A ray that leads below the surface hits
/// nothing.
[[nodiscard]] Ray ray_leaving(const MirrorSurface& surface, glm::dvec3 direction);

/// Returns the plane of a flat mirror.
[[nodiscard]] std::optional<MirrorPlane> plane_of(const MirrorSurface& surface);

/// Returns the pyray of a square of `side` pixels around a ray of unit direction that hits a
/// surface at `t`.
[[nodiscard]] IncidentPyray pyray_around(const PixelSpacing& spacing, const Ray& ray, float t,
                                         float side);

/// Returns a pixel's steps in a reflected picture of `side` pixels.
[[nodiscard]] PixelSpacing spacing_of(const MirroredPyray& pyray, float side);

}  // namespace asos
