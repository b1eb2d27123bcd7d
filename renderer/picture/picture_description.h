#pragma once

#include "renderer/film/image_io.h"
#include "renderer/film/split_map.h"
#include "renderer/film/tone.h"
#include "renderer/gltf/load.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/result.h"
#include "renderer/scene/scene.h"
#include "renderer/settings/settings.h"
#include "renderer/shading/sky_choice.h"
#include "renderer/world/needs.h"

#include <glm/glm.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asos {

/// How a picture was shown.
struct PictureDisplay {
  float exposure_ev = 0.0f;  ///< stops
  bool split_map = false;    ///< over the picture
  SplitMapColours split_colours = SplitMapColours::level;
  float split_dimming = 0.0f;
  ToneCurve tone = ToneCurve::none;

  [[nodiscard]] DisplayTransform transform() const { return {exposure_ev, tone}; }
  bool operator==(const PictureDisplay&) const = default;
};

/// Everything that a picture follows from: who has the scene's file and this can render it again,
/// bit for bit. Travels inside pictures' files as JSON, which is strict: what is missing, unknown
/// or out of range is an error. A setting that is added raises `format`.
struct PictureDescription {
  static constexpr int format = 1;
  static constexpr const char* key = "asos.picture";  ///< of the text in PNG and EXR files

  std::string scene;       ///< "builtin:NAME", or a path, which `describe` makes absolute
  std::string variant;     ///< of the scene's materials (LoadOptions); empty: none
  int scene_number = -1;   ///< of the file's scenes, where it is not its default; -1: that
  glm::dvec3 origin{0.0};  ///< World::origin, which camera and lights are relative to
  Camera camera;
  RenderSettings settings;
  SkyChoice sky;  ///< the sky for `settings`, where that has none yet
  NeedsChoice needs = NeedsChoice::scene;
  std::optional<std::vector<Light>> lights;  ///< in place of the scene's own; none: its own
  std::optional<MaterialDfrs> dfrs;          ///< in place of its materials' own; none: their own
  std::optional<ClipTime> time;              ///< of what moves; none: as the file's nodes place it
  PictureDisplay display;
  /// Remarks on files that `read_description` found beside the picture.
  std::vector<std::string> found_beside;

  /// How the scene's file is opened.
  [[nodiscard]] LoadOptions load_options() const;
  /// The camera and the lights relative to another origin.
  [[nodiscard]] Camera camera_from(glm::dvec3 other_origin) const;
  [[nodiscard]] std::vector<Light> lights_from(glm::dvec3 other_origin) const;
};

/// The description of a picture of `scene` as it is lit now.
[[nodiscard]] PictureDescription describe(const RenderScene& scene, const Camera& camera,
                                          const RenderSettings& settings,
                                          const PictureDisplay& display);

/// The JSON, in one line of valid UTF-8.
[[nodiscard]] std::string description_text(const PictureDescription& description);
/// Errors: what is wrong with it; the subject is `file`.
[[nodiscard]] Result<PictureDescription> parse_description(const std::string& text,
                                                           const std::string& file);

/// The description that a PNG or an EXR file holds. Looks beside the picture for a scene or a
/// sky that is gone from its place. Errors name the file.
[[nodiscard]] Result<PictureDescription> read_description(const std::string& path);

/// Why the scene of the picture in `file` could not be loaded.
[[nodiscard]] Error scene_of_picture_error(const std::string& file, const Error& error);

/// The scene that was loaded, at rest and with its rig where the picture is of another time, made
/// ready, lit and blurring as the picture says, whose settings have their sky. Errors name its
/// file.
[[nodiscard]] Result<std::shared_ptr<const RenderScene>> prepare(
    const Scene& scene, const PictureDescription& description);
/// The same of a scene that is at the picture's time already, on the stage of the one at rest;
/// null: on its own.
[[nodiscard]] Result<std::shared_ptr<const RenderScene>> prepare_posed(
    const Scene& scene, const PictureDescription& description, const Stage* stage);

}  // namespace asos
