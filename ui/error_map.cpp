#include "ui/error_map.h"

#include "renderer/study/measures.h"
#include "ui/frames.h"
#include "ui/previewer.h"
#include "ui/split_check.h"

#include <algorithm>
#include <cmath>

namespace asos::ui {

float ErrorScale::share(double steps) {
  if (!(steps > first)) return 0.0f;
  return static_cast<float>(std::min(1.0, std::log(steps / first) / std::log(last / first)));
}

double error_steps(const Film& picture, const Film& reference, std::size_t pixel,
                   const DisplayTransform& display) {
  constexpr double steps = 255.0;
  return steps * static_cast<double>(difference_of(picture, reference, pixel, display));
}

ErrorSummary error_summary(const Film& picture, const Film& reference,
                           const DisplayTransform& display) {
  std::size_t visible = 0;
  for (std::size_t i = 0; i < picture.radiance.size(); ++i)
    visible += error_steps(picture, reference, i, display) > 1.0;
  return {root_mean_square(picture, reference, true),
          static_cast<double>(visible) / static_cast<double>(picture.radiance.size())};
}

ErrorReference::View ErrorReference::view_of(const Previewer& previewer) {
  const PreviewRender& render = previewer.render();
  View view{previewer.scene().get(), previewer.viewpoint().camera().revision(), render.settings()};
  const RenderSettings usual;
  view.settings.asos = usual.asos;
  view.settings.sampling = usual.sampling;
  view.settings.method = usual.method;
  view.settings.seed = usual.seed;
  view.settings.threads = usual.threads;
  view.settings.judged_tone = usual.judged_tone;
  return view;
}

void ErrorReference::update(const Previewer& previewer, const SplitFindings* findings) {
  const View now = view_of(previewer);
  if (film_ && view_ != now) {
    film_.reset();
    ++revision_;
  }
  if (!findings || !findings->reference || findings->reference == film_) return;
  view_ = now;
  film_ = findings->reference;
  samples_ = findings->passes * SplitCheck::samples_each;
  ++revision_;
}

std::optional<ErrorSummary> ErrorReference::summary(const Previewer& previewer,
                                                    const DisplayTransform& display) {
  const PreviewRender& render = previewer.render();
  const Film& picture = render.film();
  if (!film_ || !render.progress().finished || film_->width != picture.width ||
      film_->height != picture.height)
    return std::nullopt;
  const Measured now{revision_, render.restarts(), display};
  if (measured_ != now) {
    measured_ = now;
    summary_ = error_summary(picture, *film_, display);
  }
  return summary_;
}

}  // namespace asos::ui
