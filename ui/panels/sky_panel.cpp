#include "ui/panels/sky_panel.h"

#include "renderer/picture/picture_description.h"
#include "renderer/shading/environments.h"
#include "ui/input.h"
#include "ui/panels/background_panel.h"
#include "ui/panels/dialog.h"
#include "ui/panels/sky_thumbnails.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <utility>

namespace asos::ui {

namespace {

enum class SkyKind { neutral, environment, colour, gradient, file };

constexpr std::array sky_kinds{
    Controls::Option{"Neutral", "Uniform grey."},
    Controls::Option{"Preset", "Built-in environments. Some add a sun to scenes without lights."},
    Controls::Option{"Colour", "One colour."},
    Controls::Option{"Gradient", "From a zenith colour to a horizon colour."},
    Controls::Option{"File", "An equirectangular .hdr or .exr picture, twice as wide as high."},
};

constexpr glm::vec3 first_zenith{0.22f, 0.42f, 0.85f};
constexpr glm::vec3 first_horizon{0.85f, 0.91f, 1.0f};

SkyKind kind_of_sky(const RenderSettings& settings, const SkyEdit& choice) {
  if (choice.file) return SkyKind::file;
  const Sky* sky = settings.sky.get();
  if (!sky) return SkyKind::neutral;
  if (sky->choice().environment) return SkyKind::environment;
  if (sky->is_picture()) return SkyKind::file;
  return sky->choice().colours->zenith != sky->choice().colours->horizon || choice.gradient
             ? SkyKind::gradient
             : SkyKind::colour;
}

void choose_kind(SceneEdits& edits, SkyEdit& choice, SkyKind kind) {
  choice.gradient = kind == SkyKind::gradient;
  choice.file = kind == SkyKind::file;
  choice.error.clear();
  if (kind == SkyKind::neutral) edits.set_sky(nullptr);
  if (kind == SkyKind::environment)
    edits.set_sky(std::make_shared<const Sky>(environments.front().value));
  if (kind == SkyKind::colour) edits.set_sky(std::make_shared<const Sky>(first_zenith));
  if (kind == SkyKind::gradient)
    edits.set_sky(std::make_shared<const Sky>(first_zenith, first_horizon));
}

/// Rotation and brightness of an image or environment sky.
void placing_controls(Controls& controls, SceneEdits& edits) {
  double turn_deg = edits.settings().sky->choice().turn_deg;
  if (controls.slider("Turn",
                      "Rotation about the vertical in degrees, counter-clockwise from above. Also "
                      "Shift + right drag sideways in the picture.",
                      turn_deg, {-180.0, 180.0, 0.0}, degree_words))
    edits.turn_sky(turn_deg);
  double brightness = edits.settings().sky->choice().brightness;
  if (controls.number("Brightness",
                      "Brightness factor, 0 to 1000. Also Shift + right drag up or down in the "
                      "picture.",
                      brightness, {{0.0, SkyChoice::most_brightness, 1.0}, 0.01, true},
                      [](double times) { return fmt::format("{:.4g} x", times); }))
    edits.brighten_sky(brightness);
}

/// Radiance split into colours of 0 to 1 and a brightness factor.
struct SkyColours {
  glm::vec3 zenith, horizon;
  double brightness = 1.0;

