#include "ui/split_pixel.h"

#include "renderer/asos/pixel_trace.h"
#include "renderer/film/film.h"
#include "renderer/sampling/random.h"
#include "renderer/session/thread_seconds.h"
#include "ui/previewer.h"
#include "ui/snapshot_view.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace asos::ui {

namespace {

constexpr std::size_t most_traced = 3000;

bool bounded(SplitCause cause) {
  return cause == SplitCause::outline || cause == SplitCause::crease ||
         cause == SplitCause::intersection;
}

// Ranks a pixel for showing how splitting works. Shadows and mirrors have pyrays of their own, so
// pixels split by an object's edge come first, and those unresolved at MAX before all others.
// Sampled pixels come last.
int rank_of(const Film& film, std::size_t i) {
  if (!film.unfinished.empty() && film.unfinished[i] != 0) return 0;
  const SplitCause cause = film.cause[i];
  if (film.split_level[i] == 0 && !bounded(cause)) return cause == SplitCause::none ? 0 : 1;
  const int sort = cause == SplitCause::depth_limit ? 2 : (bounded(cause) ? 1 : 0);
  return 2 * film.split_level[i] + 512 * sort;
}

// Range of the green display bytes in a pixel's 3 x 3 neighbourhood, 0 to 255.
int contrast_around(const Film& film, glm::ivec2 pixel) {
  int darkest = 255, brightest = 0;
  for (int y = std::max(0, pixel.y - 1); y <= std::min(film.height - 1, pixel.y + 1); ++y) {
    for (int x = std::max(0, pixel.x - 1); x <= std::min(film.width - 1, pixel.x + 1); ++x) {
      const int green = display_bytes(film.radiance[film.index(x, y)], 0.0f).y;
      darkest = std::min(darkest, green);
      brightest = std::max(brightest, green);
    }
  }
  return brightest - darkest;
}

int apart(glm::u8vec3 a, glm::u8vec3 b) {
  const glm::ivec3 d = glm::abs(glm::ivec3(a) - glm::ivec3(b));
  return std::max({d.x, d.y, d.z});
}

constexpr int edge_reach = 2;  // pixels to each side of an edge

// Difference of the plain colours on both sides of a pixel, in visible steps; 0 if it is small, or
// if a side is not of one colour. `shown(pixel)`: display bytes.
template <typename Shown>
int clearness(const Shown& shown, glm::ivec2 pixel) {
  constexpr int least = 64, most = 128, step = 32, plain = 12;  // bytes
  int clearest = 0;
  for (const glm::ivec2 way : {glm::ivec2(1, 0), glm::ivec2(0, 1), glm::ivec2(1, 1), {1, -1}}) {
    const auto at = [&](int n) { return shown(pixel + n * way); };
    if (apart(at(-2), at(-1)) > plain || apart(at(1), at(2)) > plain) continue;
    const int across = apart(at(-1), at(1));
    const bool between = apart(at(0), at(-1)) > plain && apart(at(0), at(1)) > plain;
    if (across >= least && between) clearest = std::max(clearest, std::min(across, most) / step);
  }
  return clearest;
}

// Returns whether a final pixel was split by an object's edge.
bool split_by_edge(const Film& film, std::size_t i) {
  const bool is_final = film.unfinished.empty() || film.unfinished[i] == 0;
  return is_final && film.split_level[i] > 0 && bounded(film.cause[i]);
}

struct Candidate {
  glm::ivec2 pixel;
  int contrast;  // to its neighbours, in visible steps
};

// Pixels that may have been split themselves, from the whole picture, highest contrast first. Many
// of them are only cut by an edge, or by a shadow's edge.
std::vector<glm::ivec2> candidates(const Film& film) {
  constexpr int contrast_step = 48;
  std::vector<Candidate> found;
  for (int y = 0; y < film.height; ++y) {
    for (int x = 0; x < film.width; ++x) {
      const std::size_t i = film.index(x, y);
      // A mirror splits the reflected pyray, not the pixel.
      if (film.split_level[i] > 0 && film.cause[i] != SplitCause::reflection)
        found.push_back({{x, y}, contrast_around(film, {x, y}) / contrast_step});
    }
  }
  const auto key = [](const Candidate& c) {
    return std::pair(-c.contrast, pixel_random(c.pixel.x, c.pixel.y, 0));
  };
  std::sort(found.begin(), found.end(),
            [&](const Candidate& a, const Candidate& b) { return key(a) < key(b); });
  found.resize(std::min(found.size(), most_traced));
  std::vector<glm::ivec2> pixels;
  for (const Candidate& candidate : found) pixels.push_back(candidate.pixel);
  if (const std::optional<glm::ivec2> most = most_split_pixel(film)) pixels.push_back(*most);
  return pixels;
}

// Every split cell has four children in the list.
std::size_t splits(const PixelTrace& trace) {
  return trace.cells.size() / 4;
}

int deepest(const PixelTrace& trace) {
  int level = 0;
  for (const TracedCell& cell : trace.cells) level = std::max(level, cell.level);
  return level;
}

// Returns how much a pixel shows, 0 to 1: by the number of split cells (without any: of parts that
// edges cut off) and the contrast of their colours.
double interest(const PixelTrace& trace) {
  std::size_t samples = 0;
  int darkest = 255, brightest = 0;
  for (const TracedCell& cell : trace.cells) {
    samples += cell.samples.size();
    for (const TracedSample& sample : cell.samples) {
      const int green = display_bytes(sample.radiance, 0.0f).y;
      darkest = std::min(darkest, green);
      brightest = std::max(brightest, green);
    }
  }
  constexpr double clear = 100.0;  // bytes
  const double contrast = std::clamp((brightest - darkest) / clear, 0.0, 1.0);
  const auto share_of = [](std::size_t count, std::size_t many) {
    return static_cast<double>(std::min(count, many)) / static_cast<double>(many);
  };
  constexpr double as_nothing = 0.02;  // weight compared with split pixels
  if (splits(trace) == 0) return as_nothing * share_of(samples, 4) * contrast;
  // A single level of quarters does not show that parts are split again.
  constexpr double of_one_level = 0.4;
  const double depth = deepest(trace) > 1 ? 1.0 : of_one_level;
  return depth * share_of(splits(trace), 6) * (0.2 + 0.8 * contrast);
}

}  // namespace

