#include "renderer/settings/value_text.h"

#include "renderer/geometry/coordinates.h"
#include "renderer/settings/names.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace asos {
namespace {

tl::unexpected<Error> refuse_text(std::string_view text, std::string reason) {
  return tl::unexpected(Error{fmt::format("\"{}\"", text), std::move(reason)});
}

// std::from_chars is locale-independent, but does not accept a leading plus, which users type.
template <typename T>
std::optional<T> read_all(std::string_view text) {
  if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
  T value{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

// Parses "a,b,c" with exactly N parts of type T.
template <typename T, std::size_t N>
std::optional<std::array<T, N>> read_list(std::string_view text, char separator) {
  std::array<T, N> values{};
  for (std::size_t i = 0; i < N; ++i) {
    const std::size_t end = text.find(separator);
    if ((end == std::string_view::npos) != (i + 1 == N)) return std::nullopt;
    const std::optional<T> value = read_all<T>(text.substr(0, end));
    if (!value) return std::nullopt;
    values[i] = *value;
    text.remove_prefix(i + 1 == N ? text.size() : end + 1);
  }
  return values;
}

}  // namespace

Result<double> parse_number(std::string_view text, double lo, double hi, bool open) {
  const std::optional<double> value = read_all<double>(text);
  if (!value || !std::isfinite(*value)) return refuse_text(text, "not a finite number");
  const bool inside = open ? *value > lo && *value < hi : *value >= lo && *value <= hi;
  if (!inside)
    return refuse_text(
        text, fmt::format("has to be {} {} and {}", open ? "strictly between" : "between", lo, hi));
  return *value;
}

Result<int> parse_whole(std::string_view text, int lo, int hi) {
  const std::optional<int> value = read_all<int>(text);
  if (!value || *value < lo || *value > hi) {
    if (hi == std::numeric_limits<int>::max())
      return refuse_text(text, fmt::format("not a whole number from {} on", lo));
    return refuse_text(text, fmt::format("not a whole number from {} to {}", lo, hi));
  }
  return *value;
}

Result<PictureSize> parse_size(std::string_view text, int limit) {
  const auto values = read_list<int, 2>(text, 'x');
  if (!values) return refuse_text(text, "not a size in pixels such as 1280x720");
  for (const int value : *values)
    if (value < 1 || value > limit)
      return refuse_text(text,
                         fmt::format("width and height have to be from 1 to {} pixels", limit));
  return PictureSize{(*values)[0], (*values)[1]};
}

Result<PixelRect> parse_rect(std::string_view text, int limit) {
  const auto values = read_list<int, 4>(text, ',');
  if (!values) return refuse_text(text, "not a rectangle in pixels such as 100,50,64,48 (x,y,w,h)");
  const PixelRect rect{(*values)[0], (*values)[1], (*values)[2], (*values)[3]};
  if (rect.x < 0 || rect.y < 0 || rect.width < 1 || rect.height < 1 || rect.x >= limit ||
      rect.y >= limit || rect.width > limit || rect.height > limit)
    return refuse_text(text,
                       "x and y have to be 0 or more, w and h 1 or more, and inside the picture");
  return rect;
}

Result<glm::ivec2> parse_pixel(std::string_view text) {
  const auto values = read_list<int, 2>(text, ',');
  if (!values) return refuse_text(text, "not a pixel such as 160,90 (x,y)");
  const glm::ivec2 pixel((*values)[0], (*values)[1]);
  if (pixel.x < 0 || pixel.y < 0)
    return refuse_text(text, "x and y count from 0 at the picture's top left corner");
  return pixel;
}

Result<LookAt> parse_look_at(std::string_view text) {
  const auto values = read_list<double, 6>(text, ',');
  if (!values) return refuse_text(text, "not six numbers such as 4,2,4,0,1,0 (eye, then target)");
  const auto& v = *values;
  const LookAt look{{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
  if (!within_reach(look.eye) || !within_reach(look.target))
    return refuse_text(
        text, fmt::format("coordinates have to be finite and within {:g}", largest_coordinate));
  if (look.eye == look.target) return refuse_text(text, "eye and target are the same point");
  return look;
}

Result<Dfr> parse_dfr(std::string_view text) {
  const auto values = read_list<double, 3>(text, ',');
  if (!values) return refuse_text(text, "not three numbers such as 0.05,1,32 (DFRMIN, DFRMAX, N)");
  const auto& v = *values;
  const auto within = [](double x, double hi) { return x >= 0.0 && x <= hi; };
  constexpr double largest_exponent = 1e6;
  if (!within(v[0], 1.0) || !within(v[1], 1.0) || !within(v[2], largest_exponent))
    return refuse_text(text, "DFRMIN and DFRMAX have to be from 0 to 1, N from 0 to 1e6");
  Dfr dfr;
  dfr.rgb.fill({v[0], v[1], v[2]});
  return dfr;
}

Result<std::pair<glm::vec3, glm::vec3>> parse_colours(std::string_view text,
                                                      const char* otherwise) {
  constexpr float brightest = 1e6f;
  const std::size_t colon = text.find(':');
  const auto first = read_list<float, 3>(text.substr(0, colon), ',');
  const auto second =
      colon == std::string_view::npos ? first : read_list<float, 3>(text.substr(colon + 1), ',');
  if (!first || !second) return refuse_text(text, otherwise);
  for (const auto& colour : {*first, *second})
    for (const float value : colour)
      if (!(value >= 0.0f && value <= brightest))
        return refuse_text(text, fmt::format("colours have to be from 0 to {}", brightest));
  const auto& a = *first;
  const auto& b = *second;
  return std::pair{glm::vec3(a[0], a[1], a[2]), glm::vec3(b[0], b[1], b[2])};
}

Result<std::optional<float>> parse_exposure(std::string_view text) {
  if (text == "auto") return std::optional<float>();
  return parse_number(text, -32.0, 32.0).map([](double ev) {
    return std::optional<float>(static_cast<float>(ev));
  });
}

Result<Background> parse_background(std::string_view text) {
  Background background;
  for (const auto& kind : background_names) {
    if (kind.value == BackgroundKind::colours || text != kind.name) continue;
    background.kind = kind.value;
    return background;
  }
  const auto colours =
      parse_colours(text,
                    "not environment, blurred, transparent, R,G,B such as 0.3,0.5,0.9 or "
                    "R,G,B:R,G,B (from the picture's upper to its lower border)");
  if (!colours) return tl::unexpected(colours.error());
  background.kind = BackgroundKind::colours;
  background.top = colours->first;
  background.bottom = colours->second;
  return background;
}

}  // namespace asos
