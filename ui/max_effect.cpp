#include "ui/max_effect.h"

#include "renderer/comparison/method.h"
#include "ui/frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace asos::ui {

namespace {

constexpr float steps_of_white = 255.0f;
constexpr int least_apart = 24;  // of two marked pixels

/// A pixel with the number by which it is ranked.
struct Ranked {
  float rank = 0.0f;
  glm::ivec2 at{0};
};

bool is_final(const Film& film, std::size_t i) {
  return film.unfinished.empty() || !film.unfinished[i];
}

// Takes the best pixels that are not close to each other.
std::vector<glm::ivec2> spaced(std::vector<Ranked> all) {
  std::stable_sort(all.begin(), all.end(),
                   [](const Ranked& a, const Ranked& b) { return a.rank > b.rank; });
  std::vector<glm::ivec2> chosen;
  for (const Ranked& candidate : all) {
    const bool close = std::any_of(chosen.begin(), chosen.end(), [&](glm::ivec2 other) {
      const glm::ivec2 apart = glm::abs(other - candidate.at);
      return std::max(apart.x, apart.y) < least_apart;
    });
    if (!close) chosen.push_back(candidate.at);
    if (chosen.size() == MaxEffect::most_worst) break;
  }
  return chosen;
}

float contrast(const Film& film, glm::ivec2 at, const DisplayTransform& display) {
  const glm::vec3 own = film.radiance[film.index(at.x, at.y)];
  float most = 0.0f;
  for (int y = std::max(0, at.y - 1); y <= std::min(film.height - 1, at.y + 1); ++y)
    for (int x = std::max(0, at.x - 1); x <= std::min(film.width - 1, at.x + 1); ++x)
      most = std::max(most, difference_of(own, film.radiance[film.index(x, y)], display));
  return most;
}

// Whether the pictures differ in MAX alone.
bool differs_in_max(const RenderSettings& a, const RenderSettings& b) {
  RenderSettings same = a;
  same.asos.max_level = b.asos.max_level;
  return a.asos.max_level != b.asos.max_level && same == b;
}

}  // namespace

MaxEffect max_effect(const PreviewRender& render, const DisplayTransform& display) {
  const Film& film = render.film();
  const PreviewRender::FinishedPicture* before = render.finished_before();
  const bool compares = before && render.progress().finished &&
                        differs_in_max(before->settings, render.settings()) &&
                        before->film.width == film.width && before->film.height == film.height;
  MaxEffect effect;
  effect.finished = render.progress().finished;
  if (compares)
    effect.change = {before->settings.asos.max_level, render.settings().asos.max_level, 0, 0.0f};
  std::vector<Ranked> ranked;
  for (int y = 0; y < film.height; ++y) {
    for (int x = 0; x < film.width; ++x) {
      const std::size_t i = film.index(x, y);
      if (!is_final(film, i)) continue;
      ++effect.pixels;
      const bool ended = film.cause[i] == SplitCause::depth_limit;
      if (ended) {
        ++effect.ended_pixels;
        add_pixel(effect.ended, x, y);
      }
      if (!compares) {
        if (ended) ranked.push_back({contrast(film, {x, y}, display), {x, y}});
        continue;
      }
      const float steps = steps_of_white * difference_of(film, before->film, i, display);
      if (steps < 1.0f) continue;
      ++effect.change->pixels;
      effect.change->steps = std::max(effect.change->steps, steps);
      ranked.push_back({steps, {x, y}});
    }
  }
  effect.worst = spaced(std::move(ranked));
  return effect;
}

std::string max_words(const MaxEffect& effect, int max_level) {
  if (effect.pixels == 0) return "";
  const char* which = effect.finished ? "" : "final ";
  std::string text = effect.ended_pixels == 0
                         ? fmt::format("No {}pixel has edges left at MAX {}.", which, max_level)
                         : fmt::format("MAX {} ended {} of {} {}pixels (marked).", max_level,
                                       effect.ended_pixels, effect.pixels, which);
  if (!effect.change) return text;
  const MaxEffect::Change& change = *effect.change;
  text += fmt::format("\nFrom MAX {} to {}: ", change.from, change.to);
  if (change.pixels == 0) return text + "no pixel changed visibly.";
  return text + fmt::format("{} pixels changed, by up to {:.0f} of 255 steps (circled).",
                            change.pixels, std::floor(change.steps));
}

bool MaxExplainer::update(const PreviewRender& render, const DisplayTransform& display,
                          bool asked) {
  if (!asked || !in_object_space(render.settings().method) || render.film().width == 0)
    return std::exchange(effect_, std::nullopt).has_value();
  const auto percent = static_cast<std::uint64_t>(100.0 * render.final_share()) +
                       (render.progress().finished ? 1 : 0);
  if (effect_ && restarts_ == render.restarts() && percent_ == percent) return false;
  effect_ = max_effect(render, display);
  restarts_ = render.restarts();
  percent_ = percent;
  return true;
}

}  // namespace asos::ui
