#pragma once

#include "renderer/methods/render_scene.h"
#include "renderer/result.h"

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace asos {

/// Opens a source ("builtin:NAME" or a path); called on the loader's thread.
using LoadFunction = std::function<Result<Scene>(const std::string& source)>;

/// A scene made ready to render, or the error in its place.
struct LoadOutcome {
  std::string source;
  Result<std::shared_ptr<const RenderScene>> scene;
  double load_seconds = 0.0;  ///< reading the file, without building the hierarchies
};

/// Loads and prepares scenes on a thread of its own. A newer request replaces an older one: the
/// older outcome is dropped, even where its loading has begun. The destructor waits for a load
/// that runs.
class SceneLoader {
 public:
  /// `wake` is called from the loader's thread when an outcome waits. `forced`: see prepare.
  SceneLoader(LoadFunction load, std::function<void()> wake, const SceneNeeds& forced = {});

  void open(std::string source);
  /// The outcome of the newest request, once.
  [[nodiscard]] std::optional<LoadOutcome> take_outcome();

  struct Loading {
    std::string source;
    double seconds = 0.0;
  };
  /// What is being loaded for the newest request.
  [[nodiscard]] std::optional<Loading> loading() const;

 private:
  void run(const std::stop_token& stop);
  [[nodiscard]] LoadOutcome load_and_prepare(const std::string& source) const;

  LoadFunction load_;
  std::function<void()> wake_;
  SceneNeeds forced_;
  mutable std::mutex mutex_;
  std::condition_variable_any requested_;
  std::optional<std::string> request_;  // not begun
  std::optional<std::string> pending_;  // newest request, until its outcome is there
  std::chrono::steady_clock::time_point pending_since_;
  std::optional<LoadOutcome> outcome_;
  std::jthread thread_;  // last: stops before what it uses goes
};

}  // namespace asos
