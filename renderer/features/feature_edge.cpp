#include "renderer/features/feature_edge.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

namespace asos {
namespace {

// Faces whose dihedral angle differs from 180 degrees by less than this (radians, as the sine) are
// coplanar: a silhouette there would shift the picture by that share of the face's size only.
constexpr double coplanar_sine = 1e-5;
// Shading normals further apart than this (0.2 degrees) change a display intensity visibly.
constexpr float crease_cosine = 0.999994f;
constexpr float colour_step = 1.0f / 512.0f;
constexpr float texcoord_step = 1e-4f;

struct HalfEdge {
  std::uint32_t high = 0;  // the end with the higher index; the lower one is the bucket
  std::uint32_t third = 0;
  std::uint32_t triangle = 0;
};

std::uint64_t mix(std::uint64_t x) {
  x ^= x >> 33;
  x *= 0xff51afd7ed558ccdULL;
  x ^= x >> 33;
  x *= 0xc4ceb9fe1a85ec53ULL;
  return x ^ (x >> 33);
}

// For each vertex the first vertex at the same place. Open addressing, keyed by the coordinates'
// bits; adding zero makes -0 equal 0.
std::vector<std::uint32_t> weld(const std::vector<glm::vec3>& positions) {
  const std::size_t n = positions.size();
  std::vector<std::uint32_t> first(n);
  const std::size_t slots = std::bit_ceil(2 * n + 1);
  std::vector<std::uint32_t> table(slots, FeatureEdge::none);
  for (std::uint32_t i = 0; i < n; ++i) {
    const glm::vec3 p = positions[i] + 0.0f;
    const std::uint64_t xy = std::bit_cast<std::uint32_t>(p.x) |
                             (std::uint64_t{std::bit_cast<std::uint32_t>(p.y)} << 32);
    std::size_t slot =
        mix(xy ^ mix(std::bit_cast<std::uint32_t>(p.z) + 0x9e3779b97f4a7c15ULL)) & (slots - 1);
    while (table[slot] != FeatureEdge::none && positions[table[slot]] != positions[i])
      slot = (slot + 1) & (slots - 1);
    if (table[slot] == FeatureEdge::none) table[slot] = i;
    first[i] = table[slot];
  }
  return first;
}

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  std::uint32_t find(std::uint32_t x) {
    while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
    return x;
  }
  // The lower index stays the representative, so that the result does not depend on the order.
  void join(std::uint32_t x, std::uint32_t y) {
    x = find(x), y = find(y);
    if (x < y) parent_[y] = x;
    if (y < x) parent_[x] = y;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

class Extractor {
 public:
  explicit Extractor(const World& world)
      : world_(world), welded_(weld(world.positions)), sheets_(world.triangles.size()) {
    find_used_attributes();
  }

  ExtractedFeatures run() {
    bucket_half_edges();
    for (std::uint32_t low = 0; low < world_.positions.size(); ++low) {
      const auto begin = half_edges_.begin() + bucket_[low];
      const auto end = half_edges_.begin() + bucket_[low + 1];
      std::sort(begin, end, [](const HalfEdge& x, const HalfEdge& y) {
        return x.high != y.high ? x.high < y.high : x.triangle < y.triangle;
      });
      for (auto run = begin; run != end;) {
        auto next = run;
        while (next != end && next->high == run->high) ++next;
        classify(low, {run, next});
        run = next;
      }
    }
    return finish();
  }

 private:
  using Run = std::span<const HalfEdge>;

  [[nodiscard]] bool degenerate(glm::uvec3 t) const {
    const glm::uvec3 w(welded_[t.x], welded_[t.y], welded_[t.z]);
    if (w.x == w.y || w.y == w.z || w.z == w.x) return true;
    const glm::dvec3 a(world_.positions[w.x]);
    const glm::dvec3 e1 = glm::dvec3(world_.positions[w.y]) - a;
    const glm::dvec3 e2 = glm::dvec3(world_.positions[w.z]) - a;
    return glm::length(glm::cross(e1, e2)) <= 0.0;
  }

  void find_used_attributes() {
    uses_texcoord_.resize(world_.materials.size());
    for (std::size_t m = 0; m < world_.materials.size(); ++m) {
      const Material& material = world_.materials[m];
      for (const TextureUse* use :
           {&material.base_color_texture, &material.metallic_roughness_texture,
            &material.normal_texture, &material.emissive_texture})
        if (use->used()) uses_texcoord_[m] |= static_cast<std::uint8_t>(1 << use->texcoord);
    }
  }

  // Counting sort of all half-edges by their lower welded vertex.
  void bucket_half_edges() {
    const std::size_t n = world_.positions.size();
    bucket_.assign(n + 1, 0);
    const auto each = [&](auto&& visit) {
      for (std::uint32_t t = 0; t < world_.triangles.size(); ++t) {
        if (degenerate(world_.triangles[t])) continue;
        for (int k = 0; k < 3; ++k) {
          const std::uint32_t a = welded_[world_.triangles[t][k]];
          const std::uint32_t b = welded_[world_.triangles[t][(k + 1) % 3]];
          const std::uint32_t c = welded_[world_.triangles[t][(k + 2) % 3]];
          visit(std::min(a, b), HalfEdge{std::max(a, b), c, t});
        }
      }
    };
    each([&](std::uint32_t low, const HalfEdge&) { ++bucket_[low + 1]; });
    std::partial_sum(bucket_.begin(), bucket_.end(), bucket_.begin());
    half_edges_.resize(bucket_[n]);
    std::vector<std::uint32_t> cursor(bucket_.begin(), bucket_.end() - 1);
    each([&](std::uint32_t low, const HalfEdge& h) { half_edges_[cursor[low]++] = h; });
  }

  // All the faces at one edge of the welded mesh.
  void classify(std::uint32_t low, Run faces) {
    FeatureEdge edge;
    edge.a = low;
    edge.b = faces[0].high;
    edge.left = faces[0].third;
    if (faces.size() != 2) {
      edge.kind = FeatureKind::open;
      ++counts_.open;
      edges_.push_back(edge);
      return;
    }
    edge.right = faces[1].third;
    edge.folds = !coplanar(edge);
    if (seam(edge, faces)) {
      edge.kind = FeatureKind::seam;
      ++counts_.seam;
    } else if (crease(edge, faces)) {
      edge.kind = FeatureKind::crease;
      ++counts_.crease;
    } else {
      sheets_.join(faces[0].triangle, faces[1].triangle);
      if (!edge.folds) return;
      edge.kind = FeatureKind::silhouette;
      ++counts_.silhouette_candidates;
    }
    edges_.push_back(edge);
  }

  // Both faces in one plane, on different sides of the edge (a face folded back onto the other is
  // an outline from everywhere, and is not meant).
  [[nodiscard]] bool coplanar(const FeatureEdge& edge) const {
    const glm::dvec3 a(world_.positions[edge.a]);
    const glm::dvec3 along = glm::normalize(glm::dvec3(world_.positions[edge.b]) - a);
    glm::dvec3 l = glm::dvec3(world_.positions[edge.left]) - a;
    glm::dvec3 r = glm::dvec3(world_.positions[edge.right]) - a;
    l = glm::normalize(l - along * glm::dot(l, along));
    r = glm::normalize(r - along * glm::dot(r, along));
    return glm::dot(l, r) < 0.0 && glm::length(glm::cross(l, r)) < coplanar_sine;
  }

  // The triangle's own vertex at the welded vertex `v`.
  [[nodiscard]] std::uint32_t corner(std::uint32_t triangle, std::uint32_t v) const {
    const glm::uvec3 t = world_.triangles[triangle];
    return welded_[t.x] == v ? t.x : welded_[t.y] == v ? t.y : t.z;
  }

  // Whether `differs` holds for the two faces' own vertices at either end of the edge.
  template <typename Differs>
  [[nodiscard]] bool across(const FeatureEdge& edge, Run faces, Differs&& differs) const {
    for (const std::uint32_t end : {edge.a, edge.b}) {
      const std::uint32_t x = corner(faces[0].triangle, end);
      const std::uint32_t y = corner(faces[1].triangle, end);
      if (x != y && differs(x, y)) return true;
    }
    return false;
  }

  [[nodiscard]] bool seam(const FeatureEdge& edge, Run faces) const {
    const std::uint32_t m = material(faces[0]);
    if (m != material(faces[1])) return true;
    for (int set = 0; set < 2; ++set) {
      const auto& uv = world_.texcoords[set];
      if (!(uses_texcoord_[m] & (1 << set)) || uv.empty()) continue;
      if (across(edge, faces, [&](std::uint32_t x, std::uint32_t y) {
            const glm::vec2 d = glm::abs(uv[x] - uv[y]);
            return !(d.x <= texcoord_step && d.y <= texcoord_step);
          }))
        return true;
    }
    return false;
  }

  [[nodiscard]] bool crease(const FeatureEdge& edge, Run faces) const {
    if (!world_.materials[material(faces[0])].unlit &&
        across(edge, faces, [&](std::uint32_t x, std::uint32_t y) {
          // Neighbours wound in opposite senses may carry opposite normals; shading turns both
          // towards the viewer, so the sign says nothing.
          return !(std::abs(glm::dot(world_.normals[x], world_.normals[y])) > crease_cosine);
        }))
      return true;
    return !world_.colors.empty() && across(edge, faces, [&](std::uint32_t x, std::uint32_t y) {
      const glm::vec4 d = glm::abs(world_.colors[x] - world_.colors[y]);
      return std::max({d.x, d.y, d.z, d.w}) > colour_step;
    });
  }

  [[nodiscard]] std::uint32_t material(const HalfEdge& h) const {
    return world_.parts[world_.triangle_part[h.triangle]].material;
  }

  ExtractedFeatures finish() {
    ExtractedFeatures out;
    out.sheet_of_triangle.resize(world_.triangles.size());
    for (std::uint32_t t = 0; t < world_.triangles.size(); ++t)
      out.sheet_of_triangle[t] = sheets_.find(t);
    out.edges = std::move(edges_);
    out.counts = counts_;
    return out;
  }

  const World& world_;
  std::vector<std::uint32_t> welded_;
  DisjointSets sheets_;
  std::vector<std::uint8_t> uses_texcoord_;  // bits: sets that a material's textures use
  std::vector<std::uint32_t> bucket_;        // first half-edge of each vertex
  std::vector<HalfEdge> half_edges_;
  std::vector<FeatureEdge> edges_;
  FeatureCounts counts_;
};

}  // namespace

ExtractedFeatures extract_features(const World& world) {
  return Extractor(world).run();
}

}  // namespace asos
