#include "renderer/prepared/boundary_features.h"

#include "renderer/features/stoppable_loop.h"

#include <chrono>
#include <pthread.h>
#include <utility>

namespace asos {

void BoundaryFeatures::find(Search search) {
  known_ = nullptr;
  search_ = std::move(search);
}

void BoundaryFeatures::start() const {
  const std::lock_guard lock(mutex_);
  if (!search_ || thread_.joinable()) return;
  thread_ = std::jthread([this](const std::stop_token& stop) {
    pthread_setname_np(pthread_self(), "asos boundaries");
    work(stop);
  });
}

bool BoundaryFeatures::running() const {
  const std::lock_guard lock(mutex_);
  return thread_.joinable() && !known() && !failure_;
}

void BoundaryFeatures::work(const std::stop_token& stop) const {
  const auto start = std::chrono::steady_clock::now();
  try {
    features_ = search_(stop);
    seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    // Under the mutex; otherwise a thread about to wait would miss it.
    const std::lock_guard lock(mutex_);
    known_.store(&features_, std::memory_order_release);
  } catch (const SearchStopped&) {
    return;  // only the destructor stops it: nobody waits
  } catch (...) {
    const std::lock_guard lock(mutex_);
    failure_ = std::current_exception();
  }
  ended_.notify_all();
}

bool BoundaryFeatures::failed() const {
  if (known()) return false;
  const std::lock_guard lock(mutex_);
  return failure_ != nullptr;
}

bool BoundaryFeatures::wait(const std::stop_token& stop) const {
  if (known_or_started()) return true;
  std::unique_lock lock(mutex_);
  ended_.wait(lock, stop, [this] { return known() || failure_ != nullptr; });
  return known();
}

const FeatureSet& BoundaryFeatures::waited_for() const {
  if (wait()) return features_;
  const std::lock_guard lock(mutex_);
  std::rethrow_exception(failure_);
}

}  // namespace asos
