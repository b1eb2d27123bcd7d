#pragma once

#include "app/picture_options.h"
#include "renderer/film/split_map.h"

#include <string>

namespace asos {

/// What `asos render` was asked for.
struct RenderArguments {
  PictureArguments picture;
  std::string output;
  std::string split_map;  ///< empty: not asked for
  SplitMapColours split_map_by = SplitMapColours::level;
  std::string stats_file;  ///< empty: not asked for
  bool quiet = false;
};

}  // namespace asos
