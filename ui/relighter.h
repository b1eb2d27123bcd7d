#pragma once

#include "renderer/prepared/render_scene.h"
#include "renderer/result.h"
#include "ui/edited_light.h"
#include "ui/latest_job.h"
#include "ui/open_scene.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace asos::ui {

/// A scene's lights and its materials' defocusing ratios, as edited. Each edit increases the
/// revision.
struct SceneLook {
  std::vector<EditedLight> lights;  ///< relative to World::origin
  std::uint64_t lights_revision = 0;
  MaterialDfrs dfrs;
  std::uint64_t dfrs_revision = 0;
};

/// Applies the newest look to the open scene on its own thread, without rebuilding the hierarchies.
/// All members must be called from one thread.
class Relighter {
 public:
  /// `wake` is called from that thread when `update` has a result to take.
  explicit Relighter(std::function<void()> wake);

  /// Call when a scene with this look was opened.
  void start_from(const SceneLook& look);
  /// Call when the scene was replaced by another pose of it that has the look of these revisions.
  void start_over(std::uint64_t lights_revision, std::uint64_t dfrs_revision);
  /// Puts the scene with the finished look in place, or reports its error, and starts on `look` if
  /// it is newer than the last request. Call at least once a frame.
  void update(OpenScene& scene, const SceneLook& look);
  /// Whether the scene does not have this look yet.
  [[nodiscard]] bool pending(const SceneLook& look) const;

 private:
  struct Request {
    std::shared_ptr<const RenderScene> scene;
    std::optional<std::vector<Light>> lights;  // none: the scene has them
    std::uint64_t lights_revision = 0;         // revision of the resulting scene's lights
    MaterialDfrs dfrs;
  };
  struct Relit {
    std::shared_ptr<const RenderScene> from;
    Result<std::shared_ptr<const RenderScene>> scene;
    std::uint64_t lights_revision = 0;
  };
  [[nodiscard]] static Relit relit(const Request& request);
  [[nodiscard]] bool asked_for(const SceneLook& look) const;

  std::uint64_t lights_asked_for_ = 0;  // revision
  std::uint64_t lights_of_scene_ = 0;   // revision
  std::uint64_t dfrs_asked_for_ = 0;    // revision
  LatestJob<Request, Relit> job_;
};

}  // namespace asos::ui
