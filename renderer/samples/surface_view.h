#pragma once

#include "renderer/film/film.h"
#include "renderer/geometry/view.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/rays/ray_scene.h"

#include <array>
#include <cstdint>
#include <stop_token>
#include <vector>

namespace asos {

/// A property of the visible surfaces that is displayed instead of radiance.
enum class SurfaceProperty : std::uint8_t {
  base_color,  ///< linear
  normal,      ///< shading normal in world axes: 0.5 n + 0.5
  roughness,   ///< 0 to 1
  metallic,    ///< 0 to 1
  occlusion,   ///< of the material's texture, 0 to 1; 1 where it has none
  emission,    ///< linear radiance
  /// A checkerboard with eight squares in u and v, in a different colour for each 1 x 1 tile.
  texture_coordinates,
  second_texture_coordinates,  ///< the same for the second set; black where there is none
  vertex_color,                ///< linear; white where there is none
};
inline constexpr int surface_properties = 9;

/// Names of the properties on the command line and in files.
inline constexpr std::array<const char*, surface_properties> surface_property_names{
    "base-color", "normal", "roughness", "metallic",    "occlusion",
    "emission",   "uv",     "uv2",       "vertex-color"};

/// The number of eye rays for a view of surfaces.
struct SurfaceSampling {
  int step = 1;  ///< side of the square of pixels that shares one sample
  int side = 1;  ///< side of the grid of samples in such a square: side * side rays
};

/// A picture of surfaces without lighting.
struct SurfacePicture {
  /// Means over each pixel's samples. Values that are not colours are stored so that the sRGB curve
  /// displays them unchanged: 0.5 becomes byte 128. `coverage` is the fraction of samples that hit
  /// a surface; radiance is premultiplied by it.
  Film film;
  /// The fraction of each pixel that triangle edges cover, 0 to 1, drawn 1 pixel wide. Analytic
  /// shapes have none.
  std::vector<float> wireframe;
};

/// Samples one property of the surfaces nearest to the eye, at fixed places, so that the bits do
/// not depend on threads. Blended surfaces count as opaque; masked ones have their holes. The
/// ground that the program adds counts as background. Returns an unfinished picture once `stop` is
/// requested.
[[nodiscard]] SurfacePicture surface_picture(const RenderScene& scene, const View& view,
                                             Culling faces, SurfaceProperty property,
                                             SurfaceSampling sampling, const std::stop_token& stop);

}  // namespace asos