std::optional<glm::ivec2> clear_edge_pixel(const Film& film, const DisplayTransform& display,
                                           ClearEdge which) {
  constexpr int reach = edge_reach;
  if (film.width <= 2 * reach || film.height <= 2 * reach) return std::nullopt;
  std::vector<glm::u8vec3> bytes(film.radiance.size());
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = display_bytes(film, i, display);
  const auto shown = [&](glm::ivec2 p) { return bytes[film.index(p.x, p.y)]; };
  std::optional<glm::ivec2> best;
  int clearest = 0;
  double nearest = 0.0;
  const glm::dvec2 middle = 0.5 * glm::dvec2(film.width, film.height);
  for (int y = reach; y < film.height - reach; ++y) {
    for (int x = reach; x < film.width - reach; ++x) {
      if (which == ClearEdge::split && !split_by_edge(film, film.index(x, y))) continue;
      const int clear = clearness(shown, {x, y});
      const double away = glm::distance(glm::dvec2(x + 0.5, y + 0.5), middle);
      if (clear == 0 || clear < clearest || (clear == clearest && away >= nearest)) continue;
      best = glm::ivec2(x, y);
      clearest = clear;
      nearest = away;
    }
  }
  return best;
}

bool on_clear_edge(const Film& film, glm::ivec2 pixel, const DisplayTransform& display) {
  const glm::ivec2 lo(edge_reach), hi = glm::ivec2(film.width, film.height) - edge_reach;
  if (glm::any(glm::lessThan(pixel, lo)) || glm::any(glm::greaterThanEqual(pixel, hi)))
    return false;
  const auto shown = [&](glm::ivec2 p) {
    return display_bytes(film, film.index(p.x, p.y), display);
  };
  return clearness(shown, pixel) > 0;
}

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

SplitPixelSearch::Answer SplitPixelSearch::update(const Previewer& previewer, bool wanted) {
  if (std::optional<Found> found = job_.take_outcome()) found_ = *found;
  const PreviewRender& render = previewer.render();
  const std::uint64_t now = render.restarts();
  current_ = now;
  if (!previewer.scene() || !render.progress().finished) return {};
  if (found_.restarts == now) return {found_.pixel, !found_.split};
  if (!wanted || asked_ == now || !previewer.scene()->geometry->boundaries.known_or_started())
    return {};
  asked_ = now;
  job_.ask({render.snapshot(), candidates(render.film()), now});
  return {};
}

SplitPixelSearch::Found SplitPixelSearch::work(const Request& request) const {
  const Snapshot& picture = request.picture;
  const View view = view_of(picture);
  Found found{std::nullopt, false, request.restarts};
  double most = 0.0;
  const double start = thread_seconds(),
               most_seconds = std::chrono::duration<double>(longest).count();
  for (const glm::ivec2 pixel : request.candidates) {
    constexpr double enough = 0.5;
    const PixelTrace trace = trace_pixel(*picture.scene, view, picture.settings, pixel.x, pixel.y);
    const double seen = interest(trace);
    if (seen > most) {
      most = seen;
      found.pixel = pixel;
      found.split = splits(trace) > 0;
    }
    if (most > enough || current_ != request.restarts || thread_seconds() - start > most_seconds)
      break;
  }
  return found;
}

}  // namespace asos::ui
