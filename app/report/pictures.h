#pragma once

#include "app/report/study_report.h"
#include "renderer/result.h"

#include <optional>
#include <string>
#include <vector>

namespace asos {

/// A picture of a scene, beside its errors.
struct ShownPicture {
  std::string label;    ///< method and setting, or "reference"
  std::string picture;  ///< PNG files
  std::string errors;   ///< empty for the reference
  const StudyPoint* point = nullptr;
};

struct ScenePictures {
  std::vector<ShownPicture> shown;  ///< the reference first
  std::string levels;               ///< how deep ASOS splits, why, and the regions
  std::string causes;
  std::string regions;
  double error_scale = 0.0;  ///< a pixel's error that the error maps show at their brightest
};

/// The colour of an error map at `share`, 0 to 1, of its scale: darker is better, in grey, too.
[[nodiscard]] glm::u8vec3 error_colour(double share);
[[nodiscard]] glm::u8vec3 region_colour(Region region);

/// ASOS as the program has it unless told otherwise.
inline constexpr const char* anchor_setting = "MAX 3 EPS 1/256";

/// The point of a study that pictures are compared at: ASOS as the program has it unless told
/// otherwise, or else a setting in the middle. Nothing for a study without points.
[[nodiscard]] const StudyPoint* anchor_of(const SceneStudy& study);

/// The points that are shown side by side: of each method the one that takes most nearly as long as
/// the anchor.
[[nodiscard]] std::vector<const StudyPoint*> alike_in_time(const SceneStudy& study);

/// Writes a scene's pictures as PNG files. `scene` has to outlive the result.
[[nodiscard]] Result<ScenePictures> write_pictures(const SceneReport& scene,
                                                   const std::string& folder,
                                                   const std::string& name);

}  // namespace asos
