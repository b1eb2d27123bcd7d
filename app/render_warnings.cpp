#include "app/render_warnings.h"

#include "renderer/files/counted.h"
#include "renderer/scene/scene_warnings.h"
#include "renderer/shading/sky_warning.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <utility>

namespace asos {

void tell_warnings(RenderReport& report, const RenderScene& scene, const SkyChoice& sky) {
  const SceneNotes notes = notes_of(scene);
  report.warnings = scene_warnings(notes);
  report.warning_count = count_warnings(notes);
  if (std::string remark = sky_warning(sky.file); !remark.empty()) {
    report.warnings.insert(report.warnings.begin(), std::move(remark));
    ++report.warning_count;
  }
}

void warn_of_cut_stacks(RenderReport& report) {
  if (report.statistics.cut_stacks == 0) return;
  report.warnings.insert(report.warnings.begin(),
                         fmt::format("{} passed 1,024 surfaces that are seen through; what "
                                     "lies behind those is left out",
                                     counted(report.statistics.cut_stacks, "ray")));
  ++report.warning_count;
}

void say_warnings(const RenderReport& report, std::ostream& err) {
  constexpr std::size_t most_lines = 10;
  const std::size_t said = std::min(report.warnings.size(), most_lines);
  for (std::size_t i = 0; i < said; ++i) err << "asos: warning: " << report.warnings[i] << "\n";
  if (report.warning_count > said)
    err << fmt::format("asos: warning: and {} more\n", report.warning_count - said);
}

}  // namespace asos
