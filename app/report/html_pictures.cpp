#include "app/report/html_page.h"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace asos {
namespace {

std::string chip(glm::u8vec3 colour, const std::string& word) {
  return fmt::format(
      "<span class=\"key\"><span class=\"chip\" style=\"background:rgb({},{},{})\"></span>{}"
      "</span> ",
      colour.x, colour.y, colour.z, escaped(word));
}

std::string legend_of_maps(int which) {
  std::string text;
  if (which == 0) {
    text += chip(split_colour(0), "not split") + chip(exact_colour, "exact") +
            chip(sampled_colour, "sampled");
    const int max_level = region_settings({}).asos.max_level;
    for (int level = 1; level <= max_level; ++level)
      text += chip(split_colour(level), fmt::format("level {}", level));
  } else if (which == 1) {
    for (std::size_t i = 0; i < split_cause_count; ++i)
      text += chip(split_cause_colour(static_cast<SplitCause>(i)), split_cause_names[i]);
  } else {
    for (std::size_t i = 0; i < region_count; ++i)
      text += chip(region_colour(static_cast<Region>(i)), region_names[i]);
  }
  return text;
}

}  // namespace

std::string html_pictures(const SceneReport& scene, const ScenePictures& pictures,
                          std::size_t number, Embedder& embed) {
  std::string shown;
  std::string errors;
  for (const ShownPicture& p : pictures.shown) {
    const std::string label =
        p.point ? fmt::format("{} ({}, RMSE {})", p.label, seconds_text(p.point->seconds()),
                              shown_error(*p.point))
                : fmt::format("reference ({} samples a pixel)",
                              count_text(static_cast<std::uint64_t>(scene.samples)));
    shown += fmt::format(
        "<figure><img data-label=\"{0}\" alt=\"{0}\" src=\"{1}\"><figcaption>{0}"
        "</figcaption></figure>\n",
        escaped(label), embed.uri(p.picture));
    if (!p.errors.empty())
      errors += fmt::format(
          "<figure><img data-label=\"errors of {0}\" alt=\"errors of {0}\" "
          "src=\"{1}\"><figcaption>errors of {0}</figcaption></figure>\n",
          escaped(p.label), embed.uri(p.errors));
  }
  std::string maps;
  const std::array<std::pair<const std::string*, const char*>, 3> files{
      {{&pictures.levels, "split map: how deep ASOS split a pixel"},
       {&pictures.causes, "split map: why"},
       {&pictures.regions, "regions"}}};
  for (std::size_t i = 0; i < files.size(); ++i)
    maps += fmt::format(
        "<figure><img data-label=\"{0}\" alt=\"{0}\" src=\"{1}\"><figcaption>{0}:"
        "<br>{2}</figcaption></figure>\n",
        files[i].second, embed.uri(*files[i].first), legend_of_maps(static_cast<int>(i)));
  return fmt::format(
      "<h3>Pictures</h3>\n<p class=\"note\">Of each method the setting that takes most nearly as "
      "long as ASOS's; their times and errors are beside them.</p>\n"
      "<div class=\"tool\" data-pictures=\"pictures{0}\" hidden>\n<p><label>Left <select></select>"
      "</label> <label>Right <select></select></label></p>\n<div class=\"slider\"><img alt=\"\">"
      "<img class=\"over\" alt=\"\"><div class=\"line\"></div></div>\n<input type=\"range\" "
      "min=\"0\" max=\"100\" value=\"50\" aria-label=\"how much of the left picture is shown\">\n"
      "</div>\n<div id=\"pictures{0}\">\n<div class=\"grid\">\n{1}</div>\n"
      "<p class=\"note\">A pixel's error, all maps on one scale: 0<span class=\"ramp\"></span>{2} "
      "and more.</p>\n<div class=\"grid\">\n{3}</div>\n<p class=\"note\">What ASOS does at MAX 4, "
      "EPS 1/256, and the regions that the errors are sorted by.</p>\n<div class=\"grid\">\n{4}"
      "</div>\n</div>\n",
      number, shown, error_text(pictures.error_scale), errors, maps);
}

}  // namespace asos
