#pragma once

#include "renderer/features/feature_set.h"

#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>

namespace asos {

/// The boundaries of a scene, which a separate thread finds while rays can already render the
/// scene. Finding them takes several times longer than building the rays' hierarchy, and methods
/// that only cast rays do not need them, so the search begins on demand. Works like a future that
/// any number of threads may query. The destructor ends the search and waits for its thread, some
/// tens of milliseconds.
class BoundaryFeatures {
 public:
  /// Throws SearchStopped once a stop is requested, and exceptions of memory allocation.
  using Search = std::function<FeatureSet(const std::stop_token& stop)>;

  BoundaryFeatures() = default;  ///< no boundaries; known
  BoundaryFeatures(const BoundaryFeatures&) = delete;
  BoundaryFeatures& operator=(const BoundaryFeatures&) = delete;

  /// Sets the search, which begins with the first call of `start`, `wait` or `get`. The references
  /// in `search` have to outlive this object. May be called once, before this object is shared.
  void find(Search search);
  /// Sets known boundaries. Must be called before this object is shared.
  void set(FeatureSet known) { features_ = std::move(known); }

  /// Begins the search, unless it has begun already or there is none.
  void start() const;
  /// Returns whether the search has begun and not ended.
  [[nodiscard]] bool running() const;
  [[nodiscard]] bool known() const { return known_.load(std::memory_order_acquire) != nullptr; }
  /// Returns whether the search failed for lack of memory.
  [[nodiscard]] bool failed() const;
  /// Begins the search and returns whether the boundaries are known already.
  [[nodiscard]] bool known_or_started() const {
    if (!known()) start();
    return known();
  }
  /// Waits until the boundaries are known, and returns true. Returns false if the search failed, or
  /// `stop` is requested.
  [[nodiscard]] bool wait(const std::stop_token& stop = {}) const;
  /// Waits for the boundaries, and throws the exception of the search, if any. A caller that can be
  /// stopped calls `wait` first.
  [[nodiscard]] const FeatureSet& get() const {
    const FeatureSet* known = known_.load(std::memory_order_acquire);
    return known ? *known : waited_for();
  }
  /// Returns the seconds that the search took; 0 before its end.
  [[nodiscard]] double seconds() const { return known() ? seconds_ : 0.0; }

 private:
  [[nodiscard]] const FeatureSet& waited_for() const;
  void work(const std::stop_token& stop) const;

  Search search_;
  // Changed by the search.
  mutable FeatureSet features_;
  mutable double seconds_ = 0.0;
  mutable std::atomic<const FeatureSet*> known_ = &features_;
  mutable std::mutex mutex_;
  mutable std::condition_variable_any ended_;
  mutable std::exception_ptr failure_;  // under the mutex
  mutable std::jthread thread_;         // last member: joins before the others are destroyed
};

}  // namespace asos
