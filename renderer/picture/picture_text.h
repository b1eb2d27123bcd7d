#pragma once

#include "renderer/film/image_io.h"
#include "renderer/film/statistics.h"
#include "renderer/picture/picture_description.h"

#include <nlohmann/json_fwd.hpp>

namespace asos {

/// Returns the counts of a picture's rendering, without those by light.
[[nodiscard]] nlohmann::ordered_json counts_json(const RenderStatistics& counts);

/// Returns the text in a picture's file: the program and the description.
[[nodiscard]] ImageText picture_text(const PictureDescription& description);
/// Returns this text, with `statistics` as JSON.
[[nodiscard]] ImageText picture_text(const PictureDescription& description,
                                     const nlohmann::ordered_json& statistics);

}  // namespace asos
