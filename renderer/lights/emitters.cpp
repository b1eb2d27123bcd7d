#include "renderer/lights/emitters.h"

#include "renderer/geometry/largest.h"
#include "renderer/lights/emitter_clusters.h"
#include "renderer/lights/emitter_mesh.h"
#include "renderer/lights/emitter_moments.h"
#include "renderer/lights/emitter_shapes.h"
#include "renderer/lights/lit_texels.h"
#include "renderer/lights/prepared_light.h"
#include "renderer/lights/textured_emitter.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

namespace asos {
namespace {

using std::numbers::pi;

// A piece with more flat regions than a box may be round.
constexpr std::size_t regions_of_box = 6;
// Among many regions, those with at least this fraction of the area keep their outlines.
constexpr double large_share = 0.1;
// Size limit of a curved piece's rectangles: some 30 degrees of normals, a quarter of its length.
constexpr double curved_tolerance = 0.5;
// A surface faces one way if at least this fraction of it is visible from there.
constexpr double facing_share = 0.5;

// A curved piece may have the largest number of lights if its half length is at least this fraction
// of the bounding sphere's radius.
constexpr double large_piece = 0.1;

// A piece's emission is even if its variance is less than this fraction of its mean square.
constexpr double uneven_share = 0.05;

struct EmissiveSurface {
  const World& world;
  EmissionAt emission;
  std::vector<EmitterTriangle> triangles;
  bool double_sided = false;
  bool painted = false;  ///< a texture or a mask varies its emission
  double scene_radius = 0.0;
  std::size_t most_of_piece = 1;  ///< most lights of a painted piece
};

/// Regions connected by edges.
struct ConnectedPiece {
  std::vector<Piece> regions;
  Piece triangles;
  Moments moments;
  bool closed = false;  ///< no edge is open

