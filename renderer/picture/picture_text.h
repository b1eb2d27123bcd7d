#pragma once

#include "renderer/film/image_io.h"
#include "renderer/film/statistics.h"
#include "renderer/picture/picture_description.h"

#include <nlohmann/json_fwd.hpp>

namespace asos {

/// What was counted while a picture was rendered, but for the counts by light.
[[nodiscard]] nlohmann::ordered_json counts_json(const RenderStatistics& counts);

/// What a picture's file says of itself: the program and the description.
[[nodiscard]] ImageText picture_text(const PictureDescription& description);
/// The same, and `statistics` as JSON.
[[nodiscard]] ImageText picture_text(const PictureDescription& description,
                                     const nlohmann::ordered_json& statistics);

}  // namespace asos