  explicit SkyColours(const Sky& sky)
      : zenith(sky.choice().colours->zenith), horizon(sky.choice().colours->horizon) {
    for (const glm::vec3& c : {zenith, horizon})
      brightness = std::max(brightness, static_cast<double>(std::max({c.x, c.y, c.z})));
    zenith /= static_cast<float>(brightness);
    horizon /= static_cast<float>(brightness);
  }
  [[nodiscard]] std::shared_ptr<const Sky> sky() const {
    const auto scale = static_cast<float>(brightness);
    return std::make_shared<const Sky>(scale * zenith, scale * horizon);
  }
};

void colour_controls(Controls& controls, RenderSettings& settings, SkyKind kind) {
  SkyColours colours(*settings.sky);
  bool changed = false;
  if (kind == SkyKind::gradient) {
    changed |= controls.colour("Zenith", "Colour at the zenith, red, green, blue, 0 to 255.",
                               colours.zenith, first_zenith);
    changed |=
        controls.colour("Horizon", "Colour at the horizon and below, red, green, blue, 0 to 255.",
                        colours.horizon, first_horizon);
  } else {
    changed |= controls.colour("Sky colour", "Colour of the sky, red, green, blue, 0 to 255.",
                               colours.zenith, first_zenith);
    colours.horizon = colours.zenith;
  }
  changed |= controls.number("Brightness", "Brightness factor of the sky colour, 1 to 1000.",
                             colours.brightness, {{1.0, 1000.0, 1.0}, 0.01, true},
                             [](double times) { return fmt::format("{:.4g} x", times); });
  if (changed) settings.sky = colours.sky();
}

void file_controls(Controls& controls, SceneEdits& edits, SkyEdit& choice, SkyReader& reader) {
  const RenderSettings& settings = edits.settings();
  const bool entered =
      controls.text_field("Sky path", "Path of an equirectangular .hdr or .exr picture.",
                          "path of a .hdr or .exr file", choice.path);
  const int pressed = controls.buttons(
      {{reader.busy() ? "Reading..." : "Load sky", "Load the picture as the sky (Enter)."},
       {"Browse...", "Choose an .hdr or .exr file."}});
  if (pressed == 1) choice.browse = true;
  if (pressed == 0 || entered) {
    choice.error.clear();
    choice.reading = FileStamp::of(choice.path);
    // Reading the same sky again would only restart the render.
    const bool shown =
        settings.sky && settings.sky->is_picture() && settings.sky->choice().file == choice.path;
    if (shown && choice.reading->state && choice.reading == choice.read) return;
    reader.read(choice.path);
  }
  controls.warning("Sky error", choice.error);
  if (!settings.sky || settings.sky->choice().file.empty()) return;
  controls.warning("Sky remark", choice.remark);
  controls.row("Picture", settings.sky->choice().file, "File of the sky.");
  placing_controls(controls, edits);
}

std::filesystem::path first_sky_folder(const SkyEdit& choice) {
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::path(choice.path).parent_path();
  if (!folder.empty() && std::filesystem::is_directory(folder, error)) return folder;
  return std::filesystem::current_path(error);
}

void browse_skies(Controls& controls, SkyEdit& choice, SkyReader& reader) {
  constexpr const char* title = "Open a sky";
  if (choice.browse && !ImGui::IsPopupOpen(title)) {
    choice.browser.listing.kind = FolderListing::Kind::skies;
    choice.browser.begin(first_sky_folder(choice));
  }
  const Dialog dialog(title, choice.browse, 40.0f, 0.5f);
  if (!dialog.open()) return;
  const float em = ImGui::GetFontSize();
  const float room = ImGui::GetIO().DisplaySize.y - 14.0f * em;
  std::string chosen =
      browse_files(controls, choice.browser, std::clamp(room, 3.0f * em, 24.0f * em));
  ImGui::Spacing();
  if (controls.button("Open", "Open the chosen or typed file (Enter).", 6.0f * em))
    chosen = choice.browser.take_entered();
  const bool cancelled = dialog.cancelled(controls, "Close (Esc).");
  if (!chosen.empty()) read_as_sky(choice, reader, chosen);
  if (chosen.empty() && !cancelled) return;
  choice.browse = false;
  dialog.close();
}

}  // namespace

bool is_sky_file(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending == ".hdr" || (ending == ".exr" && !read_description(path));
}

void read_as_sky(SkyEdit& choice, SkyReader& reader, const std::string& path) {
  choice.file = true;
  choice.error.clear();
  choice.path = path;
  choice.reading = FileStamp::of(path);
  reader.read(path);
}

void update_sky(SceneEdits& edits, SkyEdit& choice, SkyReader& reader) {
  auto outcome = reader.take_outcome();
  if (!outcome) return;
  if (outcome->sky) {
    edits.set_sky(std::move(*outcome->sky));
    choice.remark = std::move(outcome->remark);
    choice.file = false;
    choice.read = std::exchange(choice.reading, std::nullopt);
  } else {
    choice.error = outcome->sky.error().message();
    if (choice.dropped) choice.fault = outcome->sky.error();
    choice.file &= !choice.dropped;
  }
  choice.dropped = false;
}

void sky_panel(Controls& controls, SceneEdits& edits, SkyEdit& choice, SkyReader& reader) {
  if (!controls.section("Sky", false)) return;
  RenderSettings& settings = edits.settings();
  sky_thumbnails(controls, edits);
  if (const Sky* sky = settings.sky.get(); sky && sky->choice().environment) choice.file = false;
  const SkyKind kind = kind_of_sky(settings, choice);
  int chosen = static_cast<int>(kind);
  if (controls.options("Sky", sky_kinds, chosen, {false, std::nullopt}))
    choose_kind(edits, choice, static_cast<SkyKind>(chosen));
  switch (kind_of_sky(settings, choice)) {
    case SkyKind::neutral:
      break;
    case SkyKind::environment:
      placing_controls(controls, edits);
      break;
    case SkyKind::colour:
    case SkyKind::gradient:
      colour_controls(controls, settings, kind_of_sky(settings, choice));
      break;
    case SkyKind::file:
      file_controls(controls, edits, choice, reader);
      break;
  }
  background_controls(controls, settings);
  browse_skies(controls, choice, reader);
}

}  // namespace asos::ui
