#include "ui/scene_loader.h"

#include <exception>
#include <utility>

namespace asos {

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

LoadOutcome load_and_prepare(const LoadFunction& load, const SceneNeeds& forced,
                             const std::string& source) {
  LoadOutcome outcome{source, std::shared_ptr<const RenderScene>(), 0.0};
  // Memory can run out anywhere in a large scene; that is an error to show, not an end.
  try {
    const auto start = std::chrono::steady_clock::now();
    const Result<Scene> scene = load(source);
    outcome.load_seconds = seconds_since(start);
    if (scene) {
      outcome.scene = prepare(*scene, forced);
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

}  // namespace

SceneLoader::SceneLoader(LoadFunction load, std::function<void()> wake, const SceneNeeds& forced)
    : job_([load = std::move(load),
            forced](const std::string& source) { return load_and_prepare(load, forced, source); },
           std::move(wake), Overtaken::dropped) {}

void SceneLoader::open(std::string source) {
  source_ = source;
  since_ = std::chrono::steady_clock::now();
  job_.ask(std::move(source));
}

std::optional<LoadOutcome> SceneLoader::take_outcome() {
  return job_.take_outcome();
}

std::optional<SceneLoader::Loading> SceneLoader::loading() const {
  if (!job_.pending()) return std::nullopt;
  return Loading{source_, seconds_since(since_)};
}

}  // namespace asos
