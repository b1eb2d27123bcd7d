#include "ui/scene_loader.h"

#include "renderer/prepared/default_look.h"
#include "renderer/prepared/own_lights.h"
#include "renderer/prepared/prepare_on_ground.h"
#include "renderer/scene/posable_scene.h"
#include "renderer/scene/source_files.h"
#include "ui/hidden_objects.h"

#include <cctype>
#include <exception>
#include <filesystem>
#include <utility>

namespace asos::ui {

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

bool is_picture(const std::string& source) {
  std::string ending = std::filesystem::path(source).extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending == ".png" || ending == ".exr";
}

Result<PictureDescription> read_picture(const std::string& source) {
  auto picture = read_description(source);
  if (!picture) return picture;
  auto sky = make_sky(picture->sky);
  if (!sky) return unexpected(sky.error());
  picture->settings.sky = *std::move(sky);
  return picture;
}

SceneSource source_of(const PictureDescription& picture, const std::string& asset_root) {
  const LoadOptions options = picture.load_options();
  return {picture.scene, options.variant, options.scene, {}, {}, asset_root, true};
}

ChooseGround ground_of_source(const SceneSource& source) {
  return [ground = source.ground](const World& world, bool dark) {
    return GroundChoice{ground ? *ground : likely_ground(world, dark, first_camera(world))};
  };
}

Result<std::shared_ptr<const RenderScene>> prepare_at(const Scene& scene, const SceneSource& source,
                                                      const RenderFeatures& forced) {
  const bool moves = source.clip.any() && scene.rig;  // the load function may not have kept it
  const ChooseGround choose = ground_of_source(source);
  auto at_rest = prepare_on_ground(scene, forced, nullptr, moves ? nullptr : choose);
  if (!at_rest || !source.clip.any()) return at_rest;
  const auto time = clip_time(scene.contents, scene.source, source.clip);
  if (!time) return unexpected(time.error());
  if (!moves) return at_rest;
  const Result<Scene> posed = scene.rig->pose(*time);
  if (!posed) return unexpected(posed.error());
  return prepare_on_ground(*posed, forced, &(*at_rest)->geometry->stage, choose);
}

/// Hides the objects of the source in a prepared scene.
void hide_in(LoadOutcome& outcome, std::shared_ptr<const RenderScene> whole,
             const SceneSource& source) {
  outcome.scene = scene_without(whole, source.hidden);
  if (outcome.scene && !source.hidden.empty()) outcome.whole = std::move(whole);
}

void load_into(LoadOutcome& outcome, const LoadFunction& load, const RenderFeatures& forced,
               const SceneSource& asked) {
  const auto start = std::chrono::steady_clock::now();
  if (asked.known) {
    outcome.read = false;
    return hide_in(outcome, asked.known, asked);
  }
  if (is_picture(outcome.source)) {
    Result<PictureDescription> picture = read_picture(outcome.source);
    if (!picture) {
      outcome.scene = unexpected(picture.error());
      return;
    }
    outcome.picture = *std::move(picture);
  }
  const SceneSource source =
      outcome.picture ? source_of(*outcome.picture, asked.asset_root) : asked;
  for (const std::string& file : source_files(source, source.asset_root))
    outcome.files.push_back(FileStamp::of(file));
  Result<Scene> scene = load(source);
  if (!scene || !scene->notes.warnings.empty())
    outcome.outer_root = outer_asset_root(source, source.asset_root);
  outcome.load_seconds = seconds_since(start);
  if (scene && source.images_only) {
    outcome.images = std::make_shared<const Scene>(*std::move(scene));
    return;
  }
  if (!scene) {
    outcome.scene = unexpected(
        outcome.picture ? scene_of_picture_error(outcome.source, scene.error()) : scene.error());
  } else {
    outcome.scene =
        outcome.picture ? prepare(*scene, *outcome.picture) : prepare_at(*scene, source, forced);
    if (outcome.scene && !source.hidden.empty()) hide_in(outcome, *outcome.scene, source);
    // Paints the environment on this thread; the window's thread would stall.
    if (outcome.scene) (void)default_look(**outcome.scene);
  }
}

LoadOutcome load_and_prepare(const LoadFunction& load, const RenderFeatures& forced,
                             const SceneSource& source, LoadProgress& progress) {
  const LoadProgress::Scope scope(&progress);
  if (!source.whole && !is_picture(source.path)) progress.allow_missing_textures();
  LoadOutcome outcome{source.path, std::shared_ptr<const RenderScene>()};
  // A large scene can run out of memory anywhere. This is reported as an error and does not end the
  // program.
  try {
    load_into(outcome, load, forced, source);
  } catch (const LoadStopped&) {
    outcome.scene = unexpected(Error{source.path, "its loading was stopped"});
  } catch (const std::bad_alloc&) {
    outcome.scene = unexpected(Error{source.path, "not enough memory to load this scene"});
  } catch (const std::exception& e) {
    outcome.scene = unexpected(Error{source.path, e.what()});
  }
  outcome.textures_missing = progress.missing_textures();
  outcome.preview = progress.preview();
  return outcome;
}

}  // namespace

SceneLoader::SceneLoader(LoadFunction load, std::function<void()> wake,
                         const RenderFeatures& forced)
    : wake_(wake),
      job_(
          [load = std::move(load), forced](const Request& request) {
            return load_and_prepare(load, forced, request.source, *request.progress);
          },
          std::move(wake), Overtaken::dropped) {}

void SceneLoader::stop() {
  if (progress_) progress_->stop();
}

void SceneLoader::open(SceneSource source) {
  stop();
  progress_ = std::make_shared<LoadProgress>(wake_);
  source_ = source.path;
  since_ = std::chrono::steady_clock::now();
  job_.ask({std::move(source), progress_});
}

std::optional<LoadOutcome> SceneLoader::take_outcome() {
  return job_.take_outcome();
}

std::optional<SceneLoader::Loading> SceneLoader::loading() const {
  if (!job_.pending()) return std::nullopt;
  return Loading{source_, seconds_since(since_), progress_->stage(), progress_->preview(),
                 progress_->decoded_textures()};
}

}  // namespace asos::ui
