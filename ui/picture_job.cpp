#include "ui/picture_job.h"

#include "renderer/comparison/method.h"
#include "renderer/picture/exr_picture.h"
#include "renderer/session/film_render.h"
#include "renderer/session/strip_render.h"

#include <exception>
#include <filesystem>
#include <utility>

namespace asos::ui {

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

// Layers are not written in strips, but as a whole.
std::optional<Result<std::string>> write_layers(const PictureOrder& order,
                                                const std::stop_token& stop,
                                                const std::function<void(double)>& on_progress) {
  const Snapshot& snapshot = order.snapshot;
  if (const auto valid = validated(snapshot.settings); !valid) return unexpected(valid.error());
  if (const auto able = check_method(*snapshot.scene, snapshot.settings); !able)
    return unexpected(able.error());
  FilmRender render;
  const auto rendered = render.render(
      snapshot, [&] { return !stop.stop_requested(); },
      [&](const Progress& progress) {
        if (on_progress) on_progress(progress.fraction);
      });
  if (!rendered) return std::nullopt;
  const ExrOptions options = exr_options(*snapshot.scene, snapshot.camera, snapshot.settings);
  return write_exr(order.path, rendered->film, order.text, options).map([&] { return order.path; });
}

}  // namespace

std::optional<Result<std::string>> write_picture(const PictureOrder& order,
                                                 const std::stop_token& stop,
                                                 const std::function<void(double)>& on_progress) {
  if (!order.snapshot.settings.layers.empty()) return write_layers(order, stop, on_progress);
  const auto writer = writer_of(order);
  if (!writer) return unexpected(writer.error());
  const auto rendered = render_strips(order.snapshot, **writer, stop, on_progress);
  if (!rendered) return unexpected(rendered.error());
  if (*rendered == StripsEnd::stopped) return std::nullopt;
  return (*writer)->finish().map([&] { return order.path; });
}

void PictureJob::start(std::string path, Work work) {
  cancel();
  path_ = std::move(path);
  start_ = std::chrono::steady_clock::now();
  fraction_ = 0.0;
  running_ = true;
  thread_ = std::jthread(
      [this, work = std::move(work)](const std::stop_token& stop) { run(stop, work); });
}

void PictureJob::cancel() {
  thread_ = {};  // requests a stop and waits
  running_ = false;
  outcome_.reset();
}

void PictureJob::run(const std::stop_token& stop, const Work& work) {
  std::optional<Result<std::string>> outcome;
  // Running out of memory is reported as an error and does not end the program.
  try {
    outcome = work(stop, [this](double fraction) {
      const std::scoped_lock lock(mutex_);
      fraction_ = fraction;
    });
  } catch (const std::exception& e) {
    outcome = unexpected(Error{path_, e.what()});
  }
  const std::scoped_lock lock(mutex_);
  running_ = false;
  outcome_ = std::move(outcome);
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

}  // namespace asos::ui
