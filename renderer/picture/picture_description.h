#pragma once

#include "renderer/film/image_io.h"
#include "renderer/film/split_map.h"
#include "renderer/film/tone.h"
#include "renderer/gltf/load.h"
#include "renderer/prepared/prepare_on_ground.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/result.h"
#include "renderer/scene/scene.h"
#include "renderer/settings/settings.h"
#include "renderer/shading/sky_choice.h"
#include "renderer/world/render_features.h"

#include <glm/glm.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asos {

/// How a picture was displayed.
struct PictureDisplay {
  float exposure_ev = 0.0f;  ///< stops
  bool split_map = false;    ///< over the picture
  SplitMapColours split_colours = SplitMapColours::level;
  float split_dimming = 0.0f;
  ToneCurve tone = ToneCurve::none;

  [[nodiscard]] DisplayTransform transform() const { return {exposure_ev, tone}; }
  bool operator==(const PictureDisplay&) const = default;
};

/// Everything that determines a picture: with this and the scene's file it can be rendered again,
/// bit for bit. It is stored in pictures' files as strict JSON: missing, unknown or out-of-range
/// fields are errors. A new setting increases `format`.
struct PictureDescription {
  static constexpr int format = 1;
  static constexpr const char* key = "asos.picture";  ///< key of the text in PNG and EXR files

  std::string scene;       ///< "builtin:NAME", or a path, which `describe` makes absolute
  std::string variant;     ///< one of the scene's material variants (LoadOptions); empty: none
  int scene_number = -1;   ///< one of the file's scenes; -1: the default
  glm::dvec3 origin{0.0};  ///< World::origin, the reference of camera and lights
  Camera camera;
  RenderSettings settings;
  SkyChoice sky;  ///< the sky for `settings`, if these have none yet
  FeatureChoice render_features = FeatureChoice::scene;
  std::optional<std::vector<Light>> lights;  ///< replace the scene's lights; none: the scene's own
  std::optional<MaterialDfrs> dfrs;          ///< replace the materials' ratios; none: kept
  std::optional<ClipTime> time;              ///< of animations; none: the scene at rest
  PictureDisplay display;
  /// Warnings about files that `read_description` found next to the picture.
  std::vector<std::string> found_beside;

  /// Returns how to open the scene's file.
  [[nodiscard]] LoadOptions load_options() const;
  /// Returns the camera, or the lights, relative to another origin.
  [[nodiscard]] Camera camera_from(glm::dvec3 other_origin) const;
  [[nodiscard]] std::vector<Light> lights_from(glm::dvec3 other_origin) const;
};

/// Returns the description of a picture of `scene` with its present lighting.
[[nodiscard]] PictureDescription describe(const RenderScene& scene, const Camera& camera,
                                          const RenderSettings& settings,
                                          const PictureDisplay& display);

/// Returns the JSON, as one line of valid UTF-8.
[[nodiscard]] std::string description_text(const PictureDescription& description);
/// Parses a description. Errors describe the fault; their subject is `file`.
[[nodiscard]] Result<PictureDescription> parse_description(const std::string& text,
                                                           const std::string& file);

/// Reads the description in a PNG or an EXR file. Searches next to the picture for a scene or a sky
/// that no longer exists at its path. Errors have the file's name.
[[nodiscard]] Result<PictureDescription> read_description(const std::string& path);

/// Returns an error that says why the scene of the picture in `file` could not be loaded.
[[nodiscard]] Error scene_of_picture_error(const std::string& file, const Error& error);

/// Prepares a loaded scene with the picture's lighting, ground and blur; the settings must have
/// their sky. If the picture is of another time, the scene must be at rest and have its rig. Errors
/// have the scene's file name.
[[nodiscard]] Result<std::shared_ptr<const RenderScene>> prepare(
    const Scene& scene, const PictureDescription& description);
/// Prepares a scene that is already posed at the picture's time, with the invariants of the scene
/// at rest; null: with its own. `choose`: the ground to build it with; null: none.
[[nodiscard]] Result<std::shared_ptr<const RenderScene>> prepare_posed(
    const Scene& scene, const PictureDescription& description, const AnimationInvariants* stage,
    const ChooseGround& choose = nullptr);

}  // namespace asos
