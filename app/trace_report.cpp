#include "app/trace_report.h"

#include "renderer/files/counted.h"
#include "renderer/film/split_map.h"
#include "renderer/picture/settings_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <map>

namespace asos {
namespace {

using Json = nlohmann::ordered_json;

Json place_json(glm::vec2 p) {
  return {p.x, p.y};
}

Json colour_json(glm::vec3 c) {
  return {c.x, c.y, c.z};
}

const char* name_of(FeatureKind kind) {
  switch (kind) {
    case FeatureKind::open:
      return "open edge";
    case FeatureKind::crease:
      return "crease";
    case FeatureKind::seam:
      return "seam";
    case FeatureKind::intersection:
      return "intersection";
    case FeatureKind::cut_out:
      return "cut-out";
    case FeatureKind::silhouette:
      break;
  }
  return "silhouette";
}

/// Names objects by part and material; a part with several smooth surfaces also gets a number, from
/// 1.
class Namer {
 public:
  explicit Namer(const RenderScene& scene) : scene_(scene) {
    const World& world = scene.world();
    for (std::uint32_t t = 0; t < world.surface_count(); ++t) {
      const std::uint32_t smooth_surface = scene.features().smooth_surface(t);
      const std::uint32_t part = world.triangle_part[t];
      if (first_triangle_.try_emplace(smooth_surface, t).second)
        number_[smooth_surface] = ++count_[part];
    }
  }

  [[nodiscard]] std::string of_triangle(std::uint32_t triangle) const {
    if (triangle == Hit::none) return "background";
    return name_of_surface(scene_.features().smooth_surface(triangle));
  }

  [[nodiscard]] std::string name_of_surface(std::uint32_t smooth_surface) const {
    if (smooth_surface == ObjectStatistics::clusters) return "small edges, not resolved";
    const World& world = scene_.world();
    const std::uint32_t triangle = first_triangle_.at(smooth_surface);
    const std::uint32_t part = world.triangle_part[triangle];
    const std::string& material = world.material_of(triangle).name;
    std::string name = world.parts[part].name;
    if (name.empty()) name = fmt::format("part {}", part);
    if (!material.empty() && material != name) name += fmt::format(" ({})", material);
    if (count_.at(part) > 1) name += fmt::format(" #{}", number_.at(smooth_surface));
    return name;
  }

