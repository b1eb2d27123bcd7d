#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>

namespace asos {

/// The stages of opening a scene, in their order. Short ones may be left out.
enum class LoadStage : std::uint8_t {
  reading,    ///< the file and its buffers
  textures,   ///< decoding pictures
  meshes,     ///< decoding geometry
  surfaces,   ///< placing the meshes in the world
  lights,     ///< emissive meshes
  rays,       ///< hierarchy of the surfaces, coplanar surfaces
  finishing,  ///< default lighting, compact materials, environment
};
inline constexpr std::size_t load_stage_count = 7;

struct ScenePreview;

/// Thrown where a load is stopped. It is no std::exception, so that nothing reports it as a fault
/// of the file.
struct LoadStopped {};

/// The progress of opening a scene, and the request to stop it. One thread opens the scene, with
/// tasks; another reads the progress. It is the context of a thread (Scope) and no parameter, since
/// every layer has stages and none depends on them. Thread-safe.
class LoadProgress {
 public:
  /// `changed` may be empty. It is called by the opening thread at the beginning of each stage and
  /// for a preview, and must be thread-safe.
  explicit LoadProgress(std::function<void()> changed = {}) : changed_(std::move(changed)) {}

  void stop() { stopped_.store(true, std::memory_order_relaxed); }
  [[nodiscard]] bool stopped() const { return stopped_.load(std::memory_order_relaxed); }
  /// Stops the load at this number of stop points from its beginning. For tests.
  void stop_at(std::uint64_t points) { limit_.store(points, std::memory_order_relaxed); }
  /// Returns the number of stop points that the load has passed.
  [[nodiscard]] std::uint64_t points() const { return points_.load(std::memory_order_relaxed); }
  /// A stop point: returns false after `stop`.
  [[nodiscard]] bool goes_on() {
    if (points_.fetch_add(1, std::memory_order_relaxed) + 1 >= limit_) stop();
    return !stopped();
  }
  /// A stop point: throws LoadStopped after `stop`.
  void check() {
    if (!goes_on()) throw LoadStopped();
  }

  /// Begins a stage. Throws LoadStopped after `stop`.
  void begin(LoadStage stage) {
    stage_.store(stage, std::memory_order_relaxed);
    if (changed_) changed_();
    check();
  }
  [[nodiscard]] LoadStage stage() const { return stage_.load(std::memory_order_relaxed); }

  /// Allows that the scene is opened with plain texels in place of textures, which take far longer
  /// to decode than its geometry. It has to be opened again to get them.
  void allow_missing_textures() { may_miss_.store(true, std::memory_order_relaxed); }
  [[nodiscard]] bool may_miss_textures() const { return may_miss_.load(std::memory_order_relaxed); }
  /// The opening thread has left out this number of textures.
  void note_missing_textures(std::size_t count) {
    missing_.store(count, std::memory_order_relaxed);
  }
  [[nodiscard]] std::size_t missing_textures() const {
    return missing_.load(std::memory_order_relaxed);
  }
  void note_decoded_texture() { decoded_.fetch_add(1, std::memory_order_relaxed); }
  [[nodiscard]] std::size_t decoded_textures() const {
    return decoded_.load(std::memory_order_relaxed);
  }

  void publish(std::shared_ptr<const ScenePreview> preview) {
    {
      const std::scoped_lock lock(mutex_);
      preview_ = std::move(preview);
    }
    if (changed_) changed_();
  }
  /// Returns the published preview; null: none yet.
  [[nodiscard]] std::shared_ptr<const ScenePreview> preview() const {
    const std::scoped_lock lock(mutex_);
    return preview_;
  }

  /// Returns the progress that the current thread works for; null: none.
  [[nodiscard]] static LoadProgress* current() { return of_thread; }

  /// Makes a progress the current thread's own while it exists. Null: none.
  class Scope {
   public:
    explicit Scope(LoadProgress* progress) : before_(std::exchange(of_thread, progress)) {}
    ~Scope() { of_thread = before_; }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    LoadProgress* before_;
  };

 private:
  static inline thread_local LoadProgress* of_thread = nullptr;

  std::function<void()> changed_;
  std::atomic<bool> stopped_ = false;
  std::atomic<std::uint64_t> points_ = 0;
  std::atomic<std::uint64_t> limit_ = ~std::uint64_t{0};
  std::atomic<bool> may_miss_ = false;
  std::atomic<std::size_t> missing_ = 0;
  std::atomic<std::size_t> decoded_ = 0;
  std::atomic<LoadStage> stage_ = LoadStage::reading;
  mutable std::mutex mutex_;
  std::shared_ptr<const ScenePreview> preview_;
};

/// Begins a stage of the load that the current thread works for, if any. Throws LoadStopped.
inline void begin_stage(LoadStage stage) {
  if (LoadProgress* progress = LoadProgress::current()) progress->begin(stage);
}

/// A place where a load can stop: throws LoadStopped.
inline void stop_point() {
  if (LoadProgress* progress = LoadProgress::current()) progress->check();
}

}  // namespace asos
