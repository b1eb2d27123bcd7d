#include "ui/split_check.h"

#include "renderer/comparison/method.h"
#include "renderer/geometry/largest.h"
#include "renderer/study/measures.h"
#include "renderer/study/timed_render.h"
#include "ui/frames.h"
#include "ui/pass_mean.h"
#include "ui/previewer.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace asos::ui {

namespace {

constexpr int least_passes = 6;  // fewer passes give no usable standard error
constexpr float as_one_sample = 0.25f / 255.0f;

// Number of standard errors that noise can explain: the quantile of Student's t-distribution at the
// probability of 4 standard deviations, expanded in 1 / (passes - 1) (Abramowitz and Stegun
// 26.7.5).
float most_explained(int passes) {
  constexpr float z = 4.0f, z2 = z * z;
  const float d = 1.0f / static_cast<float>(std::max(1, passes - 1));
  return z *
         (1.0f + 0.25f * (z2 + 1.0f) * d + (5.0f * z2 * z2 + 16.0f * z2 + 3.0f) / 96.0f * d * d);
}

/// The standard error of a mean that is clipped to 0 to 1.
float clipped_error(glm::vec3 mean, float error) {
  return 0.5f *
         largest(glm::clamp(mean + error, 0.0f, 1.0f) - glm::clamp(mean - error, 0.0f, 1.0f));
}

struct CheckRequest {
  Snapshot snapshot;
  Film picture;
  double alarm = 0.0;
};

void check_view(const CheckRequest& request, const std::stop_token& stop,
                const std::function<void(SplitFindings)>& tell) {
  const auto render = [&](Method method, int spp, int seed) {
    Snapshot snapshot = request.snapshot;
    snapshot.settings.method = method;
    snapshot.settings.sampling.spp = spp;
    snapshot.settings.seed = seed;
    return timed_render(std::move(snapshot), [&] { return stop.stop_requested(); });
  };
  const auto centres = render(Method::uniform, 1, 0);
  PassMean mean;
  while (centres && mean.count() < SplitCheck::most_passes) {
    const auto pass = render(Method::sobol, SplitCheck::samples_each, mean.count() + 1);
    if (!pass) return;
    mean.add(pass->film);
    if (mean.count() < least_passes) continue;
    SplitFindings found = find_faults({request.picture,
                                       centres->film,
                                       mean.film(),
                                       mean.uncertainty(),
                                       mean.count(),
                                       {0.0f, request.snapshot.settings.judged_tone}},
                                      request.alarm);
    found.passes = mean.count();
    found.reference = std::make_shared<const Film>(mean.film());
    tell(std::move(found));
  }
}

}  // namespace

void add_pixel(std::vector<PixelRun>& runs, int x, int y) {
  if (!runs.empty() && runs.back().y == y && runs.back().x + runs.back().count == x) {
    ++runs.back().count;
  } else {
    runs.push_back({x, y, 1});
  }
}

SplitFindings find_faults(const SplitEvidence& evidence, double alarm) {
  const Film& picture = evidence.picture;
  SplitFindings found;
  const float explained = most_explained(evidence.passes);
  const auto display_difference = [&](const Film& other, std::size_t i) {
    return difference_of(picture, other, i, evidence.display);
  };
  double noise = 0.0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const std::size_t i = picture.index(x, y);
      const glm::vec3 seen = picture.radiance[i], truth = evidence.reference.radiance[i];
      const float error = evidence.uncertainty[i];
      const auto clipped = static_cast<double>(clipped_error(truth, error));
      noise += clipped * clipped;
      // A shadow's edge may cut a pixel that has a single cell.
      const bool split = picture.split_level[i] > 0 || picture.cause[i] != SplitCause::none;
      found.split_pixels += split;
      if (split) {
        if (display_difference(evidence.centres, i) > as_one_sample) continue;
        ++found.wasted_pixels;
        add_pixel(found.wasted, x, y);
        continue;
      }
      if (!(largest(glm::abs(seen - truth)) > explained * error) ||
          !(static_cast<double>(display_difference(evidence.reference, i)) > alarm))
        continue;
      ++found.missed_pixels;
      add_pixel(found.missed, x, y);
    }
  }
  found.rmse = root_mean_square(picture, evidence.reference, true);
  const auto pixels = static_cast<double>(std::max<std::size_t>(1, picture.radiance.size()));
  found.noise = std::sqrt(noise / pixels);
  return found;
}

void SplitCheck::update(const Previewer& previewer, bool wanted, double alarm, bool held) {
  const PreviewRender& render = previewer.render();
  const Subject subject{render.restarts(), alarm};
  const bool ready = wanted && previewer.scene() && render.progress().finished &&
                     !previewer.seconds_to_update(0.0);
  current_ = ready && subject_ == subject;
  if (!ready) {
    findings_.reset();
    subject_.reset();  // a stopped job starts again
  }
  if ((!current_ || held) && job_.busy()) {
    cut_short_ |= current_ && !job_.stopping();
    job_.stop();
    if (!current_) return;
  }
  if (auto outcome = job_.take_outcome(); outcome && current_) findings_ = std::move(*outcome);
  if (!ready || held || job_.busy() || (current_ && !cut_short_)) return;
  if (!current_) findings_.reset();
  subject_ = subject;
  current_ = true;
  cut_short_ = false;
  job_.start(
      [request = CheckRequest{{previewer.scene().shared(), previewer.viewpoint().camera().camera(),
                               render.settings(), false},
                              render.film(),
                              alarm}](const std::stop_token& stop, const auto& tell) {
        check_view(request, stop, tell);
      });
}

}  // namespace asos::ui
