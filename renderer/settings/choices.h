#pragma once

namespace asos {

// The values that settings choose among.

/// How pixels are rendered: by a row of method_table (renderer/comparison/method.h).
/// asos_published: asos with cone detection, point leaves and the published rule, whatever the
/// settings below say.
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

/// When the marginal cells of a level need not be split any further.
enum class StoppingRule {
  unresolved,  ///< M / 2^2K <= EPS: the area of all marginal cells bounds the error, whatever is
               ///< seen
  published,   ///< L / 2^2K <= EPS for each object by itself (CGF'98 sections 3.1 and 6.2)
};

/// How it is found out whether a boundary passes through a (sub-)pyray: by its exact square, or by
/// the circular cone that surrounds it, as published (CGF'98 section 3). The cone takes boundaries
/// for near that miss the pyray by up to a fifth of its side (more where it is seen askew): more
/// marginal pyrays, no less accuracy, for samples lie in the square all the same.
enum class Detection { square, cone };

/// How the shadow of a light of some size is found over the patch that a leaf shows (CGF'98
/// sections 4.2 to 4.3.4, whose names these are, but for the first).
enum class ShadowQuality {
  refined,            ///< one pyray from the leaf's sample; leaves are split where its shadow would
                      ///< be off the mean of the patch
  centre,             ///< one pyray from the leaf's sample (4.2)
  supersampling,      ///< pyrays from n x n jittered points of the patch (4.3.1)
  forced,             ///< from the middles of n x n parts of the patch (4.3)
  extended,           ///< one pyray from behind the surface, through as much of the patch as the
                      ///< light's projection covers (4.3.2)
  extended_divided,   ///< the same for each of n x n parts (4.3.3)
  extended_adaptive,  ///< parts until each lies inside the light's projection; then a pyray that
                      ///< holds the part, of which only what passes through it counts (4.3.4)
};

/// How the light of what is seen of a light is summed up.
enum class LightRule {
  physical,   ///< closed forms: the projected solid angle times radiance
  published,  ///< I A cos(theta) with inverse square at a leaf's middle; without the cosine for
              ///< balls; points along linear lights (CGF'98 section 4.2; GI'93 "Distributed Light
              ///< Sources")
};

/// How the reflection of a pyray by a curved surface is made (CGF'98 section 5.2).
enum class CurvedMirror {
  approximate,  ///< the pyramid nearest to the reflected corner rays (5.2.1)
  tangent,      ///< as by the tangent plane at the pyray's axis (5.2.2)
  supersample,  ///< the same, each pyray split down to MAX first (5.2.3)
  adaptive,     ///< the same, split where the reflected corners diverge too much (5.2.4)
};

/// footprint: textures, and highlights where the normal turns, are averaged over what a sample
/// stands for; point: they are looked up where its ray hits.
enum class TextureFilter { footprint, point };

/// What the scene stands on: nothing, a plate that shows shadows, or one that mirrors, too.
enum class Ground { off, on, mirror };

/// The features that a person asks for: those that the scene needs, or all, for the same picture.
enum class NeedsChoice { scene, all };

}  // namespace asos
