#include "asos/session.h"

#include "renderer/api/convert.h"
#include "renderer/api/picture_impl.h"
#include "renderer/api/ready_picture.h"
#include "renderer/api/scene_impl.h"
#include "renderer/session/tile_bell.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <mutex>
#include <optional>
#include <utility>

namespace asos::api {
namespace {

void copy_tile(const FinishedTile& tile, const Film& film, std::span<float> rgb) {
  const PixelRect& rect = tile.rect;
  for (int y = std::max(rect.y, 0); y < std::min(rect.y + rect.height, film.height); ++y)
    for (int x = std::max(rect.x, 0); x < std::min(rect.x + rect.width, film.width); ++x)
      for (int c = 0; c < 3; ++c)
        rgb[3 * film.index(x, y) + static_cast<std::size_t>(c)] =
            film.radiance[film.index(x, y)][c];
}

}  // namespace

struct Session::Impl {
  explicit Impl(std::function<void()> told)
      : on_tiles(std::move(told)), session([this] {
          bell.ring();
          if (on_tiles) on_tiles();
        }) {}

  /// Moves finished tiles into the film, and keeps them until they are handed out.
  void keep_tiles() {
    for (FinishedTile& tile : session.take_finished()) {
      film.put(tile);
      kept.push_back(std::move(tile));
    }
  }
  void begin(ReadyPicture ready, const Scene& of) {
    scene.emplace(of);
    picture.emplace(std::move(ready));
    kept.clear();
    bell.quiet();
    session.restart(picture->snapshot);
    const PixelRect visible = session.visible();
    film = Film(visible.width, visible.height);
    cancelled = false;
  }

  std::function<void()> on_tiles;
  TileBell bell;
  std::mutex mutex;  // of all below
  std::optional<Scene> scene;
  std::optional<ReadyPicture> picture;
  Camera camera;
  Settings settings;
  Film film;
  std::vector<FinishedTile> kept;  ///< in the film, and not handed out yet
  bool cancelled = false;
  RenderSession session;
};

Session::Session(std::function<void()> on_tiles)
    : impl_(std::make_unique<Impl>(std::move(on_tiles))) {}
Session::~Session() = default;

Result<void> Session::start(const Scene& scene, const Camera& camera, const Settings& settings) {
  return guarded("session", [&]() -> Result<void> {
    Result<ReadyPicture> ready = ready_picture(scene, camera, settings);
    if (!ready) return ready.error();
    const std::lock_guard lock(impl_->mutex);
    impl_->camera = camera;
    impl_->settings = settings;
    impl_->begin(*std::move(ready), scene);
    return {};
  });
}

Result<void> Session::relight(std::span<const Light> lights) {
  return guarded("session", [&]() -> Result<void> {
    std::unique_lock lock(impl_->mutex);
    if (!impl_->scene)
      return failure(ErrorCode::invalid_argument, "session", "has not been started");
    const Scene scene = *impl_->scene;
    const Camera camera = impl_->camera;
    const Settings settings = impl_->settings;
    lock.unlock();  // others see the former render meanwhile
    const Result<Scene> relit = scene.with_lights(lights);
    if (!relit) return relit.error();
    Result<ReadyPicture> ready = ready_picture(*relit, camera, settings);
    if (!ready) return ready.error();
    lock.lock();
    impl_->begin(*std::move(ready), *relit);
    return {};
  });
}

void Session::cancel() {
  const std::lock_guard lock(impl_->mutex);
  impl_->session.cancel();
  impl_->cancelled = true;
  impl_->bell.ring();
}

void Session::pause() {
  const std::lock_guard lock(impl_->mutex);
  impl_->session.pause();
}

void Session::resume() {
  const std::lock_guard lock(impl_->mutex);
  impl_->session.resume();
}

Progress Session::progress() const {
  const std::lock_guard lock(impl_->mutex);
  return progress_of(impl_->session.progress());
}

bool Session::wait(std::chrono::milliseconds timeout) {
  const std::uint64_t seen = impl_->bell.rings();
  {
    const std::lock_guard lock(impl_->mutex);
    const asos::Progress progress = impl_->session.progress();
    if (progress.finished || progress.failed || impl_->cancelled || !impl_->kept.empty())
      return true;
  }
  return impl_->bell.wait(seen, timeout);
}

Result<std::vector<Rect>> Session::take_tiles(std::span<float> rgb) {
  return guarded("session", [&]() -> Result<std::vector<Rect>> {
    const std::lock_guard lock(impl_->mutex);
    if (rgb.size() != 3 * impl_->film.radiance.size())
      return failure(ErrorCode::invalid_argument, "buffer",
                     fmt::format("has {} values, the picture 3 for each of {}x{} pixels",
                                 rgb.size(), impl_->film.width, impl_->film.height));
    impl_->bell.quiet();
    impl_->keep_tiles();
    std::vector<Rect> rects;
    for (const FinishedTile& tile : impl_->kept) {
      copy_tile(tile, impl_->film, rgb);
      rects.push_back({tile.rect.x, tile.rect.y, tile.rect.width, tile.rect.height});
    }
    impl_->kept.clear();
    return rects;
  });
}

Result<Picture> Session::picture() const {
  return guarded("session", [&]() -> Result<Picture> {
    const std::lock_guard lock(impl_->mutex);
    if (!impl_->picture)
      return failure(ErrorCode::invalid_argument, "session", "has not been started");
    const asos::Progress progress = impl_->session.progress();
    impl_->keep_tiles();
    RenderResult result{impl_->film, impl_->session.statistics(), progress.seconds, {}};
    return Picture(std::make_shared<const Picture::Impl>(
        Picture::Impl{std::move(result), impl_->picture->snapshot, progress.finished,
                      impl_->scene->impl().from_file, impl_->picture->tone}));
  });
}

}  // namespace asos::api
