#include "app/scene_info.h"

#include "app/printed_json.h"
#include "renderer/files/counted.h"
#include "renderer/lights/light_kinds.h"
#include "renderer/lights/prepared_light.h"
#include "renderer/scene/environment_cube.h"
#include "renderer/scene/scene_warnings.h"

#include <fmt/format.h>
#include <glm/gtc/constants.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace asos {
namespace {

using Json = nlohmann::ordered_json;

Json vector_json(glm::dvec3 v) {
  return {v.x, v.y, v.z};
}

Json bounds_json(const World& world) {
  if (world.bounds.empty()) return nullptr;
  return {{"min", vector_json(world.origin + glm::dvec3(world.bounds.lo))},
          {"max", vector_json(world.origin + glm::dvec3(world.bounds.hi))}};
}

/// Counts every light under its type, and those with a size by LightTraits::sized as well.
Json lights_json(const Scene& scene) {
  const auto count = [&scene](auto wanted) {
    return std::count_if(scene.lights.begin(), scene.lights.end(), wanted);
  };
  Json counts;
  for (const auto& [name, type] : light_type_names)
    counts[name] = count([wanted = type](const Light& light) { return light.type == wanted; });
  for (const LightTraits& traits : light_traits) {
    const auto alike = [&](const Light& light) {
      return &traits_of(light_shape(light)) == &traits;
    };
    if (traits.sized) counts[traits.sized] = count(alike);
  }
  return counts;
}

Json lens_json(const Camera& camera) {
  const Lens& lens = camera.lens;
  return {{"aperture", lens.radius},
          {"f_stop", f_stop_of_aperture(lens.radius, camera.fov_y_rad)},
          {"focus", lens.focus ? Json(*lens.focus) : Json(nullptr)},
          {"blades", lens.blades}};
}

Json cameras_json(const Scene& scene) {
  Json cameras = Json::array();
  for (const Camera& camera : scene.cameras) {
    const bool perspective = camera.type == Camera::Type::perspective;
    Json entry{{"name", camera.name},
               {"type", perspective ? "perspective" : "orthographic"},
               {"position", vector_json(glm::dvec3(camera.world_from_camera[3]))}};
    if (perspective)
      entry["fov_y_degrees"] = camera.fov_y_rad * 180.0 / glm::pi<double>();
    else
      entry["height"] = camera.height;
    if (camera.lens.blurs()) entry["lens"] = lens_json(camera);
    cameras.push_back(std::move(entry));
  }
  return cameras;
}

Json animations_json(const SceneContents& contents) {
  Json animations = Json::array();
  for (const SceneContents::Animation& a : contents.animations)
    animations.push_back({{"name", a.name},
                          {"seconds", a.seconds},
                          {"channels", a.channels},
                          {"channels_read", a.moving}});
  return animations;
}

/// Animations, skins and morph targets of the file, with its variants and scenes.
Json contents_json(const SceneContents& contents) {
  Json skins = Json::array(), morphs = Json::array();
  for (const SceneContents::Skin& skin : contents.skins)
    skins.push_back({{"name", skin.name}, {"joints", skin.joints}});
  for (const SceneContents::Morph& morph : contents.morphs)
    morphs.push_back({{"mesh", morph.mesh}, {"targets", morph.targets}});
  return {{"animations", animations_json(contents)},
          {"skins", std::move(skins)},
          {"morphs", std::move(morphs)},
          {"variants", contents.variants},
          {"scenes", contents.scenes},
          {"shown_scene", contents.shown_scene},
          {"default_scene", contents.default_scene}};
}

std::string quoted(const Json& name) {
  return name.get<std::string>().empty() ? "" : "\"" + name.get<std::string>() + "\", ";
}

/// Formats one line per entry with `line(index, entry)`, up to `most`, and the number of those left
/// out.
template <typename Line>
std::string lines_of(const Json& list, std::size_t most, Line line) {
  const std::size_t told = std::min(list.size(), most);
  std::string text;
  for (std::size_t i = 0; i < told; ++i) text += line(i, list[i]);
  if (told < list.size())
    text += fmt::format("  ... and {} more, which --all lists\n", list.size() - told);
  return text;
}

/// A line with the number of entries and one for each; nothing for an empty list.
template <typename Line>
std::string numbered_lines(const char* title, const Json& list, std::size_t most, Line line) {
  if (list.empty()) return "";
  return fmt::format("{:<12}{}\n", fmt::format("{}:", title), list.size()) +
         lines_of(list, most, [&](std::size_t i, const Json& entry) {
           return fmt::format("  {}: {}\n", i, line(entry));
         });
}

std::string contents_lines(const Json& info, std::size_t most) {
  const auto number = [](const Json& n) { return n.get<std::uint64_t>(); };
  std::string text = numbered_lines("Animations", info["animations"], most, [&](const Json& a) {
    const std::uint64_t channels = number(a["channels"]), read = number(a["channels_read"]);
    return fmt::format("{}{:.4g} s, {}{}", quoted(a["name"]), a["seconds"].get<double>(),
                       counted(channels, "channel"),
                       read < channels ? fmt::format(", of which {} are read", read) : "");
  });
  text += numbered_lines("Skins", info["skins"], most, [&](const Json& skin) {
    return quoted(skin["name"]) + counted(number(skin["joints"]), "joint");
  });
  text += numbered_lines("Morphs", info["morphs"], most, [&](const Json& morph) {
    return quoted(morph["mesh"]) + counted(number(morph["targets"]), "target");
  });
  const auto name = [](const Json& n) {
    return n.get<std::string>().empty() ? std::string("without a name")
                                        : "\"" + n.get<std::string>() + "\"";
  };
  text += numbered_lines("Variants", info["variants"], most, name);
  const Json& scenes = info["scenes"];
  if (scenes.size() < 2) return text;
  text += fmt::format("Scenes:     {}\n", scenes.size());
  return text + lines_of(scenes, most, [&](std::size_t i, const Json& scene) {
           return fmt::format("  {}: {}{}\n", i, name(scene),
                              info["shown_scene"] == i ? ", the one described here" : "");
         });
}

std::string list(const Json& names, std::size_t most) {
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i)
    text += (text.empty() ? "" : ", ") + names[i].get<std::string>();
  if (names.size() > most) text += fmt::format(" and {} more", names.size() - most);
  return text;
}

