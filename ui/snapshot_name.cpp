#include "ui/snapshot_name.h"

#include "renderer/comparison/method.h"
#include "renderer/study/ladders.h"

#include <fmt/format.h>

namespace asos::ui {

std::string snapshot_name(const RenderSettings& settings, double cpu_seconds) {
  const MethodRow& method = row_of(settings.method);
  std::string name = method.title;
  if (method.in_object_space || method.samples_by_eps) {
    name += ", EPS " + eps_text(settings.asos.eps);
    if (settings.asos.max_level != AsosSettings{}.max_level)
      name += fmt::format(", MAX {}", settings.asos.max_level);
    return name;
  }
  if (method.samples != SampleCount::none) name += fmt::format(", {} spp", settings.sampling.spp);
  name += cpu_seconds < 10.0 ? fmt::format(", {:.2g} s", cpu_seconds)
                             : fmt::format(", {:.0f} s", cpu_seconds);
  return name;
}

}  // namespace asos::ui
