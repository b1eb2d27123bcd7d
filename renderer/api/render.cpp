#include "asos/render.h"

#include "renderer/api/convert.h"
#include "renderer/api/picture_impl.h"
#include "renderer/api/ready_picture.h"
#include "renderer/api/scene_impl.h"
#include "renderer/comparison/method.h"
#include "renderer/session/film_render.h"

#include <utility>

namespace asos::api {

Result<Picture> render(const Scene& scene, const Camera& camera, const Settings& settings,
                       const RenderOptions& options) {
  return guarded("render", [&]() -> Result<Picture> {
    if (options.time_limit_seconds && !(*options.time_limit_seconds >= 0.0))
      return failure(ErrorCode::invalid_argument, "time_limit_seconds", "is not 0 or more");
    Result<ReadyPicture> ready = ready_picture(scene, camera, settings);
    if (!ready) return ready.error();
    const auto tell = [&](const asos::Progress& progress) {
      if (options.on_progress) options.on_progress(progress_of(progress));
    };
    FilmRender film_render;
    std::optional<RenderResult> result = film_render.render(
        ready->snapshot, [&] { return !options.stop.stop_requested(); }, tell,
        options.time_limit_seconds);
    if (!result && options.stop.stop_requested())
      return failure(ErrorCode::cancelled, "render", "was cancelled");
    if (!result)
      return failure(ErrorCode::out_of_memory, with_boundaries(ready->snapshot.scene).error());
    const bool finished = !result->stopped_at;
    return Picture(std::make_shared<const Picture::Impl>(
        Picture::Impl{*std::move(result), std::move(ready->snapshot), finished,
                      scene.impl().from_file, ready->tone}));
  });
}

}  // namespace asos::api
