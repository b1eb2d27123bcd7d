#include "ui/pixel_report.h"

#include "renderer/files/counted.h"
#include "renderer/film/split_map.h"
#include "renderer/pyray/hit_list.h"
#include "ui/previewer.h"
#include "ui/snapshot_view.h"

#include <fmt/format.h>

#include <algorithm>

namespace asos::ui {

namespace {

std::string size_words(const TracedPyray& pyray) {
  return fmt::format("{:.3g} % of pixel, {}", 100.0 * pyray.weight,
                     counted(pyray.cells.size(), "cell"));
}

std::string visibility_words(double visible) {
  if (visible >= 0.9995) return "visible";
  return visible > 0.0 ? fmt::format("{:.2g} % visible", 100.0 * visible) : "hidden";
}

std::string name_of_pyray(const RenderScene& scene, const TracedPyray& pyray) {
  if (pyray.kind == TracedPyray::Kind::mirror)
    return fmt::format("mirror {} ({})", pyray.bounces + 1, size_words(pyray));
  const std::string& name = scene.lights()[pyray.light].name;
  return shadow_words(name.empty() ? fmt::format("light {}", pyray.light + 1) : name, pyray);
}

/// Name of the part that a smooth surface belongs to.
std::string object_name(const RenderScene& scene, std::uint32_t smooth_surface) {
  if (smooth_surface == ObjectStatistics::clusters) return "small edges";
  const World& world = scene.world();
  for (std::uint32_t t = 0; t < world.triangles.size(); ++t) {
    if (scene.features().smooth_surface(t) != smooth_surface) continue;
    const std::uint32_t part = world.triangle_part[t];
    return world.parts[part].name.empty() ? fmt::format("part {}", part + 1)
                                          : world.parts[part].name;
  }
  return "a shape";
}

std::string strongest_object(const RenderScene& scene, const LevelStatistics& level) {
  const auto strongest = std::max_element(
      level.objects.begin(), level.objects.end(),
      [&](const auto& a, const auto& b) { return a.change(level.level) < b.change(level.level); });
  return strongest == level.objects.end() ? "" : object_name(scene, strongest->object);
}

std::set<std::uint32_t> unlit_triangles(const World& world, const std::vector<TracedCell>& cells) {
  std::set<std::uint32_t> found;
  for (const TracedCell& cell : cells)
    for (const TracedSample& sample : cell.samples)
      if (sample.triangle < world.triangles.size() && world.material_of(sample.triangle).unlit)
        found.insert(sample.triangle);
  return found;
}

/// Finds all edges in the hit list of the whole picture, visible or hidden.
void find_boundaries(const RenderScene& scene, const View& view, PixelReport& report) {
  const glm::vec2 size(static_cast<float>(view.width()), static_cast<float>(view.height()));
  const Square whole;
  HitLists lists;
  // Edges smaller than a quarter of a pixel are not drawn.
  lists.reset(scene.features(), view.frame(0.0, 0.0, view.width(), view.height()),
              0.25f / std::max(size.x, size.y));
  HitLists::List open, found;
  lists.refine(whole, {}, lists.root(), open);
  for (const std::uint32_t i : open) {
    report.all_boundaries = lists.resolve(i, whole, 0.25f / std::max(size.x, size.y),
                                          PixelReport::most_boundaries, found) &&
                            report.all_boundaries;
    if (!report.all_boundaries) break;
  }
  for (const std::uint32_t i : found) {
    if (report.boundaries.size() >= PixelReport::most_boundaries) break;
    const Segment& s = lists.segment(i);
    report.boundaries.push_back({glm::vec2(s.u0, s.v0) * size, glm::vec2(s.u1, s.v1) * size,
                                 lists.kind(i).value_or(FeatureKind::open)});
  }
}

}  // namespace

std::string shadow_words(const std::string& light, const TracedPyray& pyray) {
  const std::string visible = visibility_words(static_cast<double>(pyray.result.x));
  constexpr double least_weight = 5e-6;  // less is written as 0 %
  if (pyray.weight < least_weight) return fmt::format("{}: {}, adds nothing here", light, visible);
  return fmt::format("{}: {} ({})", light, visible, size_words(pyray));
}

const char* words_of(CellFate fate) {
  switch (fate) {
    case CellFate::uniform:
      return "no edge: one sample";
    case CellFate::cut:
      return "cut along its edges";
    case CellFate::uneven:
      return "varying shading: split";
    case CellFate::split:
      return "edge: split";
    case CellFate::stopped:
      return "edge below EPS: one sample";
    case CellFate::finest:
      return "edge at MAX: one sample";
    case CellFate::sampled:
      return "no edge: sampled";
    case CellFate::saturated:
      return "too many edges: sampled";
    case CellFate::by_samples:
      break;
  }
  return "samples differ: split";
}

std::string edge_words(const TracedCell& cell) {
  std::string words = counted(cell.boundaries.size(), "edge");
  if (cell.clusters > 0) words += ", " + counted(cell.clusters, "unresolved group");
  if (cell.hidden > 0) words += ", " + counted(cell.hidden, "hidden edge");
  return words;
}

std::string PixelReport::split() const {
  return split_words(trace.level, trace.cause, trace.samples);
}

std::string PixelReport::verdict() const {
  const auto any = [&](CellFate fate) {
    return std::any_of(trace.cells.begin(), trace.cells.end(),
                       [&](const TracedCell& cell) { return cell.fate == fate; });
  };
  const double unresolved = 100.0 * trace.unresolved_area;
  if (trace.missed) return "Split without an edge: its neighbours show other surfaces.";
  if (any(CellFate::finest))
    return fmt::format("MAX reached: {:.2f} % of the pixel is unresolved.", unresolved);
  if (any(CellFate::stopped))
    return fmt::format("Stopped by EPS: {:.2f} % of the pixel is unresolved.", unresolved);
  if (any(CellFate::saturated)) return "Too many edges: sampled instead.";
  if (trace.cause == SplitCause::none) {
    const bool one = trace.cells.size() == 1 && trace.cells.front().fate == CellFate::uniform;
    return one ? "Not split: no edge, one sample is enough."
               : "Not split: no edge; its samples agree.";
  }
  const bool by_edges = any(CellFate::cut) || any(CellFate::split);
  const bool by_shading = any(CellFate::uneven) || trace.samples > 0;
  if (by_edges && by_shading) return "Split along its edges and for varying shading.";
  if (by_shading) return "Split for varying shading.";
  if (trace.cells.size() == 1 && !by_edges)
    return "One cell; an edge in a shadow or mirror cuts it.";
  return "Exact: every cell is free of edges or cut along them.";
}

std::size_t cell_at(const std::vector<TracedCell>& cells, glm::vec2 place) {
  std::size_t found = 0;
  // Cells are sorted by level, so the last one that contains the point is the smallest.
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const TracedCell& cell = cells[i];
    const glm::vec2 in = place - cell.corner;
    if (in.x >= 0.0f && in.y >= 0.0f && in.x < cell.side && in.y < cell.side) found = i;
  }
  return found;
}

