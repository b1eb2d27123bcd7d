#include "ui/split_pixel.h"

#include "renderer/asos/pixel_trace.h"
#include "renderer/sampling/random.h"
#include "ui/previewer.h"

#include <algorithm>
#include <chrono>
#include <limits>

namespace asos {

namespace {

constexpr std::size_t most_traced = 3000;
constexpr auto longest_search = std::chrono::seconds(3);

bool bounded(SplitCause cause) {
  return cause == SplitCause::outline || cause == SplitCause::crease ||
         cause == SplitCause::intersection;
}

// Shadows and mirrors have pyrays of their own: what bounds an object splits the pixel itself, and
// what is not resolved at MAX has split it all the way.
int rank_of(const Film& film, std::size_t i) {
  if (film.split_level[i] == 0) return 0;
  const SplitCause cause = film.cause[i];
  const int sort = cause == SplitCause::depth_limit ? 2 : (bounded(cause) ? 1 : 0);
  return film.split_level[i] + 256 * sort;
}

// Some of those that bounds of objects split, from all over the picture.
std::vector<glm::ivec2> candidates(const Film& film) {
  std::vector<glm::ivec2> pixels;
  for (int y = 0; y < film.height; ++y) {
    for (int x = 0; x < film.width; ++x) {
      const std::size_t i = film.index(x, y);
      // What one edge cuts is of level 1.
      if (film.split_level[i] > 1 &&
          (bounded(film.cause[i]) || film.cause[i] == SplitCause::depth_limit))
        pixels.emplace_back(x, y);
    }
  }
  const auto key = [](glm::ivec2 p) { return pixel_random(p.x, p.y, 0); };
  std::sort(pixels.begin(), pixels.end(),
            [&](glm::ivec2 a, glm::ivec2 b) { return key(a) < key(b); });
  pixels.resize(std::min(pixels.size(), most_traced));
  if (const std::optional<glm::ivec2> first = most_split_pixel(film))
    pixels.insert(pixels.begin(), *first);
  return pixels;
}

// How much there is to see: cells that were split, and how far apart their colours are. 0 to 1.
double interest(const PixelTrace& trace) {
  constexpr std::ptrdiff_t many = 6;
  const auto split =
      std::count_if(trace.cells.begin(), trace.cells.end(),
                    [](const TracedCell& cell) { return cell.fate == CellFate::split; });
  float darkest = std::numeric_limits<float>::max(), brightest = 0.0f;
  for (const TracedCell& cell : trace.cells) {
    for (const TracedSample& sample : cell.samples) {
      const float green = std::clamp(sample.radiance.g, 0.0f, 1.0f);
      darkest = std::min(darkest, green);
      brightest = std::max(brightest, green);
    }
  }
  const double contrast = std::min(1.0, 3.0 * std::max(0.0, 1.0 * brightest - darkest));
  return static_cast<double>(std::min(split, many)) / many * (0.4 + 0.6 * contrast);
}

}  // namespace

std::optional<glm::ivec2> most_split_pixel(const Film& film) {
  std::optional<glm::ivec2> best;
  int most = 0;
  double nearest = 0.0;
  const glm::dvec2 middle = 0.5 * glm::dvec2(film.width, film.height);
  for (int y = 0; y < film.height; ++y) {
    for (int x = 0; x < film.width; ++x) {
      const int rank = rank_of(film, film.index(x, y));
      if (rank == 0 || rank < most) continue;
      const double away = glm::distance(glm::dvec2(x + 0.5, y + 0.5), middle);
      if (rank == most && away >= nearest) continue;
      best = glm::ivec2(x, y);
      most = rank;
      nearest = away;
    }
  }
  return best;
}

SplitPixelSearch::SplitPixelSearch()
    : job_([this](const Request& request) { return work(request); }, {}, Overtaken::kept) {}

std::optional<glm::ivec2> SplitPixelSearch::update(const Previewer& previewer, bool wanted) {
  if (std::optional<Found> found = job_.take_outcome()) found_ = *found;
  const PreviewRender& render = previewer.render();
  const std::uint64_t now = render.restarts();
  current_ = now;
  if (!previewer.scene() || !render.progress().finished) return std::nullopt;
  if (found_.restarts == now) return found_.pixel;
  if (!wanted || asked_ == now || !previewer.scene()->geometry->boundaries.known())
    return std::nullopt;
  asked_ = now;
  job_.ask({previewer.scene().shared(), previewer.viewpoint().camera().camera(), render.settings(),
            candidates(render.film()), now});
  return std::nullopt;
}

SplitPixelSearch::Found SplitPixelSearch::work(const Request& request) const {
  const RenderSettings& settings = request.settings;
  const View view(request.camera, settings.width, settings.height,
                  radius_around_origin(request.scene->world().bounds));
  Found found{std::nullopt, request.restarts};
  double most = 0.0;
  const auto start = std::chrono::steady_clock::now();
  for (const glm::ivec2 pixel : request.candidates) {
    if (pixel.x >= settings.width || pixel.y >= settings.height) continue;
    constexpr double enough = 0.5;
    const double seen = interest(trace_pixel(*request.scene, view, settings, pixel.x, pixel.y));
    if (seen > most) found.pixel = pixel;
    most = std::max(most, seen);
    if (most > enough || current_ != request.restarts ||
        std::chrono::steady_clock::now() - start > longest_search)
      break;
  }
  return found;
}

}  // namespace asos