std::string lens_words(const Json& lens) {
  const Json& focus = lens["focus"];
  return fmt::format(
      ", lens of radius {:.4g} (f/{:.3g} in metres), {}", lens["aperture"].get<double>(),
      lens["f_stop"].get<double>(),
      focus.is_null() ? "automatic focus" : fmt::format("focus at {:.6g}", focus.get<double>()));
}

std::string camera_line(std::size_t index, const Json& camera) {
  const std::string name = camera["name"];
  const std::string extent =
      camera.contains("fov_y_degrees")
          ? fmt::format("field of view {:.4g} degrees", camera["fov_y_degrees"].get<double>())
          : fmt::format("height {:.6g}", camera["height"].get<double>());
  return fmt::format("  {}: {}{}, {}{}\n", index, name.empty() ? "" : "\"" + name + "\", ",
                     camera["type"].get<std::string>(), extent,
                     camera.contains("lens") ? lens_words(camera["lens"]) : "");
}

std::string bounds_line(const Json& bounds) {
  if (bounds.is_null()) return "Bounds:     none, nothing is drawn\n";
  const auto corner = [](const Json& v) {
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", v[0].get<double>(), v[1].get<double>(),
                       v[2].get<double>());
  };
  return fmt::format("Bounds:     {} to {}, in the file's units\n", corner(bounds["min"]),
                     corner(bounds["max"]));
}

std::string lights_line(const Json& lights, bool surroundings) {
  std::string text, sized;
  for (const auto& [type, count] : lights.items()) {
    if (count.get<int>() == 0) continue;
    const bool of_these = std::any_of(light_traits.begin(), light_traits.end(),
                                      [&](const auto& t) { return t.sized && type == t.sized; });
    std::string& part = of_these ? sized : text;
    part += fmt::format("{}{} {}", part.empty() ? "" : ", ", count.get<int>(), type);
  }
  if (text.empty())
    text = surroundings ? "none but its surroundings" : "none, the default rig is used";
  if (!sized.empty()) text += fmt::format(" (of these with a size: {})", sized);
  return fmt::format("Lights:     {}\n", text);
}

std::string left_out_line(const Json& left_out) {
  std::string text = fmt::format("  {}: {}", left_out["feature"].get<std::string>(),
                                 left_out["reason"].get<std::string>());
  for (const char* kind : {"stages", "memory", "controls", "rows"}) {
    if (left_out.contains(kind))
      text += fmt::format("; {}: {}", kind, left_out[kind].get<std::string>());
  }
  return text + "\n";
}

}  // namespace

Json left_out_json(const RenderFeatures& render_features) {
  Json list = Json::array();
  for (const RenderFeature& f : features_left_out(render_features)) {
    Json entry{{"feature", f.name}, {"reason", f.reason}};
    const auto add = [&](const char* kind, const char* words) {
      if (*words != '\0') entry[kind] = words;
    };
    add("stages", f.stages);
    add("memory", f.memory);
    add("controls", f.controls);
    add("rows", f.rows);
    list.push_back(std::move(entry));
  }
  return list;
}

