#include "renderer/gltf/camera_lens.h"

#include "renderer/gltf/values.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace asos::gltf {
namespace {

constexpr const char* key_of_lens = "asos_lens";

/// Returns a finite number, or none if there is no such property.
Checked<std::optional<double>> lens_number(const tinygltf::Value& object, const char* name) {
  if (!object.Has(name)) return std::nullopt;
  const std::optional<double> value = number(object, name);
  if (!value) return fault(fmt::format("{} is not a number", name));
  return value;
}

}  // namespace

Checked<Lens> read_lens(const tinygltf::Value& extras, double fov_y_rad) {
  Lens lens;
  if (!extras.IsObject() || !extras.Has(key_of_lens)) return lens;
  const tinygltf::Value& object = extras.Get(key_of_lens);
  if (!object.IsObject()) return fault("it is not an object");
  const auto aperture = lens_number(object, "aperture"), f_stop = lens_number(object, "f_stop"),
             focus = lens_number(object, "focus"), blades = lens_number(object, "blades"),
             turn = lens_number(object, "blade_turn");
  for (const auto& value : {aperture, f_stop, focus, blades, turn})
    if (!value) return fault(value.error());
  if (aperture->has_value() == f_stop->has_value())
    return fault("it has to have either aperture or f_stop");
  if (*f_stop && !(**f_stop >= Lens::smallest_f_stop && **f_stop <= Lens::largest_f_stop))
    return fault(fmt::format("f_stop of {} is not from {} to {}", **f_stop, Lens::smallest_f_stop,
                             Lens::largest_f_stop));
  lens.radius = *aperture ? **aperture : aperture_of_f_stop(**f_stop, fov_y_rad);
  lens.focus = *focus;
  lens.turn_rad = turn->value_or(0.0);
  const double corners = blades->value_or(0.0);
  if (!(corners >= 0.0 && corners <= Lens::most_blades && corners == std::floor(corners)))
    return fault(fmt::format("blades of {} is neither 0 nor from {} to {}", corners,
                             Lens::fewest_blades, Lens::most_blades));
  lens.blades = static_cast<int>(corners);
  if (const std::string why = validate_lens(lens); !why.empty()) return fault(why);
  return lens;
}

}  // namespace asos::gltf
