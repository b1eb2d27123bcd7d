#pragma once

#include "renderer/geometry/view.h"
#include "renderer/result.h"
#include "renderer/scene/scene.h"
#include "renderer/settings/background.h"
#include "renderer/shading/sky_choice.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <string_view>

// Parsers for values on the command line. They are locale-independent and must consume the whole
// text. Errors for values out of range state the range. The error's subject is the text itself.

namespace asos {

struct PictureSize {
  int width = 0;
  int height = 0;
};

struct LookAt {
  glm::dvec3 eye{0.0};
  glm::dvec3 target{0.0};
};

/// A finite number from lo to hi; with `open`, strictly between them.
[[nodiscard]] Result<double> parse_number(std::string_view text, double lo, double hi,
                                          bool open = false);
/// A whole number from lo to hi.
[[nodiscard]] Result<int> parse_whole(std::string_view text, int lo, int hi);
/// "WxH", both from 1 to `limit`.
[[nodiscard]] Result<PictureSize> parse_size(std::string_view text, int limit);
/// "x,y,w,h": a rectangle with w and h of at least 1.
[[nodiscard]] Result<PixelRect> parse_rect(std::string_view text, int limit);
/// "x,y": a pixel, both 0 or more.
[[nodiscard]] Result<glm::ivec2> parse_pixel(std::string_view text);
/// "ex,ey,ez,tx,ty,tz": two points that differ.
[[nodiscard]] Result<LookAt> parse_look_at(std::string_view text);
/// "MIN,MAX,N": one curve for all colours; MIN and MAX from 0 to 1, N from 0 to 1e6.
[[nodiscard]] Result<Dfr> parse_dfr(std::string_view text);
/// "neutral", "R,G,B", "R,G,B:R,G,B" (zenith and horizon; linear, 0 to 1e6) or the name of a file
/// that ends in .hdr or .exr, which is not opened.
[[nodiscard]] Result<SkyChoice> parse_sky(std::string_view text);
/// Stops, -32 to 32; none: "auto".
[[nodiscard]] Result<std::optional<float>> parse_exposure(std::string_view text);
/// "environment", "blurred", "transparent", "R,G,B" or "R,G,B:R,G,B" (from the picture's upper to
/// its lower border; linear, 0 to 1e6).
[[nodiscard]] Result<Background> parse_background(std::string_view text);

}  // namespace asos
