#include "renderer/features/feature_edge.h"

#include "renderer/features/deviation.h"
#include "renderer/features/disjoint_sets.h"
#include "renderer/features/release.h"
#include "renderer/features/stoppable_loop.h"
#include "renderer/tasks.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <numeric>
#include <span>
#include <stop_token>
#include <tuple>

namespace asos {
namespace {

// Faces whose dihedral angle differs from 180 degrees by less than this (radians, as the sine) are
// coplanar. A silhouette there would change the picture only by that fraction of the face's size.
constexpr double coplanar_sine = 1e-5;
// Largest number of different-looking triangles with the same three corners that are compared.
constexpr std::size_t most_alternatives = 4;

// Each triangle has three half-edges, so every byte counts.
struct HalfEdge {
  HalfEdge() = default;
  HalfEdge(std::uint32_t to, std::uint32_t corner, std::uint32_t of, bool up)
      : high(to), third(corner), triangle(of & 0x7fffffffu), ascends(up) {}

  std::uint32_t high = 0;  // the end with the higher index; the bucket is the lower one
  std::uint32_t third = 0;
  std::uint32_t triangle : 31 = 0;
  std::uint32_t ascends : 1 = 0;  // the triangle's corners run from the lower end to this one
};

class Extractor {
 public:
  Extractor(const World& world, TextureAt texture_at, const std::stop_token& stop,
            std::span<const std::uint8_t> hidden_sides, std::span<const std::uint32_t> welded)
      : world_(world),
        stop_(stop),
        hidden_sides_(hidden_sides),
        look_(world, texture_at),
        welded_(welded),
        smooth_surfaces_(world.triangles.size()),
        facets_(world.triangles.size()),
        two_sided_(world.triangles.size()) {
    in_parallel(world.triangles.size(), stop,
                [&](std::uint32_t t) { two_sided_[t] = shows_both_sides(world.material_of(t)); });
  }

  ExtractedFeatures run() {
    bucket_half_edges();
    ExtractedFeatures out;
    // In a closed mesh each edge has two halves. Reserved and unused capacity takes no memory.
    out.edges.reserve(half_edges_.size() / 2 + half_edges_.size() / 16);
    for (std::size_t first = 0; first < world_.positions.size();
         first += groups_at_once * group_size)
      classify_groups(first, out);
    release(half_edges_);
    release(bucket_);
    release(two_sided_);
    finish(out);
    return out;
  }

 private:
  using Run = std::span<HalfEdge>;
  using Ends = std::array<SharedCorner, 2>;
  struct Found {
    std::vector<FeatureEdge> edges;
    FeatureCounts counts;
  };
  static constexpr std::size_t group_size = 4096;  // vertices
  static constexpr std::size_t groups_at_once = 64;

  // Classifies some groups of vertices from `first` on, in parallel. The results are stored in the
  // order of the groups, whichever thread found them. All groups together would store all edges
  // twice.
  void classify_groups(std::size_t first, ExtractedFeatures& out) {
    std::array<Found, groups_at_once> found;
    in_tasks(groups_at_once, [&](std::size_t i) {
      check_stop(stop_);
      const std::size_t begin = std::min(first + i * group_size, world_.positions.size());
      const std::size_t end = std::min(begin + group_size, world_.positions.size());
      for (std::size_t low = begin; low < end; ++low)
        classify_edges_of(static_cast<std::uint32_t>(low), found[i]);
    });
    for (const Found& part : found) {
      out.edges.insert(out.edges.end(), part.edges.begin(), part.edges.end());
      out.counts += part.counts;
    }
  }

  void classify_edges_of(std::uint32_t low, Found& found) {
    const auto begin = half_edges_.begin() + bucket_[low];
    const auto end = half_edges_.begin() + bucket_[low + 1];
    std::sort(begin, end, [](const HalfEdge& x, const HalfEdge& y) {
      return std::tie(x.high, x.third, x.triangle) < std::tie(y.high, y.third, y.triangle);
    });
    for (auto run = begin; run != end;) {
      auto next = run;
      while (next != end && next->high == run->high) ++next;
      classify(low, without_repeats(low, {run, next}), found);
      run = next;
    }
  }

  [[nodiscard]] bool degenerate(glm::uvec3 t) const {
    const glm::uvec3 w(welded_[t.x], welded_[t.y], welded_[t.z]);
    if (w.x == w.y || w.y == w.z || w.z == w.x) return true;
    const glm::dvec3 a(world_.positions[w.x]);
    const glm::dvec3 e1 = glm::dvec3(world_.positions[w.y]) - a;
    const glm::dvec3 e2 = glm::dvec3(world_.positions[w.z]) - a;
    return glm::length(glm::cross(e1, e2)) <= 0.0;
  }

