#include "ui/scene_loader.h"

#include <exception>
#include <utility>

namespace asos {

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

SceneLoader::SceneLoader(LoadFunction load, std::function<void()> wake, const SceneNeeds& forced)
    : load_(std::move(load)),
      wake_(std::move(wake)),
      forced_(forced),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

void SceneLoader::open(std::string source) {
  {
    const std::scoped_lock lock(mutex_);
    outcome_.reset();
    pending_ = source;
    pending_since_ = std::chrono::steady_clock::now();
    request_ = std::move(source);
  }
  requested_.notify_one();
}

std::optional<LoadOutcome> SceneLoader::take_outcome() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(outcome_, std::nullopt);
}

std::optional<SceneLoader::Loading> SceneLoader::loading() const {
  const std::scoped_lock lock(mutex_);
  if (!pending_) return std::nullopt;
  return Loading{*pending_, seconds_since(pending_since_)};
}

void SceneLoader::run(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    std::string source;
    {
      std::unique_lock lock(mutex_);
      if (!requested_.wait(lock, stop, [this] { return request_.has_value(); })) return;
      source = *std::exchange(request_, std::nullopt);
    }
    LoadOutcome outcome = load_and_prepare(source);
    {
      const std::scoped_lock lock(mutex_);
      if (request_) continue;  // replaced meanwhile
      outcome_ = std::move(outcome);
      pending_.reset();
    }
    if (wake_) wake_();
  }
}

LoadOutcome SceneLoader::load_and_prepare(const std::string& source) const {
  LoadOutcome outcome{source, std::shared_ptr<const RenderScene>(), 0.0};
  // Memory can run out anywhere in a large scene; that is an error to show, not an end.
  try {
    const auto start = std::chrono::steady_clock::now();
    const Result<Scene> scene = load_(source);
    outcome.load_seconds = seconds_since(start);
    if (scene) {
      outcome.scene = prepare(*scene, forced_);
    } else {
      outcome.scene = unexpected(scene.error());
    }
  } catch (const std::bad_alloc&) {
    outcome.scene = unexpected(Error{source, "not enough memory to load this scene"});
  } catch (const std::exception& e) {
    outcome.scene = unexpected(Error{source, e.what()});
  }
  return outcome;
}

}  // namespace asos
