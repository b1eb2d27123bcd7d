#include "ui/stored_settings.h"

#include "renderer/files/read_file.h"
#include "renderer/film/image_io.h"
#include "renderer/settings/names.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <system_error>

namespace asos::ui {

namespace {

using SettingsJson = nlohmann::ordered_json;

void read(const SettingsJson& json, const char* key, bool& value) {
  if (const auto at = json.find(key); at != json.end() && at->is_boolean()) value = at->get<bool>();
}

void read(const SettingsJson& json, const char* key, float lo, float hi, float& value) {
  const auto at = json.find(key);
  if (at == json.end() || !at->is_number()) return;
  const auto number = at->get<double>();
  if (number >= static_cast<double>(lo) && number <= static_cast<double>(hi))
    value = static_cast<float>(number);
}

glm::ivec2 size_of(const SettingsJson& json) {
  constexpr int most = 1 << 15;
  const auto at = json.find("window_size");
  if (at == json.end() || !at->is_array() || at->size() != 2) return glm::ivec2(0);
  glm::ivec2 size(0);
  for (int k = 0; k < 2; ++k) {
    const SettingsJson& side = (*at)[static_cast<std::size_t>(k)];
    if (!side.is_number_integer()) return glm::ivec2(0);
    size[k] = static_cast<int>(std::clamp<std::int64_t>(side.get<std::int64_t>(), 0, most));
  }
  return size;
}

/// Names in the file, in the order of the enumerators.
constexpr std::array theme_names{"dark", "light"};

WindowLook look_of(const SettingsJson& json) {
  WindowLook look;
  read(json, "ui_scale", WindowLook::least_scale, WindowLook::most_scale, look.scale);
  read(json, "show_bar", look.show_bar);
  const auto at = json.find("theme");
  if (at != json.end() && at->is_string() && at->get<std::string>() == theme_names[1])
    look.theme = theme::Look::light;
  return look;
}

const char* name_of(PanelTab tab) {
  return panel_tab_names[static_cast<std::size_t>(tab)];
}

void read_sections(const SettingsJson& json, std::map<std::string, bool>& sections) {
  constexpr std::size_t most = 100;
  const auto all = json.find("sections");
  if (all == json.end() || !all->is_object()) return;
  for (const auto& [name, open] : all->items())
    if (open.is_boolean() && sections.size() < most) sections[name] = open.get<bool>();
}

StoredSettings settings_of(const SettingsJson& json) {
  StoredSettings s;
  constexpr float ev = DisplaySettings::exposure_limit_ev;
  read(json, "exposure_ev", -ev, ev, s.display.exposure_ev);
  if (const auto at = json.find("tone"); at != json.end() && at->is_string()) {
    for (const NamedTone& named : tone_names)
      if (at->get<std::string>() == named.name) s.display.tone = named.value;
  }
  read(json, "split_dimming", 0.0f, 1.0f, s.display.split_dimming);
  read(json, "show_legend", s.display.show_legend);
  read(json, "show_grid", s.display.show_grid);
  read(json, "show_axes", s.display.show_axes);
  read(json, "show_scale", s.display.show_scale);
  if (const auto at = json.find("split_colours"); at != json.end() && at->is_string()) {
    for (const auto& named : split_map_names)
      if (at->get<std::string>() == named.name) s.display.split_colours = named.value;
  }
  s.look = look_of(json);
  read(json, "tour_seen", s.tour_seen);
  read(json, "show_panel", s.show_panel);
  read(json, "show_marks", s.show_marks);
  read(json, "watch", s.watch);
  s.window_size = size_of(json);
  if (const auto at = json.find("tab"); at != json.end() && at->is_string()) {
    for (const PanelTab tab : {PanelTab::scene, PanelTab::measure})
      if (at->get<std::string>() == name_of(tab)) s.tab = tab;
  }
  read_sections(json, s.sections);
  const auto recent = json.find("recent");
  if (recent == json.end() || !recent->is_array()) return s;
  for (const SettingsJson& path : *recent) {
    if (path.is_string() && s.recent.size() < StoredSettings::most_recent)
      s.recent.push_back(path.get<std::string>());
  }
  return s;
}

}  // namespace

void StoredSettings::add_recent(const std::string& source) {
  std::error_code error;
  const std::filesystem::path path = std::filesystem::absolute(source, error);
  if (error || !std::filesystem::is_regular_file(path, error)) return;
  const std::string name = path.lexically_normal().string();
  std::erase(recent, name);
  recent.insert(recent.begin(), name);
  if (recent.size() > most_recent) recent.resize(most_recent);
}

StoredSettings merged(const StoredSettings& before, const StoredSettings& ours,
                      const StoredSettings& theirs) {
  StoredSettings all = ours;
  const auto keep_theirs = [&](auto StoredSettings::*member) {
    if (ours.*member == before.*member) all.*member = theirs.*member;
  };
  keep_theirs(&StoredSettings::display);
  keep_theirs(&StoredSettings::look);
  keep_theirs(&StoredSettings::tour_seen);
  keep_theirs(&StoredSettings::show_panel);
  keep_theirs(&StoredSettings::show_marks);
  keep_theirs(&StoredSettings::watch);
  keep_theirs(&StoredSettings::window_size);
  keep_theirs(&StoredSettings::tab);
  keep_theirs(&StoredSettings::sections);
  const auto holds = [](const std::vector<std::string>& files, const std::string& file) {
    return std::find(files.begin(), files.end(), file) != files.end();
  };
  // Files that were removed from the list here stay removed.
  for (const std::string& file : theirs.recent) {
    if (!holds(ours.recent, file) && !holds(before.recent, file)) all.recent.push_back(file);
  }
  if (all.recent.size() > StoredSettings::most_recent)
    all.recent.resize(StoredSettings::most_recent);
  return all;
}

std::filesystem::path settings_path() {
  const auto folder = [](const char* variable) {
    const char* value = std::getenv(variable);
    return std::filesystem::path(value ? value : "");
  };
  // The XDG specification says that relative paths are to be ignored.
  if (const auto config = folder("XDG_CONFIG_HOME"); config.is_absolute())
    return config / "asos" / "window.json";
  if (const auto home = folder("HOME"); home.is_absolute())
    return home / ".config" / "asos" / "window.json";
  return {};
}

Result<StoredSettings> load_settings(const std::filesystem::path& path) {
  std::error_code error;
  if (path.empty() || !std::filesystem::exists(path, error)) return StoredSettings{};
  constexpr std::uint64_t most_bytes = std::uint64_t{1} << 20;
  const auto file = read_file(path, {most_bytes});
  if (!file) return unexpected(Error{path.string(), file.error()});
  const SettingsJson json = SettingsJson::parse(file->begin(), file->end(), nullptr, false);
  if (!json.is_object()) return unexpected(Error{path.string(), "is no JSON object"});
  return settings_of(json);
}

Result<void> save_settings(const std::filesystem::path& path, const StoredSettings& settings) {
  if (path.empty()) return unexpected(Error{"settings", "there is no folder for them"});
  std::error_code error;
  std::filesystem::create_directories(path.parent_path(), error);
  if (error) return unexpected(Error{path.parent_path().string(), error.message()});
  const SettingsJson json{
      {"exposure_ev", settings.display.exposure_ev},
      {"tone", name_in(tone_names, settings.display.tone)},
      {"split_dimming", settings.display.split_dimming},
      {"show_legend", settings.display.show_legend},
      {"show_grid", settings.display.show_grid},
      {"show_axes", settings.display.show_axes},
      {"show_scale", settings.display.show_scale},
      {"split_colours", name_in(split_map_names, settings.display.split_colours)},
      {"theme", theme_names[static_cast<std::size_t>(settings.look.theme)]},
      {"ui_scale", settings.look.scale},
      {"show_bar", settings.look.show_bar},
      {"tour_seen", settings.tour_seen},
      {"show_panel", settings.show_panel},
      {"show_marks", settings.show_marks},
      {"watch", settings.watch},
      {"window_size", {settings.window_size.x, settings.window_size.y}},
      {"tab", name_of(settings.tab)},
      {"sections", settings.sections},
      {"recent", settings.recent}};
  // Paths need not be valid UTF-8.
  const std::string text = json.dump(2, ' ', false, SettingsJson::error_handler_t::replace) + "\n";
  return write_file_atomically(path.string(), {text.begin(), text.end()});
}

}  // namespace asos::ui
