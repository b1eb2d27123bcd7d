#include "ui/movie.h"

#include "renderer/files/helper_program.h"
#include "renderer/film/picture_writer.h"
#include "renderer/prepared/with_lines.h"
#include "renderer/scene/turned_camera.h"
#include "renderer/session/strip_render.h"
#include "ui/playback.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <utility>

namespace asos::ui {

namespace {

namespace fs = std::filesystem;

/// The files of a movie in progress. The destructor deletes those that were not kept.
class MovieFiles {
 public:
  explicit MovieFiles(const MovieOrder& order) : order_(order) {}
  ~MovieFiles() {
    std::error_code ignored;
    if (kept_) return;
    for (const std::string& frame : written_) fs::remove(frame, ignored);
    if (!folder_.empty()) fs::remove_all(folder_, ignored);
  }
  MovieFiles(const MovieFiles&) = delete;
  MovieFiles& operator=(const MovieFiles&) = delete;

  /// Creates a folder for the frames next to the MP4.
  Result<void> prepare() {
    if (!order_.mp4) return {};
    std::string name = order_.stem + "-frames-XXXXXX";
    if (!mkdtemp(name.data())) return unexpected(Error{name, "this folder cannot be made"});
    folder_ = name;
    return {};
  }
  [[nodiscard]] std::string frame(int number) const {
    if (order_.mp4) return fmt::format("{}/{:06}.png", folder_, number);
    return fmt::format("{}-{:04}.png", order_.stem, number);
  }
  void wrote(std::string path) { written_.push_back(std::move(path)); }
  void keep() { kept_ = true; }
  [[nodiscard]] const std::string& folder() const { return folder_; }

 private:
  const MovieOrder& order_;
  std::string folder_;
  std::vector<std::string> written_;
  bool kept_ = false;
};

Result<Snapshot> frame_snapshot(const MovieOrder& order, int number) {
  Snapshot snapshot = order.snapshot;
  bool moved = false;
  if (order.animation) {
    const double seconds = number / order.fps;
    auto scene = Playback::scene_at(*snapshot.scene, ClipTime{*order.animation, seconds},
                                    order.lights, order.dfrs, snapshot.settings.ground);
    if (!scene) return unexpected(scene.error());
    snapshot.scene = *std::move(scene);
    moved = true;
  } else {
    snapshot.camera = turned_camera(snapshot.camera, order.middle, number, order.frames);
  }
  if (!snapshot.scene->world().lines_and_points.empty()) {
    auto drawn = with_lines(snapshot.scene, line_picture(snapshot.camera, snapshot.settings));
    if (!drawn) return unexpected(drawn.error());
    snapshot.scene = *std::move(drawn);
  }
  if (moved && snapshot.settings.shutter.blurs()) {
    auto blurred = Playback::exposed_scene(snapshot.scene, {snapshot.camera, snapshot.settings},
                                           order.lights, order.dfrs);
    if (!blurred) return unexpected(blurred.error());
    snapshot.scene = *std::move(blurred);
  }
  return snapshot;
}

Result<StripsEnd> write_frame(const MovieOrder& order, int number, const std::string& path,
                              const std::stop_token& stop,
                              const std::function<void(double)>& on_progress) {
  const Result<Snapshot> snapshot = frame_snapshot(order, number);
  if (!snapshot) return unexpected(snapshot.error());
  const bool clear =
      !order.mp4 && snapshot->settings.background.kind == BackgroundKind::transparent;
  const auto writer =
      make_png_writer(path, {snapshot->settings.width, snapshot->settings.height}, order.display,
                      ImageText{}, clear ? Alpha::coverage : Alpha::none);
  if (!writer) return unexpected(writer.error());
  const Result<StripsEnd> rendered = render_strips(*snapshot, **writer, stop, on_progress);
  if (!rendered || *rendered == StripsEnd::stopped) return rendered;
  return (*writer)->finish().map([] { return StripsEnd::finished; });
}

std::optional<Result<std::string>> join(const MovieOrder& order, MovieFiles& files,
                                        const std::stop_token& stop) {
  const std::string path = order.stem + ".mp4", part = order.stem + ".part.mp4";
  std::error_code fault;
  const std::string ffmpeg = find_program("ffmpeg");
  const Result<void> made =
      ffmpeg.empty() ? unexpected(Error{"ffmpeg", "is not installed"})
                     : run_program(ffmpeg_command(ffmpeg, files.folder(), order.fps, part), "",
                                   [&] { return stop.stop_requested(); });
  if (made) fs::rename(part, path, fault);
  if (made && !fault) return path;
  std::error_code ignored;
  fs::remove(part, ignored);
  if (stop.stop_requested()) return std::nullopt;
  files.keep();
  Error error = made ? Error{path, fault.message()} : made.error();
  error.reason += "; the frames are in " + files.folder();
  return unexpected(std::move(error));
}

std::string escaped_pattern(const std::string& folder) {
  std::string safe;
  for (const char c : folder) safe += c == '%' ? std::string("%%") : std::string(1, c);
  return safe;
}

}  // namespace

int frames_of(double seconds, double fps) {
  return 1 + static_cast<int>(std::floor(std::max(0.0, seconds) * fps + 1e-6));
}

std::vector<std::string> ffmpeg_command(const std::string& ffmpeg, const std::string& folder,
                                        double fps, const std::string& path) {
  // H.264 with this pixel format needs even sides.
  return {ffmpeg,
          "-y",
          "-loglevel",
          "error",
          "-framerate",
          fmt::format("{:g}", fps),
          "-i",
          fs::absolute(escaped_pattern(folder) + "/%06d.png").string(),
          "-vf",
          "pad=ceil(iw/2)*2:ceil(ih/2)*2",
          "-c:v",
          "libx264",
          "-crf",
          "17",
          "-pix_fmt",
          "yuv420p",
          fs::absolute(path).string()};
}

std::optional<Result<std::string>> write_movie(const MovieOrder& order, const std::stop_token& stop,
                                               const std::function<void(double)>& on_progress) {
  MovieFiles files(order);
  if (const Result<void> made = files.prepare(); !made) return unexpected(made.error());
  for (int number = 0; number < order.frames; ++number) {
    const std::string path = files.frame(number);
    const auto written = write_frame(order, number, path, stop, [&](double fraction) {
      on_progress((number + fraction) / order.frames);
    });
    if (!written) return unexpected(written.error());
    if (*written == StripsEnd::stopped) return std::nullopt;
    files.wrote(path);
    if (stop.stop_requested()) return std::nullopt;
  }
  if (order.mp4) return join(order, files, stop);
  files.keep();
  return fmt::format("{} to {:04}.png", files.frame(0), order.frames - 1);
}

}  // namespace asos::ui
