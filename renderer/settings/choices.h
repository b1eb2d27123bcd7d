#pragma once

namespace asos {

// Enumerations of the settings.

/// The rendering method: a row of method_table (renderer/comparison/method.h). asos_published: asos
/// with cone detection, point leaves and the published rule, whatever the settings below are.
enum class Method {
  asos,
  asos_published,
  uniform,
  stochastic,
  sobol,
  sobol_adaptive,
  whitted,
  mitchell,
  ray_bound,
  average,
  beam,
  cone,
  covers,
  mask
};
inline constexpr Method last_method = Method::mask;

enum class LeafKind { exact, point };

/// The condition that ends the subdivision of marginal cells.
enum class StoppingRule {
  unresolved,  ///< M / 2^2K <= EPS: the area of all marginal cells bounds the error
  published,   ///< L / 2^2K <= EPS for each object separately (CGF'98 sections 3.1 and 6.2)
};

/// The test that decides if a boundary crosses a pyray: with its exact square cross-section, or
/// with the circumscribed cone, as published (CGF'98 section 3). The cone also accepts boundaries
/// that miss the pyray by up to a fifth of its side (more at oblique angles). This makes more
/// pyrays marginal, and no less accurate, since samples stay inside the square.
enum class Detection { square, cone };

/// The method for the shadow of an area light over the patch of a leaf (CGF'98 sections 4.2 to
/// 4.3.4, which define the names except for the first).
enum class ShadowQuality {
  refined,            ///< one pyray from the leaf's sample; leaves are split if its shadow would
                      ///< differ from the mean of the patch
  centre,             ///< one pyray from the leaf's sample (4.2)
  supersampling,      ///< pyrays from n x n jittered points of the patch (4.3.1)
  forced,             ///< pyrays from the centres of n x n parts of the patch (4.3)
  extended,           ///< one pyray from behind the surface, through as much of the patch as the
                      ///< light's projection covers (4.3.2)
  extended_divided,   ///< the same for each of n x n parts (4.3.3)
  extended_adaptive,  ///< splits the patch until each part lies inside the light's projection;
                      ///< then a pyray around the part; only its rays through the part count
                      ///< (4.3.4)
};

/// The formula for the light received from the visible part of a light.
enum class LightRule {
  physical,   ///< closed forms: the projected solid angle times radiance
  published,  ///< I A cos(theta) with inverse square at a leaf's centre; without the cosine for
              ///< balls; points along linear lights (CGF'98 section 4.2; GI'93 "Distributed Light
              ///< Sources")
};

/// The construction of the pyray that a curved surface reflects (CGF'98 section 5.2).
enum class CurvedMirror {
  approximate,  ///< the pyramid nearest to the reflected corner rays (5.2.1)
  tangent,      ///< reflected in the tangent plane at the pyray's axis (5.2.2)
  supersample,  ///< tangent, with each pyray split down to MAX first (5.2.3)
  adaptive,     ///< tangent, split if the reflected corners diverge too much (5.2.4)
};

/// Texture lookup. footprint: textures, and highlights on normal maps, are averaged over the
/// footprint of a sample; point: at the hit point only.
enum class TextureFilter { footprint, point };

/// The ground under the scene: none, a plate that receives shadows, or one that also reflects.
enum class Ground { off, on, mirror };

/// The features that a picture is rendered with: those of the scene, or all of them. The picture is
/// the same.
enum class FeatureChoice { scene, all };

}  // namespace asos