Json scene_info_json(const Scene& scene, const RenderScene& ready) {
  const SceneNotes& notes = scene.notes;
  RenderFeatures needs = needs_of(ready, {});
  needs.boundaries = ready.geometry->boundaries.known();
  Json info{{"scene", scene.source},
            {"name", scene.name},
            {"meshes", scene.meshes.size()},
            {"instances", scene.instances.size()},
            {"triangles", scene.instanced_triangles()},
            {"shapes", std::count_if(scene.instances.begin(), scene.instances.end(),
                                     [](const Instance& i) { return i.shape >= 0; })},
            {"materials", scene.materials.size()},
            {"textures", scene.textures.size()},
            {"images", scene.images.size()},
            {"lights", lights_json(scene)},
            {"cameras", cameras_json(scene)},
            {"bounds", bounds_json(ready.world())},
            {"line_segments", scene.instanced_segments()},
            {"points", scene.instanced_points()},
            {"unsupported_extensions", notes.unsupported_extensions},
            {"not_shown", notes.not_shown},
            {"warnings", notes.warnings},
            {"memory_mb", ready.geometry->memory_mb()},
            {"left_out", left_out_json(needs)}};
  if (scene.surroundings)
    info["surroundings"] = {{"name", scene.surroundings->name},
                            {"pixels", scene.surroundings->sides[0].image.width}};
  info.update(contents_json(scene.contents));
  if (scene.time)
    info["time"] = {{"animation", scene.time->animation}, {"seconds", scene.time->seconds}};
  return info;
}

std::string scene_info_text(const Json& of_scene, std::size_t most) {
  const Json info = with_printable_texts(of_scene);
  const auto number = [&](const char* key) { return info[key].get<std::uint64_t>(); };
  std::string text = fmt::format("Scene:      {}\n", info["scene"].get<std::string>());
  if (const std::string name = info["name"]; !name.empty())
    text += fmt::format("Name:       {}\n", name);
  if (info.contains("time"))
    text += fmt::format("Moment:     {} s of animation {}\n", info["time"]["seconds"].get<double>(),
                        info["time"]["animation"].get<int>());
  text += fmt::format("Geometry:   {}, in {} of {}\n", counted(number("triangles"), "triangle"),
                      counted(number("instances"), "instance"),
                      counted(number("meshes"), "mesh", "meshes"));
  if (number("shapes") > 0)
    text += fmt::format("Shapes:     {}\n", counted(number("shapes"), "analytic instance"));
  if (number("line_segments") > 0)
    text += fmt::format("Lines:      {}\n", counted(number("line_segments"), "segment"));
  if (number("points") > 0) text += fmt::format("Points:     {}\n", number("points"));
  text += bounds_line(info["bounds"]);
  text += fmt::format("Materials:  {}, with {} of {}\n", number("materials"),
                      counted(number("textures"), "texture"), counted(number("images"), "image"));
  const bool surroundings = info.contains("surroundings");
  text += lights_line(info["lights"], surroundings);
  if (surroundings) {
    const std::string name = info["surroundings"]["name"];
    text += fmt::format("Surroundings: {}a cube of {} pixels a side\n",
                        name.empty() ? "" : name + ", ", info["surroundings"]["pixels"].get<int>());
  }
  const Json& cameras = info["cameras"];
  if (cameras.empty()) text += "Cameras:    none, one that frames the scene is used\n";
  if (!cameras.empty()) text += fmt::format("Cameras:    {}\n", cameras.size());
  text += lines_of(cameras, most, camera_line);
  text += contents_lines(info, most);
  const auto titled = [](const char* title) {
    return [title](std::size_t, const Json& line) {
      return fmt::format("{}{}\n", title, line.get<std::string>());
    };
  };
  text += lines_of(info["not_shown"], most, titled("Not shown:  "));
  const Json& unsupported = info["unsupported_extensions"];
  if (!unsupported.empty())
    text += fmt::format("Unsupported extensions: {}\n", list(unsupported, most));
  text += lines_of(unsupported, most, [](std::size_t, const Json& extension) {
    const std::string name = extension.get<std::string>();
    const auto instead = seen_without(name);
    return instead.empty() ? std::string() : fmt::format("  {}: {}\n", name, instead);
  });
  text += fmt::format("Memory:     {:.1f} MB of geometry, textures and hierarchies\n",
                      info["memory_mb"].get<double>());
  if (!info["left_out"].empty()) text += "Left out, because it is not needed:\n";
  for (const Json& left_out : info["left_out"]) text += left_out_line(left_out);
  return text + lines_of(info["warnings"], most, titled("Warning: "));
}

}  // namespace asos