  // Sorts all half-edges by their lower welded vertex (counting sort). The order within a vertex
  // depends on the threads; they are sorted later.
  void bucket_half_edges() {
    const std::size_t n = world_.positions.size();
    std::vector<std::uint8_t> bounds_nothing(world_.triangles.size());
    in_parallel(world_.triangles.size(), stop_,
                [&](std::uint32_t t) { bounds_nothing[t] = degenerate(world_.triangles[t]); });
    const auto each = [&](const auto& visit) {
      in_parallel(world_.triangles.size(), stop_, [&](std::uint32_t t) {
        if (bounds_nothing[t]) return;
        for (int k = 0; k < 3; ++k) {
          const std::uint32_t a = welded_[world_.triangles[t][k]];
          const std::uint32_t b = welded_[world_.triangles[t][(k + 1) % 3]];
          const std::uint32_t c = welded_[world_.triangles[t][(k + 2) % 3]];
          visit(std::min(a, b), HalfEdge(std::max(a, b), c, t, a < b));
        }
      });
    };
    const auto next = [](std::uint32_t& counter) {
      return std::atomic_ref(counter).fetch_add(1, std::memory_order_relaxed);
    };
    bucket_.assign(n + 1, 0);
    each([&](std::uint32_t low, const HalfEdge&) { next(bucket_[low + 1]); });
    std::partial_sum(bucket_.begin(), bucket_.end(), bucket_.begin());
    half_edges_.resize(bucket_[n]);
    std::vector<std::uint32_t> cursor(bucket_.begin(), bucket_.end() - 1);
    each([&](std::uint32_t low, const HalfEdge& h) { half_edges_[next(cursor[low])] = h; });
  }

  // Returns the faces at an edge without those that repeat another one's corners and look, as in
  // walls that were modelled twice. A repeated face joins the smooth surface of the original. The
  // order of a run is such that all three edges of a triangle decide alike.
  Run without_repeats(std::uint32_t low, Run faces) {
    std::size_t kept = 0;
    for (const HalfEdge& face : faces) {
      bool repeats = false;
      const std::size_t end = kept > most_alternatives ? kept - most_alternatives : 0;
      for (std::size_t k = kept; !repeats && k > end && faces[k - 1].third == face.third; --k) {
        const std::array<SharedCorner, 3> corners{shared(faces[k - 1], face, low),
                                                  shared(faces[k - 1], face, face.high),
                                                  shared(faces[k - 1], face, face.third)};
        repeats = look_.same(faces[k - 1].triangle, face.triangle, corners);
        if (repeats) repeat(faces[k - 1], face);
      }
      if (!repeats) faces[kept++] = face;
    }
    return faces.first(kept);
  }

  void repeat(const HalfEdge& original, const HalfEdge& copy) {
    smooth_surfaces_.join(original.triangle, copy.triangle);
    facets_.join(original.triangle, copy.triangle);
    // Two single-sided faces back to back are visible from both sides. Every edge of the original
    // meets the copy, so it sets this flag before it reads it.
    if (original.ascends != copy.ascends || two_sided(copy.triangle))
      std::atomic_ref(two_sided_[original.triangle]).store(1, std::memory_order_relaxed);
  }

  [[nodiscard]] bool two_sided(std::uint32_t triangle) {
    return std::atomic_ref(two_sided_[triangle]).load(std::memory_order_relaxed) != 0;
  }

  // Returns whether the edge's two faces are visible from the same sides, where it is no
  // silhouette. Only this depends on winding, since culling does.
  [[nodiscard]] bool same_sides(const HalfEdge& x, const HalfEdge& y) {
    const bool both = two_sided(x.triangle);
    return both == two_sided(y.triangle) && (both || x.ascends != y.ascends);
  }

