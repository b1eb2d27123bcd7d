#include "renderer/rays/mesh_device.h"

#include "renderer/load_progress.h"
#include "renderer/tasks.h"
#include "renderer/work_counts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace asos::tracing {
namespace {

/// Counts Embree's allocations, on any of its threads.
bool count_bytes(void* counter, ssize_t bytes, bool) {
  const TaskOrder::Task task;
  static_cast<std::atomic<std::int64_t>*>(counter)->fetch_add(bytes, std::memory_order_relaxed);
  return true;
}

/// Lets a stop of the load end Embree's build, on any of its threads. `progress`: a LoadProgress.
bool goes_on(void* progress, double) {
  const TaskOrder::Task task;
  return static_cast<LoadProgress*>(progress)->goes_on();
}

void watch_for_stops(RTCScene scene) {
  if (LoadProgress* progress = LoadProgress::current())
    rtcSetSceneProgressMonitorFunction(scene, goes_on, progress);
}

}  // namespace

void commit(RTCScene scene, std::size_t surfaces) {
  WorkDone::add(Work::hierarchy_surfaces, surfaces);
  watch_for_stops(scene);
  {
    const TaskOrder::Sending sending;
    rtcCommitScene(scene);
  }
  rtcSetSceneProgressMonitorFunction(scene, nullptr, nullptr);
  stop_point();
}

MeshDevice::MeshDevice() : device_(rtcNewDevice(nullptr)) {
  if (!device_) return;
  rtcSetDeviceErrorFunction(device_, Errors::note, &errors_);
  rtcSetDeviceMemoryMonitorFunction(device_, count_bytes, &bytes_);
}

std::string MeshDevice::take_error() {
  const std::lock_guard lock(errors_.mutex);
  return std::exchange(errors_.first, {});
}

MeshDevice::~MeshDevice() {
  for (const Known& known : scenes_) rtcReleaseScene(known.scene);
  if (device_) rtcReleaseDevice(device_);
}

std::shared_ptr<MeshDevice> MeshDevice::common() {
  static std::mutex mutex;
  static std::weak_ptr<MeshDevice> newest;
  const std::lock_guard lock(mutex);
  std::shared_ptr<MeshDevice> device = newest.lock();
  if (!device) newest = device = std::make_shared<MeshDevice>();
  return device;
}

OwnedScene MeshDevice::scene_of(const std::shared_ptr<const World>& mesh, bool filtered,
                                const std::function<OwnedScene()>& build) {
  const std::lock_guard lock(mutex_);
  std::erase_if(scenes_, [](const Known& known) {
    if (!known.mesh.expired()) return false;
    rtcReleaseScene(known.scene);
    return true;
  });
  auto found = std::find_if(scenes_.begin(), scenes_.end(), [&](const Known& known) {
    return known.filtered == filtered && known.mesh.lock() == mesh;
  });
  if (found == scenes_.end()) {
    OwnedScene built = build();
    found = scenes_.insert(scenes_.end(), {mesh, filtered, built.release()});
  }
  rtcRetainScene(found->scene);
  return OwnedScene(found->scene);
}

void MeshDevice::Errors::note(void* self, RTCError code, const char* text) {
  if (code == RTC_ERROR_CANCELLED) return;  // LoadStopped says so
  auto& errors = *static_cast<Errors*>(self);
  const std::lock_guard lock(errors.mutex);
  if (!errors.first.empty()) return;
  const std::string words = code == RTC_ERROR_OUT_OF_MEMORY ? "out of memory" : "";
  errors.first = fmt::format("{}{}{}", words, words.empty() || !text ? "" : ": ", text ? text : "");
  if (errors.first.empty()) errors.first = fmt::format("error {}", static_cast<int>(code));
}

}  // namespace asos::tracing
