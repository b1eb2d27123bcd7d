#pragma once

#include "app/report/study_report.h"
#include "renderer/film/image_io.h"
#include "renderer/result.h"

#include <algorithm>
#include <cmath>
#include <limits>
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

/// The point at which pictures are compared: ASOS with the program's defaults, or else a setting in
/// the middle. Null: there are no points.
template <typename Point>
[[nodiscard]] const Point* anchor_of(const std::vector<Point>& points) {
  std::vector<const Point*> asos;
  for (const Point& p : points) {
    if (p.rung.method != "asos") continue;
    if (is_anchor(p.rung)) return &p;
    asos.push_back(&p);
  }
  if (!asos.empty()) return asos[asos.size() / 2];
  return points.empty() ? nullptr : &points[points.size() / 2];
}

/// Points to show side by side: the anchor, and for each other method the one whose time is most
/// similar.
template <typename Point>
[[nodiscard]] std::vector<const Point*> alike_in_time(const std::vector<Point>& points) {
  std::vector<const Point*> chosen;
  const Point* anchor = anchor_of(points);
  const auto distance = [&](const Point& p) {
    return p.rung.method == anchor->rung.method && &p != anchor
               ? std::numeric_limits<double>::infinity()
               : std::abs(std::log(p.seconds() / anchor->seconds()));
  };
  for (const Point& p : points) {
    const auto same = std::find_if(chosen.begin(), chosen.end(),
                                   [&](const Point* c) { return c->rung.method == p.rung.method; });
    if (same == chosen.end())
      chosen.push_back(&p);
    else if (distance(p) < distance(**same))
      *same = &p;
  }
  return chosen;
}

/// Writes a map with one colour for each pixel, row by row.
template <typename Colour>
[[nodiscard]] Result<void> write_map(const std::string& path, int width, int height,
                                     Colour colour_of) {
  RgbImage image{width, height, {}, {}};
  const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  image.rgb.reserve(3 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const glm::u8vec3 colour = colour_of(i);
    image.rgb.insert(image.rgb.end(), {colour.x, colour.y, colour.z});
  }
  return write_png(path, image);
}

/// FOLDER/NAME-WHAT.
[[nodiscard]] std::string figure_path(const std::string& folder, const std::string& name,
                                      const std::string& what);

/// Writes a scene's pictures as PNG files. `scene` must outlive the result.
[[nodiscard]] Result<ScenePictures> write_pictures(const SceneReport& scene,
                                                   const std::string& folder,
                                                   const std::string& name);

}  // namespace asos
