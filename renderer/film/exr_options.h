#pragma once

#include "renderer/film/layers.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

namespace asos {

/// `zip` is lossless. `dwaa` is lossy for colours; all else goes to a second, lossless part.
enum class ExrCompression { zip, dwaa };
struct NamedExrCompression {
  ExrCompression value;
  const char* name;
};
inline constexpr std::array exr_compression_names{
    NamedExrCompression{ExrCompression::zip, "zip"},
    NamedExrCompression{ExrCompression::dwaa, "dwaa"}};

/// The place of a film in a whole picture, in pixels: OpenEXR's data window in its display window.
struct ExrWindow {
  int width = 0;  ///< of the whole picture
  int height = 0;
  int x = 0;  ///< of the film's upper left pixel
  int y = 0;
};

/// The contents of an EXR in addition to radiance and text.
struct ExrOptions {
  std::optional<ExrWindow> window;  ///< none: the film is the whole picture
  ExrCompression compression = ExrCompression::zip;
  LayerSet layers;                            ///< to write, if the film has them
  std::vector<std::string> object_names;      ///< by id; "": none
  std::vector<std::string> asset_names;       ///< of the assets that objects belong to, by object
  std::vector<std::string> material_names;    ///< as object_names
  std::optional<glm::dmat4> world_to_camera;  ///< in OpenEXR's convention: left-handed, +z ahead
  std::optional<glm::dmat4> world_to_ndc;     ///< to 0..1, y down, after the division by w
  std::optional<double> frames_a_second;      ///< of the sequence that the picture belongs to
};

}  // namespace asos
