#include "ui/picture_job.h"

#include "renderer/session/strip_render.h"

#include <exception>
#include <filesystem>
#include <utility>

namespace asos {

namespace {

Result<std::unique_ptr<PictureWriter>> writer_of(const PictureOrder& order) {
  const PixelRect part = order.snapshot.settings.visible();
  const PictureSizePx size{part.width, part.height};
  const bool clear = order.snapshot.settings.background.kind == BackgroundKind::transparent;
  const Alpha alpha = clear ? Alpha::coverage : Alpha::none;
  if (std::filesystem::path(order.path).extension() == ".exr")
    return make_exr_writer(order.path, size, order.text, alpha);
  return make_png_writer(order.path, size, order.display, order.text, alpha);
}

}  // namespace

void PictureJob::start(PictureOrder order) {
  cancel();
  path_ = order.path;
  start_ = std::chrono::steady_clock::now();
  fraction_ = 0.0;
  running_ = true;
  thread_ = std::jthread(
      [this, order = std::move(order)](const std::stop_token& stop) { run(stop, order); });
}

void PictureJob::cancel() {
  thread_ = {};  // asks it to stop, and waits
  running_ = false;
  outcome_.reset();
}

void PictureJob::run(const std::stop_token& stop, const PictureOrder& order) {
  Result<std::string> outcome = order.path;
  bool stopped = false;
  // Memory can run out; that is an error to show, not an end.
  try {
    const auto writer = writer_of(order);
    const auto rendered = writer ? render_strips(order.snapshot, **writer, stop,
                                                 [this](double fraction) {
                                                   const std::scoped_lock lock(mutex_);
                                                   fraction_ = fraction;
                                                 })
                                 : Result<StripsEnd>(unexpected(writer.error()));
    stopped = rendered && *rendered == StripsEnd::stopped;
    if (!rendered) {
      outcome = unexpected(rendered.error());
    } else if (!stopped) {
      outcome = (*writer)->finish().map([&] { return order.path; });
    }
  } catch (const std::exception& e) {
    outcome = unexpected(Error{order.path, e.what()});
  }
  const std::scoped_lock lock(mutex_);
  running_ = false;
  if (!stopped) outcome_ = std::move(outcome);
}

std::optional<PictureJob::State> PictureJob::state() const {
  const std::scoped_lock lock(mutex_);
  if (!running_) return std::nullopt;
  constexpr double enough = 0.01;
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  return State{path_, fraction_,
               fraction_ > enough ? seconds * (1.0 - fraction_) / fraction_ : -1.0};
}

bool PictureJob::pending() const {
  const std::scoped_lock lock(mutex_);
  return running_ || outcome_;
}

std::optional<Result<std::string>> PictureJob::take_outcome() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(outcome_, std::nullopt);
}

}  // namespace asos
