#include "renderer/methods/settings.h"

#include <fmt/format.h>

namespace asos {
namespace {

constexpr int max_side = 32768;
constexpr int max_spp = 65536;
constexpr int max_threads = 1024;

struct Range {
  const char* name;
  int value;
  int lo;
  int hi;
};

}  // namespace

Result<RenderSettings> validated(const RenderSettings& s) {
  for (const Range& r : {Range{"width", s.width, 1, max_side},
                         {"height", s.height, 1, max_side},
                         {"max", s.max_level, 0, RenderSettings::max_level_limit},
                         {"spp", s.spp, 1, max_spp},
                         {"threads", s.threads, 0, max_threads}}) {
    if (r.value < r.lo || r.value > r.hi) {
      return unexpected(Error{r.name, fmt::format("{} is not from {} to {}", r.value, r.lo, r.hi)});
    }
  }
  // The comparison is written so that NaN fails it.
  if (!(s.eps >= 0.0 && s.eps <= 1.0)) {
    return unexpected(Error{"eps", fmt::format("{} is not from 0 to 1", s.eps)});
  }
  const bool known_method = s.method == Method::asos || s.method == Method::uniform ||
                            s.method == Method::stochastic || s.method == Method::beam;
  if (!known_method) return unexpected(Error{"method", "is not one of the program's"});
  if (s.leaf != Leaf::exact && s.leaf != Leaf::point) {
    return unexpected(Error{"leaf", "is neither exact nor point"});
  }
  if (s.crop == PixelRect{}) return s;
  const PixelRect c = s.crop;
  const auto name = [&] { return fmt::format("{},{},{},{}", c.x, c.y, c.width, c.height); };
  if (c.empty()) return unexpected(Error{"crop", name() + " is empty"});
  // Written as differences, which cannot overflow.
  if (c.x < 0 || c.y < 0 || c.width > s.width - c.x || c.height > s.height - c.y) {
    return unexpected(Error{"crop", fmt::format("{} does not lie within the picture of {} x {}",
                                                name(), s.width, s.height)});
  }
  return s;
}

}  // namespace asos
