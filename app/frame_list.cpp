#include "app/frame_list.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace asos {
namespace {

/// Renames all output files of a picture.
RenderArguments renamed(const RenderArguments& arguments,
                        const std::function<std::string(const std::string&)>& name) {
  RenderArguments one = arguments;
  for (std::string* path : {&one.output, &one.split_map, &one.stats_file})
    if (!path->empty()) *path = name(*path);
  return one;
}

double end_of(const SceneContents& contents, const ClipTime& time) {
  return contents.animations[static_cast<std::size_t>(time.animation)].seconds;
}

}  // namespace

std::vector<FrameRequest> frames_of(const RenderArguments& arguments, const SceneContents& contents,
                                    const std::optional<ClipTime>& time) {
  std::vector<FrameRequest> frames;
  if (arguments.turn) {
    for (int i = arguments.turn->first; i <= arguments.turn->last; ++i)
      frames.push_back({CameraTurn{i, arguments.turn->count}, {}, time});
  } else if (arguments.clip_frames && time) {
    const ClipFrames& wanted = *arguments.clip_frames;
    // An animation's end is a float, so allow for rounding: a frame at the end counts.
    const double to_end = std::floor(end_of(contents, *time) * wanted.fps + 1e-4);
    const int last = wanted.last.value_or(static_cast<int>(std::min<double>(to_end, most_frames)));
    for (int i = wanted.first; i <= last; ++i)
      frames.push_back({{}, i, ClipTime{time->animation, i / wanted.fps}});
  } else {
    frames.push_back({{}, {}, time});
  }
  return frames;
}

FrameRequest first_frame(const RenderArguments& arguments) {
  if (arguments.turn) return {CameraTurn{arguments.turn->first, arguments.turn->count}, {}, {}};
  if (arguments.clip_frames) return {{}, arguments.clip_frames->first, {}};
  return {};
}

RenderArguments arguments_of(const RenderArguments& arguments, const FrameRequest& frame) {
  RenderArguments one = renamed(arguments, [&](const std::string& path) {
    if (frame.turn) return frame_path(path, frame.turn->frame, frame.turn->count);
    return frame.of_clip ? clip_frame_path(path, *frame.of_clip) : path;
  });
  one.picture.camera.turn = frame.turn;
  return one;
}

std::size_t beyond_the_end(const std::vector<FrameRequest>& frames, const SceneContents& contents) {
  return static_cast<std::size_t>(
      std::count_if(frames.begin(), frames.end(), [&](const FrameRequest& f) {
        return f.time && f.time->seconds > end_of(contents, *f.time) + 1e-6;
      }));
}

}  // namespace asos
