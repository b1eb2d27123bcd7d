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

/// The boundaries of a scene, which a thread of its own finds while the scene is already seen by
/// its rays: finding them takes several times longer than building the rays' hierarchy, and one
/// sample a pixel needs none. Like a future that can be asked from any number of threads. The
/// destructor ends the search and waits for its thread, some tens of milliseconds.
class BoundaryFeatures {
 public:
  /// Throws SearchStopped once a stop is requested, and what memory throws.
  using Search = std::function<FeatureSet(const std::stop_token& stop)>;

  BoundaryFeatures() = default;  ///< none, and known
  BoundaryFeatures(const BoundaryFeatures&) = delete;
  BoundaryFeatures& operator=(const BoundaryFeatures&) = delete;

  /// Begins to find them. What `search` refers to has to outlive this. Once, before this is shared.
  void find(Search search);
  /// Takes boundaries that are known. Before this is shared.
  void set(FeatureSet known) { features_ = std::move(known); }

  [[nodiscard]] bool known() const { return known_.load(std::memory_order_acquire) != nullptr; }
  /// Whether they could not be found, for lack of memory.
  [[nodiscard]] bool failed() const;
  /// Waits until they are known: true. False: they could not be found, or `stop` is requested.
  [[nodiscard]] bool wait(const std::stop_token& stop = {}) const;
  /// Waits for them; throws what the search has thrown. Where somebody may want to stop: after
  /// `wait`.
  [[nodiscard]] const FeatureSet& get() const {
    const FeatureSet* known = known_.load(std::memory_order_acquire);
    return known ? *known : waited_for();
  }
  /// Seconds that the search took; 0 before they are known.
  [[nodiscard]] double seconds() const { return known() ? seconds_ : 0.0; }

 private:
  [[nodiscard]] const FeatureSet& waited_for() const;
  void work(const Search& search, const std::stop_token& stop);

  FeatureSet features_;
  double seconds_ = 0.0;
  std::atomic<const FeatureSet*> known_ = &features_;
  mutable std::mutex mutex_;
  mutable std::condition_variable_any ended_;
  std::exception_ptr failure_;  // under the mutex
  std::jthread thread_;         // last: ends before what it uses goes
};

}  // namespace asos
