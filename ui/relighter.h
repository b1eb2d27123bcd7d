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

/// A scene's lights, and how its materials blur what they mirror, as a person has edited them. The
/// revisions grow with every edit.
struct SceneLook {
  std::vector<EditedLight> lights;  ///< relative to World::origin
  std::uint64_t lights_revision = 0;
  MaterialDfrs dfrs;
  std::uint64_t dfrs_revision = 0;
};

/// Gives the open scene its newest look on a thread of its own, without its hierarchies being built
/// anew. All members are for one thread.
class Relighter {
 public:
  /// `wake` is called from the thread when `update` has something to do.
  explicit Relighter(std::function<void()> wake);

  /// A scene that has this look has just been opened.
  void start_from(const SceneLook& look);
  /// The scene has been replaced by itself at another time, which has the look of these revisions.
  void start_over(std::uint64_t lights_revision, std::uint64_t dfrs_revision);
  /// Hands the scene over in the look that is finished, or tells it the error, and asks for `look`
  /// where that is newer than what was asked for. Call once or more a frame.
  void update(OpenScene& scene, const SceneLook& look);
  /// Whether the scene does not have this look yet.
  [[nodiscard]] bool pending(const SceneLook& look) const;

 private:
  struct Request {
    std::shared_ptr<const RenderScene> scene;
    std::optional<std::vector<Light>> lights;  // none: the scene has them
    std::uint64_t lights_revision = 0;         // of the scene that comes out
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