 private:
  const RenderScene& scene_;
  std::map<std::uint32_t, std::uint32_t> first_triangle_;  // of a smooth surface
  std::map<std::uint32_t, std::uint32_t> number_;          // of a smooth surface in its part
  std::map<std::uint32_t, std::uint32_t> count_;           // smooth surfaces of a part
};

Json level_json(const LevelStatistics& level, const Namer& namer) {
  Json objects = Json::array();
  for (const ObjectStatistics& object : level.objects) {
    objects.push_back({{"object", namer.name_of_surface(object.object)},
                       {"in", object.in},
                       {"out", object.out},
                       {"larger", object.larger()},
                       {"share", std::ldexp(object.larger(), -2 * level.level)},
                       {"one_edge", object.one_edge},
                       {"change", object.change(level.level)}});
  }
  return {{"level", level.level},
          {"cells", 1u << (2 * level.level)},
          {"marginal", level.marginal},
          {"unresolved_area", level.unresolved_area()},
          {"largest_change", level.largest_change()},
          {"objects", std::move(objects)}};
}

Json cell_json(const TracedCell& cell, const Namer& namer) {
  Json boundaries = Json::array();
  for (const TracedBoundary& b : cell.boundaries)
    boundaries.push_back(
        {{"kind", name_of(b.kind)}, {"from", place_json(b.from)}, {"to", place_json(b.to)}});
  Json samples = Json::array();
  for (const TracedSample& s : cell.samples) {
    samples.push_back({{"at", place_json(s.at)},
                       {"weight", s.weight},
                       {"radiance", colour_json(s.radiance)},
                       {"object", namer.of_triangle(s.triangle)},
                       {"triangle", s.triangle == Hit::none ? Json(nullptr) : Json(s.triangle)}});
  }
  return {{"level", cell.level},
          {"corner", place_json(cell.corner)},
          {"side", cell.side},
          {"fate", name_of(cell.fate)},
          {"boundaries", std::move(boundaries)},
          {"clusters", cell.clusters},
          {"hidden", cell.hidden},
          {"samples", std::move(samples)}};
}

const char* name_of(TracedPyray::Kind kind) {
  switch (kind) {
    case TracedPyray::Kind::shadow:
      return "shadow";
    case TracedPyray::Kind::mirror:
      return "mirror";
    case TracedPyray::Kind::eye:
      break;
  }
  return "eye";
}

Json cells_json(const std::vector<TracedCell>& cells, const Namer& namer) {
  Json list = Json::array();
  for (const TracedCell& cell : cells) list.push_back(cell_json(cell, namer));
  return list;
}

Json pyray_json(const TracedPyray& pyray, const RenderScene& scene, const Namer& namer) {
  Json light = nullptr;
  if (pyray.kind == TracedPyray::Kind::shadow) light = scene.lights()[pyray.light].name;
  return {{"kind", name_of(pyray.kind)},
          {"light", std::move(light)},
          {"bounces", pyray.bounces},
          {"parent", pyray.parent < 0 ? Json(nullptr) : Json(pyray.parent)},
          {"from", place_json(pyray.from)},
          {"weight", pyray.weight},
          {"result", colour_json(pyray.result)},
          {"cells", cells_json(pyray.cells, namer)}};
}

std::string text_of(const Json& value) {
  return value.get<std::string>();
}

// Truncates to a number of characters, not within a multi-byte one.
std::string fitted(const std::string& text, std::size_t columns) {
  std::size_t characters = 0, end = text.size();
  for (std::size_t i = 0; i < text.size(); ++i) {
    if ((static_cast<unsigned char>(text[i]) & 0xc0u) == 0x80u) continue;
    if (characters + 3 == columns) end = i;
    if (++characters > columns) return text.substr(0, end) + "...";
  }
  return text;
}

std::string place_text(const Json& p) {
  return fmt::format("{:6.4f} {:6.4f}", p[0].get<double>(), p[1].get<double>());
}

// Non-finite values are null in the JSON.
std::string colour_text(const Json& c) {
  std::string text;
  for (const Json& value : c) {
    if (!text.empty()) text += ' ';
    text += value.is_number() ? fmt::format("{:6.4f}", value.get<double>()) : "     -";
  }
  return text;
}

std::string moment_text(const Json& moment) {
  if (moment.is_null()) return {};
  const double seconds = moment["seconds"].get<double>();
  const double shutter = moment["shutter"].get<double>();
  std::string text =
      fmt::format(", animation {} at {:.4g} s", moment["animation"].get<int>(), seconds);
  if (shutter > 0.0)
    text += fmt::format(
        "\nOne moment of the exposure, its middle: the shutter is open from {:.4g} to {:.4g} s",
        seconds - 0.5 * shutter, seconds + 0.5 * shutter);
  return text;
}

std::string head_text(const Json& trace) {
  const Json& s = trace["settings"];
  std::string text = fmt::format("Pixel {},{} of {} at {}x{}", trace["pixel"][0].get<int>(),
                                 trace["pixel"][1].get<int>(), text_of(trace["scene"]),
                                 trace["size"][0].get<int>(), trace["size"][1].get<int>());
  if (const std::string camera = text_of(trace["camera"]); !camera.empty())
    text += fmt::format(", camera {}", camera);
  text += moment_text(trace["moment"]);
  const double width = s["filter_width"].get<double>();
  text += fmt::format("\n{}: MAX {}, EPS {:.4g}, {} rule, detection by the {}, {} leaves{}{}\n",
                      text_of(s["method"]), s["max_level"].get<int>(), s["eps"].get<double>(),
                      text_of(s["rule"]), text_of(s["detect"]), text_of(s["leaf"]),
                      s["jitter"].get<bool>() ? ", jittered" : "",
                      width > 1.0 ? fmt::format(", filter {:.4g} pixels wide", width) : "");
  text += fmt::format("Colour {} (linear), unresolved area {:.4g}\n",
                      colour_text(trace["radiance"]), trace["unresolved_area"].get<double>());
  text += "In the split map: " + text_of(trace["split"]) + "\n";
  if (trace["missed_split"].get<bool>())
    text += "Edge not found: its samples differ from a neighbour's, but no edge is near.\n";
  return text;
}

// The table of GI'93 with a line per object; values of the whole level are in its first line.
std::string levels_text(const Json& levels) {
  if (levels.empty()) return "\nNo cell is marginal.\n";
  std::string text =
      fmt::format("\n{:>2} {:>5} {:>6} {:>7}  {:<34} {:>5} {:>5} {:>5} {:>7}  {}\n", "K", "M",
                  "2^2K", "M/2^2K", "object", "in", "out", "L", "L/2^2K", "one edge");
  for (const Json& level : levels) {
    std::string start = fmt::format("{:>2} {:>5} {:>6} {:>7.4f}  ", level["level"].get<int>(),
                                    level["marginal"].get<int>(), level["cells"].get<int>(),
                                    level["unresolved_area"].get<double>());
    for (const Json& object : level["objects"]) {
      text += fmt::format(
          "{}{:<34} {:>5} {:>5} {:>5} {:>7.4f}  {}\n", start, fitted(text_of(object["object"]), 34),
          object["in"].get<int>(), object["out"].get<int>(), object["larger"].get<int>(),
          object["share"].get<double>(), object["one_edge"].get<bool>() ? "yes: L/2" : "no");
      start.assign(start.size(), ' ');
    }
    if (level["objects"].empty()) text += start + "\n";
  }
  return text;
}

std::string cell_text(const Json& cell) {
  const int clusters = cell["clusters"].get<int>(), hidden = cell["hidden"].get<int>();
  std::string text =
      fmt::format("{:>2}  {}  1/{:<4} {}", cell["level"].get<int>(), place_text(cell["corner"]),
                  std::lround(1.0 / cell["side"].get<double>()), text_of(cell["fate"]));
  if (clusters > 0)
    text += fmt::format(", {} of edges not resolved",
                        counted(static_cast<std::uint64_t>(clusters), "group"));
  if (hidden > 0) text += fmt::format(", {} hidden", hidden);
  text += "\n";
  for (const Json& b : cell["boundaries"])
    text += fmt::format("      {:<12} {} to {}\n", text_of(b["kind"]), place_text(b["from"]),
                        place_text(b["to"]));
  for (const Json& s : cell["samples"])
    text += fmt::format("      {:<12} {}  weight {:6.4f}  {}  {}\n", "sample", place_text(s["at"]),
                        s["weight"].get<double>(), colour_text(s["radiance"]),
                        fitted(text_of(s["object"]), 28));
  return text;
}

// One line per pyray, below the one whose leaf started it.
std::string pyrays_text(const Json& pyrays) {
  if (pyrays.empty()) return "";
  std::string text = fmt::format("\n{:>3} {:>4}  {:<6} {:<13}  {:<6}  {:>5}  {:<20}  {}\n", "No",
                                 "by", "pyray", "from", "weight", "cells", "result", "light");
  for (std::size_t i = 0; i < pyrays.size(); ++i) {
    const Json& p = pyrays[i];
    text += fmt::format("{:>3} {:>4}  {:<6} {}  {:6.4f}  {:>5}  {}", i,
                        p["parent"].is_null() ? "-" : fmt::format("{}", p["parent"].get<int>()),
                        text_of(p["kind"]), place_text(p["from"]), p["weight"].get<double>(),
                        p["cells"].size(), colour_text(p["result"]));
    if (!p["light"].is_null()) text += "  " + fitted(text_of(p["light"]), 22);
    text += "\n";
  }
  return text;
}

Json moment_json(const TracedPicture& picture) {
  if (!picture.time) return nullptr;
  return {{"animation", picture.time->animation},
          {"seconds", picture.time->seconds},
          {"shutter", picture.settings.shutter.seconds}};
}

}  // namespace

Json trace_json(const PixelTrace& trace, const RenderScene& scene, const TracedPicture& picture) {
  const Namer namer(scene);
  Json levels = Json::array();
  for (const LevelStatistics& level : trace.levels) levels.push_back(level_json(level, namer));
  Json pyrays = Json::array();
  for (const TracedPyray& pyray : trace.pyrays) pyrays.push_back(pyray_json(pyray, scene, namer));
  return {{"scene", picture.scene},
          {"camera", picture.camera},
          {"moment", moment_json(picture)},
          {"size", {picture.settings.width, picture.settings.height}},
          {"pixel", {trace.x, trace.y}},
          {"settings", settings_json(picture.settings)},
          {"radiance", colour_json(trace.radiance)},
          {"unresolved_area", trace.unresolved_area},
          {"level", trace.level},
          {"cause", name_of(trace.cause)},
          {"split", split_words(trace.level, trace.cause, trace.samples)},
          {"samples", trace.samples},
          {"missed_split", trace.missed},
          {"levels", std::move(levels)},
          {"cells", cells_json(trace.cells, namer)},
          {"pyrays", std::move(pyrays)}};
}

std::string trace_text(const Json& trace) {
  std::string text = head_text(trace) + levels_text(trace["levels"]);
  text += fmt::format("\n{:>2}  {:<13}  {:<6} {}\n", "K", "corner", "side", "cell");
  for (const Json& cell : trace["cells"]) text += cell_text(cell);
  return text + pyrays_text(trace["pyrays"]);
}

}  // namespace asos
