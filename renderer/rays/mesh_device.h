#pragma once

#include "renderer/world/world.h"

#include <embree3/rtcore.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace asos::tracing {

struct ReleaseScene {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using OwnedScene = std::unique_ptr<RTCSceneTy, ReleaseScene>;

/// A device of Embree, with the hierarchies of meshes that several scenes on it share.
class MeshDevice {
 public:
  MeshDevice();
  MeshDevice(const MeshDevice&) = delete;
  MeshDevice& operator=(const MeshDevice&) = delete;
  ~MeshDevice();
  /// Returns the device for the moments of animations, which may be more than Embree can have
  /// devices, and show the same meshes.
  [[nodiscard]] static std::shared_ptr<MeshDevice> common();

  /// Null: Embree does not start.
  [[nodiscard]] RTCDevice get() const { return device_; }
  /// Returns the first error since the last call; empty: none.
  [[nodiscard]] std::string take_error();
  [[nodiscard]] std::int64_t bytes() const { return bytes_; }
  /// Returns the hierarchy of a mesh, which belongs to the caller. `build` makes it, unless there
  /// is one from a world that still exists, with filters or without.
  [[nodiscard]] OwnedScene scene_of(const std::shared_ptr<const World>& mesh, bool filtered,
                                    const std::function<OwnedScene()>& build);

 private:
  struct Errors {
    std::mutex mutex;
    std::string first;
    static void note(void* self, RTCError code, const char* text);
  };
  struct Known {
    std::weak_ptr<const World> mesh;
    bool filtered;
    RTCScene scene;
  };

  Errors errors_;
  std::atomic<std::int64_t> bytes_{0};
  RTCDevice device_ = nullptr;
  std::mutex mutex_;
  std::vector<Known> scenes_;
};

/// Builds a scene's hierarchy over this number of surfaces. Throws LoadStopped.
void commit(RTCScene scene, std::size_t surfaces);

}  // namespace asos::tracing
