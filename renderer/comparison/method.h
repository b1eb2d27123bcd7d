#pragma once

#include "renderer/film/block_result.h"
#include "renderer/film/film.h"
#include "renderer/film/statistics.h"
#include "renderer/geometry/view.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/settings/settings.h"

#include <cstddef>
#include <stop_token>

namespace asos {

/// The final pixels of one block of the picture, by the method that the settings name. `block` is
/// aligned to block_side(settings) in the whole picture (clipped at its right and bottom edge),
/// whatever the crop. A pure function of its arguments: any thread, any order, the same bits.
/// Samples that are not finite are left out of their pixel's mean and counted; a pixel without any
/// is black. Once `stop` is requested the result is unfinished and to be thrown away.
[[nodiscard]] BlockResult render_block(const RenderScene& scene, const View& view,
                                       const RenderSettings& settings, PixelRect block,
                                       const std::stop_token& stop = {});

// One function a method; render_block chooses.
[[nodiscard]] BlockResult render_block_asos(const RenderScene& scene, const View& view,
                                            const RenderSettings& settings, PixelRect block,
                                            const std::stop_token& stop = {});
/// n x n samples a pixel on a regular grid; n * n is the first square of at least
/// `settings.sampling.spp`. Each looks at one point of each light, on a grid of its own in an order
/// of the pixel's own.
[[nodiscard]] BlockResult render_block_uniform(const RenderScene& scene, const View& view,
                                               const RenderSettings& settings, PixelRect block,
                                               const std::stop_token& stop = {});
/// One sample at a random place in each of the n x n strata, of the pixel and of each light, seeded
/// by pixel and sample.
[[nodiscard]] BlockResult render_block_stochastic(const RenderScene& scene, const View& view,
                                                  const RenderSettings& settings, PixelRect block,
                                                  const std::stop_token& stop = {});
/// `settings.sampling.spp` points of an Owen-scrambled Sobol sequence over the pixel and each
/// light.
[[nodiscard]] BlockResult render_block_sobol(const RenderScene& scene, const View& view,
                                             const RenderSettings& settings, PixelRect block,
                                             const std::stop_token& stop = {});
/// Adaptive supersampling in image space (Whitted 1980; CGF'98 section 2.3). Samples lie at the
/// pixels' corners; a square of which they differ by more than `settings.sampling.contrast` in
/// display intensity, in any channel, is split into four, down to `settings.sampling.depth`. A
/// pixel is the mean of its squares' corners, by area. A corner is shared by all squares around it,
/// and looks at one point of each light, which its place and the seed tell. With
/// `settings.sampling.spheres` squares are also split where a corner's ray goes through the
/// EnlargedSpheres of an object that it misses.
[[nodiscard]] BlockResult render_block_whitted(const RenderScene& scene, const View& view,
                                               const RenderSettings& settings, PixelRect block,
                                               const std::stop_token& stop = {});
/// Two-level sampling (Mitchell 1987): the first four of `settings.sampling.spp` Sobol points; and
/// the rest, too, where (max - min) / (max + min) of those four reaches
/// `settings.sampling.contrast_scale` times 0.4, 0.3 or 0.6 in linear red, green or blue. Each
/// pixel decides by its own samples and not by its neighbours', all its samples weigh the same, and
/// the filter is the pixel's box; Mitchell's cells hold eight or nine samples and his filter is
/// wider. With up to four samples it is `sobol`.
[[nodiscard]] BlockResult render_block_mitchell(const RenderScene& scene, const View& view,
                                                const RenderSettings& settings, PixelRect block,
                                                const std::stop_token& stop = {});
/// Ray bound tracing (Ohta and Maekawa 1990; CGF'98 section 2.9): n x n jittered samples, as many
/// as `uniform` would take, in pixels with an object's boundary (pixels_with_boundaries), and one
/// through the centre in the others. The centre's sample is one of the n x n: it stands in for that
/// of a middle stratum. Eye rays only: boundaries of shadows and cut-outs are not looked for.
[[nodiscard]] BlockResult render_block_ray_bound(const RenderScene& scene, const View& view,
                                                 const RenderSettings& settings, PixelRect block,
                                                 const std::stop_token& stop = {});
/// One sample through each pixel's centre, then the mean of 3 x 3 neighbours with the weights 1 2 1
/// each way (CGF'98 section 2.1), beyond the picture's border, too. The section's other way, rays
/// through pixels' corners and their mean, is `whitted` at depth 0.
[[nodiscard]] BlockResult render_block_average(const RenderScene& scene, const View& view,
                                               const RenderSettings& settings, PixelRect block,
                                               const std::stop_token& stop = {});
/// Beam tracing (CGF'98 section 2.6): a pixel is the sum over its exactly visible polygons of area
/// times radiance at the centroid, whatever MAX, EPS and the samples asked for. The areas are exact
/// for opaque surfaces only: a cut-out or see-through surface hides with its whole triangles what
/// lies behind, but for what the shader adds along the centroid's ray. For small scenes: see
/// check_method.
[[nodiscard]] BlockResult render_block_beam(const RenderScene& scene, const View& view,
                                            const RenderSettings& settings, PixelRect block,
                                            const std::stop_token& stop = {});

/// The largest scene that beam tracing takes. Each block looks at every triangle, which is nearly
/// all its time: at this size some 0.6 ms a pixel, or ten minutes of one core for 1280x720.
inline constexpr std::size_t most_beam_triangles = 300'000;

/// Whether the method can render the scene, or why not: beam tracing refuses large ones.
[[nodiscard]] Result<void> check_method(const RenderScene& scene, const RenderSettings& settings);

}  // namespace asos