  /// Returns whether one of the surface's sides faces a space that the surface encloses completely
  /// or almost.
  [[nodiscard]] bool encloses() const { return closed || moments.encloses(); }
};

void turn_inside_out(EmissiveSurface& surface, const Piece& piece) {
  for (const std::uint32_t i : piece) {
    EmitterTriangle& t = surface.triangles[i];
    std::swap(t.corner[1], t.corner[2]);
    std::swap(t.vertex[1], t.vertex[2]);
    t.normal = -t.normal;
  }
}

std::vector<ConnectedPiece> pieces_of(EmissiveSurface& surface) {
  std::vector<ConnectedPiece> pieces;
  const EmitterNeighbours neighbours(surface.triangles);
  for (std::vector<Piece>& regions : connected_pieces(surface.triangles, neighbours)) {
    ConnectedPiece& piece = pieces.emplace_back();
    for (const Piece& region : regions)
      piece.triangles.insert(piece.triangles.end(), region.begin(), region.end());
    piece.regions = std::move(regions);
    piece.moments = Moments::of(surface.triangles, piece.triangles);
    piece.closed = std::all_of(piece.triangles.begin(), piece.triangles.end(),
                               [&](std::uint32_t t) { return neighbours.surrounded(t); });
    // A double-sided surface that encloses a space emits only outwards, so its front has to face
    // outwards.
    if (surface.double_sided && piece.encloses() && piece.moments.outward < 0.0) {
      turn_inside_out(surface, piece.triangles);
      piece.moments = Moments::of(surface.triangles, piece.triangles);
    }
  }
  return pieces;
}

bool two_sided(const EmissiveSurface& surface, const ConnectedPiece& piece) {
  return surface.double_sided && !piece.encloses();
}

/// Replaces a curved piece by at most `most` rectangles.
std::vector<Light> rectangles(const EmissiveSurface& surface, const Piece& piece, std::size_t most,
                              bool both_sides) {
  const Moments whole = Moments::of(surface.triangles, piece);
  // The half length of a straight line with this spread.
  const double size = std::sqrt(3.0 * principal_axes(whole.spread).value.x);
  if (size < large_piece * surface.scene_radius) {
    const double share = size / (large_piece * surface.scene_radius);
    const double fewer = std::ceil(share * static_cast<double>(max_lights_of_curved_piece));
    most = std::min(most, static_cast<std::size_t>(std::max(1.0, fewer)));
  }
  std::vector<ClusterPoint> points;
  for (const std::uint32_t i : piece) {
    const EmitterTriangle& t = surface.triangles[i];
    points.push_back(
        {size > 0.0 ? (t.middle() - whole.centre) / size : glm::dvec3(0.0), t.normal, t.area});
    if (surface.painted) points.back().emission = t.radiance / largest(whole.radiance());
  }
  std::vector<Light> lights;
  for (const std::vector<std::uint32_t>& group : cluster(points, most, curved_tolerance)) {
    Piece members;
    for (const std::uint32_t i : group) members.push_back(piece[i]);
    if (auto light = one_light(Moments::of(surface.triangles, members), both_sides, Extent::area))
      lights.push_back(std::move(*light));
  }
  return lights;
}

/// Returns whether the triangles of a textured piece differ in emission.
bool uneven(const EmissiveSurface& surface, const ConnectedPiece& piece) {
  if (!surface.painted) return false;
  double square = 0.0;
  for (const std::uint32_t i : piece.triangles) {
    const EmitterTriangle& t = surface.triangles[i];
    square += t.area * glm::dot(t.radiance, t.radiance);
  }
  const glm::dvec3 mean = piece.moments.radiance();
  return square - piece.moments.area * glm::dot(mean, mean) > uneven_share * square;
}

std::vector<Light> lights_of(const EmissiveSurface& surface, const ConnectedPiece& piece) {
  if (piece.regions.size() > regions_of_box && !uneven(surface, piece)) {
    if (auto ball = ball_light(piece.moments)) return {std::move(*ball)};
    if (auto tube = tube_light(surface.triangles, piece.triangles, piece.moments))
      return {std::move(*tube)};
  }
  const bool both_sides = two_sided(surface, piece);
  const bool few = piece.regions.size() <= max_lights_of_curved_piece;
  std::vector<Light> lights;
  std::vector<FlatEmitter> painted;
  Piece curved;
  for (const Piece& region : piece.regions) {
    double area = 0.0;
    for (const std::uint32_t i : region) area += surface.triangles[i].area;
    std::optional<Light> flat;
    if (few || area >= large_share * piece.moments.area)
      flat = polygon_light(surface.triangles, region, both_sides);
    if (!flat) {
      curved.insert(curved.end(), region.begin(), region.end());
      continue;
    }
    FlatEmitter emitter{*std::move(flat), region};
    if (surface.painted && can_be_split(emitter)) {
      painted.push_back(std::move(emitter));
    } else {
      lights.push_back(std::move(emitter.light));
    }
  }
  // Half of the lights are reserved for curved regions.
  const std::size_t others = lights.size() + (curved.empty() ? 0 : surface.most_of_piece / 2);
  const std::size_t most = surface.most_of_piece > others ? surface.most_of_piece - others : 0;
  for (Light& light :
       split_by_texture(surface.world, surface.emission, surface.triangles, painted, most))
    lights.push_back(std::move(light));
  const std::size_t left =
      max_lights_of_curved_piece - std::min(lights.size(), max_lights_of_curved_piece - 1);
  for (Light& light : rectangles(surface, curved, left, both_sides))
    lights.push_back(std::move(light));
  return lights;
}

/// Returns the lights of at most `max_lights_of_part` pieces. The brightest keep their own lights
/// while there is room for one light for each of the others.
std::vector<Light> lights_of_few(const EmissiveSurface& surface,
                                 std::vector<ConnectedPiece>& pieces) {
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const ConnectedPiece& a, const ConnectedPiece& b) {
                     return largest(a.moments.power) > largest(b.moments.power);
                   });
  std::vector<Light> lights;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    std::vector<Light> own = lights_of(surface, pieces[i]);
    if (lights.size() + own.size() + (pieces.size() - i - 1) > max_lights_of_part) {
      own.clear();
      if (auto one = one_light(pieces[i].moments, two_sided(surface, pieces[i]), Extent::spread))
        own.push_back(std::move(*one));
    }
    for (Light& light : own) lights.push_back(std::move(light));
  }
  return lights;
}

