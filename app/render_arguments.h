#pragma once

#include "app/picture_options.h"
#include "app/turntable.h"
#include "renderer/film/exr_options.h"
#include "renderer/film/split_map.h"

#include <optional>
#include <string>

namespace asos {

/// The arguments of `asos render`.
struct RenderArguments {
  PictureArguments picture;
  std::string output;
  std::string frames;                     ///< as typed; empty: one picture
  std::optional<FrameRange> turn;         ///< frames of a turn around the scene, one file each
  std::optional<ClipFrames> clip_frames;  ///< frames of an animation, one file each
  std::string split_map;                  ///< empty: not asked for
  SplitMapColours split_map_by = SplitMapColours::level;
  bool layers_chosen = false;  ///< false: for an EXR, those of the picture given by --from
  ExrCompression compression = ExrCompression::zip;
  std::string stats_file;                    ///< empty: not asked for
  std::optional<double> time_limit_seconds;  ///< of rendering
  bool allow_empty = false;                  ///< render a scene without anything to draw
  bool quiet = false;
};

}  // namespace asos
