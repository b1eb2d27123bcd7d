#include "ui/error_map.h"

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

}  // namespace asos::ui
