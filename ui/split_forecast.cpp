#include "ui/split_forecast.h"

#include "renderer/comparison/method.h"
#include "renderer/session/thread_seconds.h"
#include "ui/previewer.h"
#include "ui/snapshot_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asos::ui {

namespace {

constexpr double forecast_seconds = 0.15;
constexpr int least_blocks = 4;
constexpr int most_blocks = 400;

PixelRect block_at(const RenderSettings& settings, int index) {
  // Roberts' R2 sequence: powers of the inverse of the plastic number.
  const auto place = [&](double step, int size, int side) {
    const double at = 0.5 + step * index;
    return static_cast<int>((at - std::floor(at)) * size) / side * side;
  };
  const int side = block_side(settings);
  const int x = place(0.7548776662466927, settings.width, side);
  const int y = place(0.5698402909980532, settings.height, side);
  return {x, y, std::min(side, settings.width - x), std::min(side, settings.height - y)};
}

}  // namespace

Forecast forecast(const Snapshot& snapshot, double budget_seconds) {
  const RenderSettings& settings = snapshot.settings;
  const View view = view_of(snapshot);
  const double start = thread_seconds();
  double pixels = 0.0, split = 0.0, squares = 0.0, taken = 0.0;
  int blocks = 0;
  while (blocks < most_blocks && (blocks < least_blocks || taken < budget_seconds)) {
    const PixelRect rect = block_at(settings, blocks);
    const BlockResult block = render_block(*snapshot.scene, view, settings, rect);
    const double area = 1.0 * rect.width * rect.height;
    // The split map also shows single-cell pixels that a shadow's edge cuts.
    const auto& tile = block.tile;
    double cut = 0.0;
    for (std::size_t i = 0; i < tile.split_level.size(); ++i)
      cut += tile.split_level[i] > 0 || tile.cause[i] != SplitCause::none;
    pixels += area;
    split += cut;
    squares += cut * cut / area;
    taken = thread_seconds() - start;
    ++blocks;
  }
  Forecast told;
  told.pixels = static_cast<int>(pixels);
  told.split_share = split / pixels;
  // Blocks are independent samples; pixels are not.
  const double variance = std::max(0.0, squares / pixels - told.split_share * told.split_share);
  told.split_error = std::sqrt(variance / blocks);
  told.processor_seconds = taken;
  told.wait_seconds =
      taken / pixels * settings.width * settings.height / worker_count(settings.threads, true);
  return told;
}

SplitForecast::SplitForecast()
    : job_(
          [](const Snapshot& snapshot) {
            return Told{snapshot.settings, snapshot.scene.get(),
                        forecast(snapshot, forecast_seconds)};
          },
          {}, Overtaken::kept) {}

void SplitForecast::ask(const Previewer& previewer) {
  const RenderSettings& settings = previewer.edits().settings();
  if (!previewer.scene() || !validated(settings) || !previewer.viewpoint().sized()) return;
  // An estimate must not wait for the search for edges.
  if (needs_boundaries(settings.method) && !previewer.scene()->geometry->boundaries.known()) return;
  if (asked_ == settings && camera_ == previewer.viewpoint().camera().revision()) return;
  asked_ = settings;
  camera_ = previewer.viewpoint().camera().revision();
  job_.ask({previewer.scene().shared(), previewer.viewpoint().camera().camera(), settings, false});
}

void SplitForecast::follow(const Previewer& previewer) {
  const AsosSettings& now = previewer.edits().settings().asos;
  if (!followed_) followed_ = now;
  if (now.eps == followed_->eps && now.max_level == followed_->max_level) return;
  if (!in_object_space(previewer.edits().settings().method)) return;
  followed_ = now;
  ask(previewer);
}

void SplitForecast::update() {
  if (auto told = job_.take_outcome()) told_ = std::move(*told);
}

const Forecast* SplitForecast::of(const Previewer& previewer) const {
  const bool current = told_ && told_->settings == previewer.edits().settings() &&
                       told_->scene == previewer.scene().get() &&
                       camera_ == previewer.viewpoint().camera().revision();
  return current ? &told_->forecast : nullptr;
}

}  // namespace asos::ui