  // Classifies the faces at one edge of the welded mesh.
  void classify(std::uint32_t low, Run faces, Found& found) {
    const bool hidden = cut_out(low, faces);
    FeatureEdge edge;
    edge.a = low;
    edge.b = faces[0].high;
    edge.left = faces[0].third;
    // Store triangles until finish() knows their smooth surfaces.
    edge.left_surface = faces[0].triangle;
    if (faces.size() > 1) edge.right_surface = faces[1].triangle;
    if (faces.size() != 2) {
      if (hidden) return;
      edge.kind = FeatureKind::open;
      ++found.counts.open;
      found.edges.push_back(edge);
      return;
    }
    edge.right = faces[1].third;
    edge.folds = !coplanar(edge);
    const std::uint32_t x = faces[0].triangle, y = faces[1].triangle;
    const Ends ends{shared(faces[0], faces[1], edge.a), shared(faces[0], faces[1], edge.b)};
    if (!same_sides(faces[0], faces[1]) || look_.seam(x, y, ends)) {
      if (hidden) return;
      edge.kind = FeatureKind::seam;
      ++found.counts.seam;
    } else if (look_.crease(x, y, ends)) {
      if (hidden) return;
      edge.kind = FeatureKind::crease;
      ++found.counts.crease;
    } else {
      smooth_surfaces_.join(x, y);
      if (!edge.folds) {
        facets_.join(x, y);
        return;
      }
      if (hidden) return;
      edge.kind = FeatureKind::silhouette;
      ++found.counts.silhouette_candidates;
    }
    found.edges.push_back(edge);
  }

  // Returns whether textures cut all of an edge's faces out along the whole edge.
  [[nodiscard]] bool cut_out(std::uint32_t low, Run faces) const {
    if (hidden_sides_.empty()) return false;
    return std::all_of(faces.begin(), faces.end(), [&](const HalfEdge& face) {
      const int i = corner(face.triangle, low), j = corner(face.triangle, face.high);
      const int side = j == (i + 1) % 3 ? i : j;
      return (hidden_sides_[face.triangle] >> side & 1) != 0;
    });
  }

  // Returns whether both faces are in one plane, on different sides of the edge. A face folded back
  // onto the other is excluded, since its edge is an outline from everywhere.
  [[nodiscard]] bool coplanar(const FeatureEdge& edge) const {
    const glm::dvec3 a(world_.positions[edge.a]);
    const glm::dvec3 along = glm::normalize(glm::dvec3(world_.positions[edge.b]) - a);
    glm::dvec3 l = glm::dvec3(world_.positions[edge.left]) - a;
    glm::dvec3 r = glm::dvec3(world_.positions[edge.right]) - a;
    l = glm::normalize(l - along * glm::dot(l, along));
    r = glm::normalize(r - along * glm::dot(r, along));
    return glm::dot(l, r) < 0.0 && glm::length(glm::cross(l, r)) < coplanar_sine;
  }

  // Returns the corner of a triangle at the welded vertex `v`.
  [[nodiscard]] int corner(std::uint32_t triangle, std::uint32_t v) const {
    const glm::uvec3 t = world_.triangles[triangle];
    return welded_[t.x] == v ? 0 : welded_[t.y] == v ? 1 : 2;
  }
  [[nodiscard]] SharedCorner shared(const HalfEdge& x, const HalfEdge& y, std::uint32_t v) const {
    return {corner(x.triangle, v), corner(y.triangle, v)};
  }

  void finish(ExtractedFeatures& out) {
    out.deviation_of_triangle = deviations(world_, facets_, out.edges, stop_);
    out.surface_of_triangle.resize(world_.triangles.size());
    in_parallel(world_.triangles.size(), stop_,
                [&](std::uint32_t t) { out.surface_of_triangle[t] = smooth_surfaces_.find(t); });
    in_parallel(out.edges.size(), stop_, [&](std::uint32_t i) {
      for (std::uint32_t* smooth_surface :
           {&out.edges[i].left_surface, &out.edges[i].right_surface})
        if (*smooth_surface != FeatureEdge::none)
          *smooth_surface = out.surface_of_triangle[*smooth_surface];
    });
  }

  const World& world_;
  std::stop_token stop_;
  std::span<const std::uint8_t> hidden_sides_;
  SurfaceLook look_;
  std::span<const std::uint32_t> welded_;  // see welded_vertices
  DisjointSets smooth_surfaces_;
  DisjointSets facets_;                  // coplanar triangles, joined smoothly
  std::vector<std::uint8_t> two_sided_;  // 1: triangles whose back is visible, too
  std::vector<std::uint32_t> bucket_;    // first half-edge of each vertex
  std::vector<HalfEdge> half_edges_;
};

}  // namespace

FeatureCounts& FeatureCounts::operator+=(const FeatureCounts& other) {
  open += other.open;
  silhouette_candidates += other.silhouette_candidates;
  crease += other.crease;
  seam += other.seam;
  intersection += other.intersection;
  cut_out += other.cut_out;
  return *this;
}

ExtractedFeatures extract_features(const World& world, std::span<const std::uint32_t> welded,
                                   TextureAt texture_at, const std::stop_token& stop,
                                   std::span<const std::uint8_t> hidden_sides) {
  return Extractor(world, texture_at, stop, hidden_sides, welded).run();
}

}  // namespace asos