/// Returns the lights of more than `max_lights_of_part` pieces, merging pieces that are near to
/// each other and face the same way.
std::vector<Light> lights_of_many(const EmissiveSurface& surface,
                                  const std::vector<ConnectedPiece>& pieces) {
  Piece all(surface.triangles.size());
  std::iota(all.begin(), all.end(), 0u);
  const Moments whole = Moments::of(surface.triangles, all);
  const double size = std::sqrt(3.0 * principal_axes(whole.spread).value.x);
  std::vector<ClusterPoint> points;
  for (const ConnectedPiece& piece : pieces) {
    const Moments& m = piece.moments;
    const double facing = glm::length(m.area_vector);
    points.push_back({size > 0.0 ? (m.centre - whole.centre) / size : glm::dvec3(0.0),
                      facing > facing_share * m.area ? m.area_vector / facing : glm::dvec3(0.0),
                      m.area});
  }
  std::vector<Light> lights;
  for (const std::vector<std::uint32_t>& group : cluster(points, max_lights_of_part, 0.0)) {
    Piece members;
    bool both_sides = false;
    for (const std::uint32_t i : group) {
      members.insert(members.end(), pieces[i].triangles.begin(), pieces[i].triangles.end());
      both_sides |= two_sided(surface, pieces[i]);
    }
    std::vector<Light> own;
    if (group.size() == 1) own = lights_of(surface, pieces[group.front()]);
    if (own.size() != 1) {
      own.clear();
      if (auto one = one_light(Moments::of(surface.triangles, members), both_sides, Extent::spread))
        own.push_back(std::move(*one));
    }
    for (Light& light : own) lights.push_back(std::move(light));
  }
  return lights;
}

/// Returns the power of the front side, and of the back side if it emits, too: nits times area
/// times pi.
double power(const Light& light) {
  const double brightest = largest(light.color) * light.intensity;
  switch (light.type) {
    case Light::Type::point:
    case Light::Type::spot:
      return 4.0 * pi * brightest;
    case Light::Type::linear:
      return pi * pi * brightest;
    case Light::Type::rectangle:
    case Light::Type::disk:
    case Light::Type::polygon:
      return pi * brightest * prepare_light(light).area * (light.two_sided ? 2.0 : 1.0);
    case Light::Type::directional:
      break;
  }
  return 0.0;
}

}  // namespace

bool emits(const Material& material) {
  return !material.unlit && material.emissive_strength > 0.0f &&
         std::max({material.emissive.x, material.emissive.y, material.emissive.z}) > 0.0f;
}

std::vector<Light> emissive_lights(const World& world, EmissionAt emission) {
  const double radius = world.bounds.empty() ? 0.0
                                             : 0.5 * glm::distance(glm::dvec3(world.bounds.lo),
                                                                   glm::dvec3(world.bounds.hi));
  std::vector<Light> lights;
  std::map<int, LitTexels> lit;  // by texture
  for (std::uint32_t part = 0; part < world.parts.size(); ++part) {
    const Part& of = world.parts[part];
    const Material& material = world.materials[of.material];
    if (of.shows_light || of.triangle_count == 0 || !emits(material)) continue;
    const bool masked = material.alpha_mode != AlphaMode::opaque &&
                        (material.base_color_texture.used() || !world.colors.empty());
    const int texture = material.emissive_texture.texture;
    const LitTexels& texels = lit.try_emplace(texture, world, texture).first->second;
    EmissiveSurface surface{world,
                            emission,
                            emitting_triangles(world, part, emission, texels),
                            material.double_sided,
                            material.emissive_texture.used() || masked,
                            radius};
    std::vector<ConnectedPiece> pieces = pieces_of(surface);
    surface.most_of_piece = std::min(max_lights_of_curved_piece,
                                     max_lights_of_part / std::max<std::size_t>(1, pieces.size()));
    for (Light& light : pieces.size() > max_lights_of_part ? lights_of_many(surface, pieces)
                                                           : lights_of_few(surface, pieces)) {
      light.name = of.name;
      light.own_part = static_cast<std::int32_t>(part);
      lights.push_back(std::move(light));
    }
  }
  return lights;
}

double mean_irradiance(std::span<const Light> lights, double radius) {
  double sum = 0.0;
  for (const Light& light : lights) sum += power(light);
  return radius > 0.0 ? sum / (4.0 * pi * radius * radius) : 0.0;
}

}  // namespace asos