PixelInspector::PixelInspector() : job_(work, {}, Overtaken::kept) {}

void PixelInspector::update(const Previewer& previewer, std::optional<glm::ivec2> picked,
                            bool boundaries) {
  if (std::optional<PixelReport> report = job_.take_outcome()) report_ = std::move(*report);
  const RenderSettings& settings = previewer.render().settings();
  const bool inside = picked && picked->x < settings.width && picked->y < settings.height;
  if (!inside || !previewer.scene() || previewer.render().restarts() == 0) {
    report_.reset();
    asked_ = {};
    return;
  }
  const Asked wanted{previewer.scene().get(), previewer.viewpoint().camera().revision(), settings,
                     picked, boundaries};
  if (report_ && report_->pixel != *picked) report_.reset();
  if (wanted == asked_ || !previewer.scene()->geometry->boundaries.known_or_started()) return;
  asked_ = wanted;
  job_.ask({{previewer.scene().shared(), previewer.viewpoint().camera().camera(), settings},
            *picked,
            boundaries});
}

PixelReport PixelInspector::work(const Request& request) {
  const RenderScene& scene = *request.picture.scene;
  const RenderSettings& settings = request.picture.settings;
  const View view = view_of(request.picture);
  PixelReport report;
  report.pixel = request.pixel;
  report.settings = as_published(settings);
  report.trace = trace_pixel(scene, view, settings, request.pixel.x, request.pixel.y);
  for (const LevelStatistics& level : report.trace.levels)
    report.level_object.push_back(strongest_object(scene, level));
  report.seen = seen_parts(report.trace.cells);
  report.unlit = unlit_triangles(scene.world(), report.trace.cells);
  for (const TracedPyray& pyray : report.trace.pyrays) {
    report.pyray_seen.push_back(seen_parts(pyray.cells));
    report.pyray_names.push_back(name_of_pyray(scene, pyray));
  }
  if (request.with_boundaries) find_boundaries(scene, view, report);
  return report;
}

}  // namespace asos::ui
