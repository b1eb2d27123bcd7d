#pragma once

#include <cstddef>
#include <cstdint>

// The constants that trade error for time in the search for boundaries, the shadows and the leaves.
// Each has its unit and, in brackets, what sets it: a benchmark, an entry of docs/log, a test, or
// "assumed" where nothing was measured.

namespace asos {

/// Costs of the ways to determine a leaf. Samples or rays replace an estimator that costs as much
/// (choose).
struct LeafCosts {
  // In shadow rays of a small packet.
  /// A light cut along its occluders, or the edges of its shadow on a patch [bench prices:
  /// quartiles 4 and 20, mean 8 to 46; bench every-scene: at 5, office takes a fifth longer].
  static constexpr double light_view = 20.0;
  /// The boundaries of a patch's hard shadow, 2 to 8 [bench every-scene: primitives, house].
  static constexpr double search = 4.0;
  /// A patch cut along the edges of a hard shadow [bench prices: quartiles 25 and 70].
  static constexpr double patch = 60.0;
  // In samples of a part of the same weight.
  /// A leaf's centre with exact shadows; MAX 1 takes as long as 16 samples [bench every-scene].
  static constexpr double exact_leaf = 16.0;
  /// One of the leaves of a part that is split [test Penumbra: at 8, too few are].
  static constexpr double leaf = 3.0;
  /// One of the parts of a cell that is cut into many, and one light's soft shadow on a leaf; at
  /// 20, trees and roofs have a tenth more error; without shadows, three panels take twice as long
  /// [bench every-scene].
  static constexpr double part = 8.0;
};

/// Numbers of samples. Fewer may all miss something small, so that their variance is wrongly zero.
struct EnoughSamples {
  /// Samples per pixel for lights in mirrors, partly occluded lights, and surface layers
  /// [mirrors-and-glass: At least 256 samples; lights-and-shadows: First samples].
  static constexpr double of_rare_light = 256.0;
  /// Samples per defocused pixel [assumed].
  static constexpr std::uint32_t of_blur = 16;
  /// Samples per visible light in a defocused pixel [lens-and-motion: Samples on visible lights].
  static constexpr double on_light = 4.0;
};

/// What leaves assume and allow.
struct LeafTuning {
  /// Contrast of a part with many surfaces [assumed].
  static constexpr double contrast_of_many = 0.5;
  /// Number of parts that are cut whatever samples cost [assumed].
  static constexpr std::size_t few_parts = 4;
  /// Error at which the first stage of a block ends, in allowances [rounds: Samples first].
  static constexpr double first_stage_error = 4.0;
  /// Parts along a side over which the colour of a cut leaf is averaged [estimate: Rules left out].
  static constexpr int colour_parts = 3;
  /// Most parts of the lens [lens-and-motion: MAX 1].
  static constexpr double most_parts_of_lens = 16.0;
  /// Fractions of the allowance and of the bounds of centres that are expected as errors, fitted to
  /// the built-in scenes [estimate: Dropped, layer error].
  static constexpr double share_of_tolerance = 1.0 / 12.0;
  static constexpr double share_of_bound = 0.6;

  /// Times that a pyray mirrored by a mesh is narrower than by a shape [mirrors-and-glass: Narrower
  /// mirrored pyrays].
  static constexpr double strictness_of_meshes = 8.0;
  /// Deviation of the neighbours' normals that does not matter, in radians [mirrors-and-glass:
  /// Curved mirrors].
  static constexpr double negligible_strays = 0.02;
  /// Width of the search for lights in mirrors of mirrors, in spreads of the corner rays
  /// [mirrors-and-glass: Mirrors in mirrors].
  static constexpr double wider_mirrored = 8.0;
  /// Width of a mirror's blur, in leaves, at which the leaf's outline vanishes [assumed].
  static constexpr double blurred_outline = 0.25;
  /// Fraction of the bound of a penumbra that is expected [estimate: Penumbrae to twice the
  /// tolerance].
  static constexpr double expected_penumbra = 0.5;

  /// Reach beyond a leaf's triangle, in the triangle's sides, from which the triangle does not
  /// represent it [estimate: Beyond the triangle].
  static constexpr float far_beyond_triangle = 0.5f;
  /// Distance of textures at edges that does not matter, in texels and in extents of the leaf, and
  /// the leaf's depth, in distances [textures-and-materials: Textures beyond their triangle,
  /// Receding patches].
  static constexpr float negligible_texels = 0.5f;
  static constexpr float negligible_extent = 0.1f;
};

/// Shadow rays and pyrays.
struct ShadowTuning {
  /// Limits for cutting a light or a patch: boundaries, and parts with a ray each [test
  /// CutOutHardShadow].
  static constexpr int most_boundaries = 24;
  static constexpr int most_pieces = 64;
  /// Groups of boundaries in a light's square beyond which it is not resolved [assumed].
  static constexpr int most_groups = 400;
  /// Levels of a light's pyray. More cost more than rays [estimate: Measured prices].
  static constexpr int pyramid_levels = 1;
  /// Level of a pixel whose detail outlines have at least [assumed].
  static constexpr int finest_detail = 3;
  /// Least length of a hit list above which samples cost less than the search [assumed].
  static constexpr std::size_t least_entries_for_samples = 48;
  /// Finest detail of boundaries around a patch, in sides of the light's square [assumed].
  static constexpr float finest_in_penumbra = 1.0f / 64.0f;

