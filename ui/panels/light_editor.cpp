#include "ui/panels/light_editor.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>

namespace asos::ui {

namespace {

constexpr auto kind_options = [] {
  std::array<Controls::Option, light_kind_count> options{};
  for (std::size_t i = 0; i < light_kind_count; ++i)
    options[i] = {light_kinds[i].name, light_kinds[i].tooltip};
  return options;
}();

constexpr std::array outline_options{
    Controls::Option{"Triangle", "A regular triangle."},
    Controls::Option{"Hexagon", "A regular hexagon."},
    Controls::Option{"Star", "A five-pointed star."},
    Controls::Option{"Frame", "A square with a square hole."},
};
static_assert(outline_options.size() == polygon_shape_count);

const char* intensity_unit(const Light& light) {
  if (!has_position(light)) return "lx";
  return is_flat(light) ? "cd/m\u00b2" : "cd";
}

std::string metres(double length) {
  return number_words(length) + " m";
}

/// Controls of one light. Each notes whether it has changed the light.
class LightEditor {
 public:
  LightEditor(Controls& controls, EditedLight& edited, const LightSurroundings& around)
      : controls_(controls), edited_(edited), around_(around) {}

  /// Returns whether anything was changed.
  bool run() {
    kind();
    brightness();
    const double area = area_of(light_);
    size();
    if (around_.keep_power && area != area_of(light_)) keep_power(light_, area);
    place();
    turn();
    flags();
    return changed_;
  }

 private:
  /// Value that a double click restores: that of the original light, if it had the same kind.
  [[nodiscard]] std::optional<double> original(double value) const {
    return same_kind_ ? std::optional(value) : std::nullopt;
  }

  void kind() {
    int chosen = static_cast<int>(kind_of(light_));
    if (!controls_.options("Type", kind_options, chosen, {false, std::nullopt})) return;
    // A light that was not directional at first has kept its position.
    light_ = as_kind(light_, static_cast<LightKind>(chosen), around_.looked_at,
                     has_position(edited_.original));
    changed_ = true;
  }

  void brightness() {
    changed_ |= controls_.colour(
        "Colour", "Light colour, sRGB red, green, blue, 0 to 255. Click the patch for a picker.",
        light_.color, edited_.original.color);
    double intensity = static_cast<double>(light_.intensity);
    constexpr double most = 1e12, step = 1e-3;
    const char* unit = intensity_unit(light_);
    if (controls_.number(
            "Intensity",
            "Brightness in cd (points, spheres, lines), lx (directional) or cd/m² (flat lights). "
            "Drag, or Ctrl+click to type a value.",
            intensity,
            {{0.0, most, original(static_cast<double>(edited_.original.intensity))}, step, true},
            [&](double value) { return number_words(value) + " " + unit; })) {
      light_.intensity = static_cast<float>(intensity);
      changed_ = true;
    }
  }

  /// Edits a length. Returns whether it changed.
  bool length(const LightSize& size, double& value, double reset) {
    const double least = size.may_be_zero ? 0.0 : 1e-5 * around_.scene.radius;
    const double most = 1e3 * around_.scene.radius;
    const bool edited = controls_.number(
        size.name, size.tooltip, value,
        {{least, most, original(reset)}, 1e-4 * around_.scene.radius, true}, metres);
    changed_ |= edited;
    return edited;
  }

  bool degrees(const char* name, const char* tooltip, double& angle_rad,
               const Controls::Range<double>& range_deg) {
    const bool edited = controls_.angle_slider(name, tooltip, angle_rad, range_deg);
    changed_ |= edited;
    return edited;
  }

  void edit(const LightSize& size) {
    const Light& old = edited_.original;
    if (size.half) {
      glm::dvec3& half = light_.*size.half;
      double side = 2.0 * glm::length(half);
      if (side > 0.0 && length(size, side, 2.0 * glm::length(old.*size.half)))
        half *= side / (2.0 * glm::length(half));
    } else if (size.is_angle()) {
      degrees(size.name, size.tooltip, light_.*size.value, {size.least, size.most, size.initial});
    } else if (size.value) {
      length(size, light_.*size.value, old.*size.value);
    } else if (size.name) {
      polygon(size);
    }
  }

  void size() {
    const LightKindRow& row = row_of(light_);
    edit(row.size);
    edit(row.second);
    if (!row.has_cone()) return;
    light_.inner_cone_rad = std::min(light_.inner_cone_rad, light_.outer_cone_rad);
    degrees("Inner cone",
            "Half angle of full brightness in degrees. The light fades from there to the cone.",
            light_.inner_cone_rad, {0.0, glm::degrees(light_.outer_cone_rad), 0.0});
  }

  void polygon(const LightSize& size) {
    const std::optional<PolygonShape> now = polygon_shape(light_);
    int shape = now ? static_cast<int>(*now) : -1;
    if (controls_.options("Shape", outline_options, shape)) {
      set_polygon_shape(light_, static_cast<PolygonShape>(shape));
      changed_ = true;
    }
    double radius = polygon_radius(light_);
    if (radius > 0.0 && length(size, radius, polygon_radius(edited_.original)))
      set_polygon_radius(light_, radius);
  }

  void place() {
    if (!has_position(light_)) return;
    glm::dvec3 position = light_.position + around_.origin;
    if (!controls_.vector(
            "Position",
            "Centre of the light, x, y (up), z, in metres. Drag, type, or drag its gizmo.",
            position, 2e-3 * around_.scene.radius, edited_.original.position + around_.origin))
      return;
    move_light(light_, position - around_.origin - light_.position);
    changed_ = true;
  }

  void turn() {
    const LightKindRow& row = row_of(light_);
    if (!has_direction(light_) && !row.line()) return;
    LightTurn turn = turn_of(light_);
    const LightTurn old = same_kind_ ? turn_of(edited_.original) : LightTurn{};
    bool turned = degrees(
        "Azimuth", "Compass angle of the light's direction, in degrees: 0 along +z, 90 along +x.",
        turn.azimuth_rad, {-180.0, 180.0, glm::degrees(old.azimuth_rad)});
    turned |=
        degrees("Elevation", "Direction above the horizon in degrees. -90 points straight down.",
                turn.elevation_rad, {-90.0, 90.0, glm::degrees(old.elevation_rad)});
    if (row.rolls())
      turned |= degrees("Roll", "Rotation of the shape in its plane, in degrees.", turn.roll_rad,
                        {-180.0, 180.0, glm::degrees(old.roll_rad)});
    if (turned) turn_light(light_, turn);
  }

  void flags() {
    if (is_flat(light_))
      changed_ |= controls_.checkbox("Two-sided", "Emits light on both sides.", light_.two_sided,
                                     edited_.original.two_sided);
    changed_ |= controls_.checkbox("Casts shadows",
                                   "Objects block this light. Off: it passes through everything.",
                                   light_.casts_shadows, edited_.original.casts_shadows);
  }

  Controls& controls_;
  EditedLight& edited_;
  const LightSurroundings& around_;
  Light& light_ = edited_.light;
  bool same_kind_ = kind_of(edited_.original) == kind_of(light_);
  bool changed_ = false;
};

}  // namespace

bool edit_light(Controls& controls, EditedLight& edited, const LightSurroundings& around) {
  return LightEditor(controls, edited, around).run();
}

}  // namespace asos::ui
