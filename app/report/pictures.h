#pragma once

#include "app/report/study_report.h"
#include "renderer/result.h"

#include <optional>
#include <string>
#include <vector>

namespace asos {

/// A picture of a scene, with its errors.
struct ShownPicture {
  std::string label;    ///< method and setting, or "reference"
  std::string picture;  ///< PNG files
  std::string errors;   ///< empty for the reference
  const StudyPoint* point = nullptr;
};

struct ScenePictures {
  std::vector<ShownPicture> shown;  ///< the reference first
  std::string levels;               ///< ASOS's levels, causes and regions
  std::string causes;
  std::string regions;
  double error_scale = 0.0;  ///< a pixel's error at the error maps' maximum
};

/// Colour of an error map at `share`, 0 to 1, of its scale. Darker is better, in grey, too.
[[nodiscard]] glm::u8vec3 error_colour(double share);
[[nodiscard]] glm::u8vec3 region_colour(Region region);

/// Whether a step is ASOS with the program's default MAX and EPS.
[[nodiscard]] bool is_anchor(const LadderStep& step);

/// The point of a study at which pictures are compared: ASOS with the program's defaults, or else a
/// setting in the middle. Null: there are no points.
[[nodiscard]] const StudyPoint* anchor_of(const SceneStudy& study);

/// Points to show side by side: for each method the one whose time is most similar to the anchor's.
[[nodiscard]] std::vector<const StudyPoint*> alike_in_time(const SceneStudy& study);

/// Writes a scene's pictures as PNG files. `scene` must outlive the result.
[[nodiscard]] Result<ScenePictures> write_pictures(const SceneReport& scene,
                                                   const std::string& folder,
                                                   const std::string& name);

}  // namespace asos
