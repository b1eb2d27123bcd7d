#include "app/render_messages.h"

#include "renderer/files/counted.h"
#include "renderer/files/printable.h"

#include <fmt/format.h>

#include <ostream>

namespace asos {

Error nothing_drawn(const RenderReport& report) {
  const std::string why = report.warnings.empty() ? "" : " (" + report.warnings.back() + ")";
  return {
      report.scene,
      fmt::format("there is nothing in it to draw{}; --allow-empty renders it all the same", why)};
}

void say_note(const std::string& note, std::ostream& err) {
  err << "asos: note: " << note << "\n";
}

void say_written(const RenderArguments& arguments, const RenderReport& report, std::ostream& out) {
  if (report.kept) {
    out << fmt::format("Kept {}, which has these settings.\n", printable(arguments.output));
    return;
  }
  out << fmt::format(
      "Wrote {}: {}, load {:.2f} s, build {:.2f} s, render {:.2f} s{}.\n",
      printable(arguments.output), counted(report.triangles, "triangle"), report.load_seconds,
      report.build_seconds, report.render_seconds,
      report.stopped_at
          ? fmt::format(", {}: {}", report.interrupted ? "interrupted" : "stopped by --time-limit",
                        reached_text(*report.stopped_at))
          : "");
}

void say_nothing_visible(const RenderArguments& arguments, const RenderReport& report,
                         const FrameRequest& frame, std::ostream& err) {
  if (!report.shows_nothing) return;
  err << fmt::format("asos: note: nothing is visible at {:.4g} s; {} shows the background\n",
                     frame.time->seconds, printable(arguments.output));
}

void say_notes(const RenderArguments& arguments, const std::vector<FrameRequest>& frames,
               const OpenedScene& scene, std::ostream& err) {
  const auto& from = arguments.picture.from;
  if (from && from->display.split_map)
    err << "asos: note: " << printable(arguments.picture.from_file)
        << " shows the split map; the picture is rendered without it\n";
  if (from && from->scene == arguments.picture.scene)
    for (const std::string& remark : from->found_beside) say_note(remark, err);
  const CameraChoice& camera = arguments.picture.camera;
  const bool of_file = !arguments.picture.scene.starts_with("builtin:");
  if (of_file && scene.cameras() > 1 && !camera.index && !camera.look_at && !from)
    err << fmt::format(
        "asos: note: using the first of the file's {} cameras; --camera N chooses another\n",
        scene.cameras());
  if (const std::size_t beyond = beyond_the_end(frames, scene.contents()); beyond > 0)
    err << fmt::format(
        "asos: note: {} of {} are after the animation's end and show its last pose\n", beyond,
        counted(frames.size(), "picture"));
}

}  // namespace asos
