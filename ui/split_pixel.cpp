#include "ui/split_pixel.h"

#include "renderer/asos/pixel_trace.h"
#include "ui/previewer.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <limits>

namespace asos {

namespace {

constexpr glm::ivec2 parts{8, 6};
constexpr auto longest_look = std::chrono::milliseconds(40);

struct Candidate {
  int rank = 0;
  double away = 0.0;  // from the picture's middle
  glm::ivec2 pixel{0};
  float rays = 0.0f;
  [[nodiscard]] bool before(const Candidate& other) const {
    return rank != other.rank ? rank > other.rank : away < other.away;
  }
};

// Of a part of the picture.
struct Best {
  Candidate first;    // before all others
  Candidate dearest;  // of those of the same rank
  void take(const Candidate& candidate) {
    if (candidate.before(first)) first = candidate;
    if (candidate.rank > dearest.rank ||
        (candidate.rank == dearest.rank && candidate.rays > dearest.rays))
      dearest = candidate;
  }
};

// Shadows and mirrors have pyrays of their own: what bounds an object splits the pixel itself, and
// what is not resolved at MAX has split it all the way.
int rank_of(const Film& film, std::size_t i) {
  if (film.split_level[i] == 0) return 0;
  const SplitCause cause = film.cause[i];
  const bool bounded = cause == SplitCause::outline || cause == SplitCause::crease ||
                       cause == SplitCause::intersection;
  const int sort = cause == SplitCause::depth_limit ? 2 : (bounded ? 1 : 0);
  return film.split_level[i] + 256 * sort;
}

// How much there is to see: cells that were split, and how far apart their colours are.
double interest(const PixelTrace& trace) {
  constexpr std::ptrdiff_t many = 8;
  const auto split =
      std::count_if(trace.cells.begin(), trace.cells.end(),
                    [](const TracedCell& cell) { return cell.fate == CellFate::split; });
  float darkest = std::numeric_limits<float>::max(), brightest = 0.0f;
  for (const TracedCell& cell : trace.cells) {
    for (const TracedSample& sample : cell.samples) {
      const glm::vec3 c = glm::clamp(sample.radiance, 0.0f, 1.0f);
      darkest = std::min(darkest, c.g);
      brightest = std::max(brightest, c.g);
    }
  }
  const double contrast = static_cast<double>(std::max(0.0f, brightest - darkest));
  return static_cast<double>(std::min(split, many)) * (0.2 + contrast);
}

}  // namespace

std::vector<glm::ivec2> split_pixels(const Film& film) {
  std::array<Best, static_cast<std::size_t>(parts.x) * parts.y> best;
  const glm::dvec2 middle = 0.5 * glm::dvec2(film.width, film.height);
  for (int y = 0; y < film.height; ++y) {
    for (int x = 0; x < film.width; ++x) {
      const std::size_t i = film.index(x, y);
      const int rank = rank_of(film, i);
      if (rank == 0) continue;
      const int part = x * parts.x / film.width + y * parts.y / film.height * parts.x;
      best[static_cast<std::size_t>(part)].take(
          {rank, glm::distance(glm::dvec2(x + 0.5, y + 0.5), middle), {x, y}, film.rays[i]});
    }
  }
  std::vector<Candidate> all;
  for (const Best& part : best) {
    if (part.first.rank > 0) all.push_back(part.first);
    if (part.dearest.rank > 0 && part.dearest.pixel != part.first.pixel)
      all.push_back(part.dearest);
  }
  std::sort(all.begin(), all.end(),
            [](const Candidate& a, const Candidate& b) { return a.before(b); });
  std::vector<glm::ivec2> pixels;
  for (const Candidate& candidate : all) pixels.push_back(candidate.pixel);
  return pixels;
}

std::optional<glm::ivec2> most_split_pixel(const Film& film) {
  const std::vector<glm::ivec2> pixels = split_pixels(film);
  return pixels.empty() ? std::nullopt : std::optional(pixels.front());
}

std::optional<glm::ivec2> pixel_that_splits(const Previewer& previewer) {
  const PreviewRender& render = previewer.render();
  const std::vector<glm::ivec2> pixels = split_pixels(render.film());
  if (pixels.empty() || !previewer.scene()) return std::nullopt;
  const RenderScene& scene = *previewer.scene().get();
  if (!scene.geometry->boundaries.known()) return pixels.front();
  const RenderSettings& settings = render.settings();
  const View view(previewer.viewpoint().camera().camera(), settings.width, settings.height,
                  radius_around_origin(scene.world().bounds));
  glm::ivec2 best = pixels.front();
  double most = 0.0;
  const auto start = std::chrono::steady_clock::now();
  for (const glm::ivec2 pixel : pixels) {
    if (pixel.x >= settings.width || pixel.y >= settings.height) continue;
    const double seen = interest(trace_pixel(scene, view, settings, pixel.x, pixel.y));
    if (seen > most) best = pixel;
    most = std::max(most, seen);
    if (std::chrono::steady_clock::now() - start > longest_look) break;
  }
  return best;
}

}  // namespace asos