  /// Rays of the first round: of a whole pixel, and at least [lights-and-shadows: Up to 512 shadow
  /// rays].
  static constexpr double first_rays = 16.0;
  static constexpr std::uint32_t least_rays = 8;
  /// Rays of a leaf that needs only few, in rays that are needed [lights-and-shadows: Four times
  /// the rays].
  static constexpr double rays_for_one = 4.0;
  /// Points drawn for each ray, at most [assumed].
  static constexpr std::uint32_t most_points_a_ray = 16;
};

/// The search for boundaries, and the cuts along them.
struct SearchTuning {
  /// With at most `few_entries` in a hit list, opening them may prove the cell empty or crossed by
  /// one boundary. With more than `many_entries`, the cell is marginal in any case [test HitLists].
  static constexpr std::size_t few_entries = 4;
  static constexpr std::size_t many_entries = 16;
  /// Nodes, or segments, in front of a sample's surface from which a cell is saturated with
  /// boundaries [test HitLists].
  static constexpr std::size_t most_nodes_in_front = 64;
  static constexpr std::size_t most_segments_in_front = 256;
  /// Pieces of outlines that are resolved in a cell [estimate: Constants].
  static constexpr std::size_t most_pieces_resolved = 1024;
  /// Largest distance of a simplified chain from the original pieces in a finest cell, in sides of
  /// that cell: across it, an error of 1/64 of its area. In a cell n times as wide the limit is 1/n
  /// of that, so that the area's error along the longer chain is the same [derived].
  static constexpr float chain_tolerance = 1.0f / 64.0f;
  /// Level from which four equal samples end the splitting by samples. At lower levels a boundary
  /// is near [test MissedSplits].
  static constexpr int first_trusted_level = 2;
  /// The largest area between a piece of a curve and its arc, and the largest distance, in finest
  /// cells [assumed].
  static constexpr double most_area = 1.0 / 400.0;
  static constexpr double most_bulge = 1.0 / 16.0;
  /// Nodes in the cut of a group's shadows. More cost every pyray of the block more than a walk
  /// from the root [estimate: Constants].
  static constexpr std::size_t most_nodes = 24;
};

/// Samples of regions.
struct SampleTuning {
  /// Error of the mean of n samples of contrast 1: this, times n^(-3/4) [bench prices].
  static constexpr double error_of_one_sample = 0.35;
  /// Target standard error of samples, in units of the allowed error [estimate: One accuracy rule].
  static constexpr double standard_errors = 0.5;
  /// Samples of a pilot, at least [assumed].
  static constexpr double fewest = 4.0;
  /// Side of a sample's footprint, relative to the square that the sample represents; colours use
  /// colour_side. Many samples need no smoothing. Footprints as large as the square would make
  /// smoothed highlights (PatchLobe) up to twice too bright at grazing angles [test TrueLight].
  static constexpr float footprint_share = 0.25f;
  /// Most samples around a thin region, in samples in it [estimate: Constants].
  static constexpr float most_times_larger = 16.0f;
  /// Part of the variance of the neighbours' samples that counts for a region, and the weight in a
  /// pixel from which regions are neighbours [estimate: Constants].
  static constexpr double of_neighbours = 0.25;
  static constexpr double most_of_a_pixel = 0.5;
  /// Weight in a white picture from which all samples follow a reflection [estimate: Constants].
  static constexpr float least_followed = 1.0f / 32.0f;
};

/// Pixels that a lens blurs.
struct LensTuning {
  /// Radius of blur of a sharp pixel, in EPS. An edge along a pixel's border changes the pixel by
  /// 2 / (3 pi) of its contrast per pixel of radius: at full contrast, EPS at 4.7 EPS [derived].
  static constexpr double sharp_radius = 4.5;
  /// Radius of blur, in pixels, from which pixels are sampled, since a search around one would find
  /// the whole block's surroundings [lens-and-motion: MAX 1].
  static constexpr double most_reach = 12.0;
  /// Room for meshes that bend away from the plane of one of their triangles. With less room, more
  /// pixels fail stays_within_reach and are sampled [assumed].
  static constexpr double bend_of_meshes = 1.25;
  /// Change of the radius of blur per pixel from which a pixel is sampled [assumed].
  static constexpr double steepest = 0.5;
};

/// Fits through sampled leaves of one surface.
struct FitTuning {
  /// Error at which leaves are fitted, in allowances: leaves that share a fit have less
  /// [sky: One queue].
  static constexpr double first_error = 2.0;
  /// Fewest leaves of a fit, and most surfaces of a block [assumed].
  static constexpr std::size_t fewest_leaves = 14, most_surfaces = 32;
  /// Largest deviations of a leaf, and of all leaves together, in standard deviations [sky: One
  /// queue].
  static constexpr double most_off = 4.0, most_off_together = 3.0;
  /// Least cosine between normals, and steepest slope between two leaves [assumed].
  static constexpr float least_cosine = 0.9f, steepest = 0.5f;
};

}  // namespace asos
