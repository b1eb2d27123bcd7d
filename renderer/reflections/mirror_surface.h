#pragma once

#include "renderer/reflections/mirror_plane.h"
#include "renderer/reflections/mirrored_pyray.h"
#include "renderer/shading/footprint.h"
#include "renderer/shading/surface.h"

#include <optional>

namespace asos {

/// The mirror that a pyray meets at a point of the world, whose hit is `hit`. With `bent`, the turn
/// of its normals across the pyray's patch; without, it is taken for its tangent plane, which lies
/// behind a hollow. For flat triangles the plane is the triangle's own, in
/// double precision.
[[nodiscard]] MirrorSurface mirror_surface(const World& world, const Hit& hit,
                                           const SurfacePoint& point, const IncidentPyray& pyray,
                                           bool bent);

/// A ray that leaves it in a unit direction, along the way from its very position: a start above
/// the surface would move what is seen. One that leads below the surface meets nothing.
[[nodiscard]] Ray ray_leaving(const MirrorSurface& surface, glm::dvec3 direction);

/// The plane of a flat one.
[[nodiscard]] std::optional<MirrorPlane> plane_of(const MirrorSurface& surface);

/// The pyray of a square of `side` pixels around a ray of unit direction that meets a surface at
/// `t`.
[[nodiscard]] IncidentPyray pyray_around(const PixelSpacing& spacing, const Ray& ray, float t,
                                         float side);

/// A pixel's steps in a mirrored picture that is that of `side` pixels.
[[nodiscard]] PixelSpacing spacing_of(const MirroredPyray& pyray, float side);

}  // namespace asos
