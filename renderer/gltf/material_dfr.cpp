#include "renderer/gltf/material_dfr.h"

#include "renderer/gltf/light_values.h"

#include <fmt/format.h>

#include <limits>

namespace asos::gltf {
namespace {

constexpr double any_size = std::numeric_limits<double>::max();

/// Reads the property `name`: one number for all colours or one for each, 0 to `most`.
Checked<std::array<double, 3>> rgb(const tinygltf::Value& object, const char* name,
                                   double otherwise, double most) {
  std::vector<double> values(1, otherwise);
  if (object.Has(name)) {
    if (const std::optional<double> one = number(object, name)) {
      values = {*one};
    } else if (const auto list = numbers(object, name); list && list->size() == 3) {
      values = *list;
    } else {
      return fault(fmt::format("{} is neither a number nor three", name));
    }
  }
  for (const double value : values) {
    if (value >= 0.0 && value <= most) continue;
    return fault(most < any_size ? fmt::format("{} of {} is not from 0 to {}", name, value, most)
                                 : fmt::format("{} of {} is below 0", name, value));
  }
  values.resize(3, values.front());
  return std::array<double, 3>{values[0], values[1], values[2]};
}

}  // namespace

Checked<std::optional<Dfr>> read_dfr(const tinygltf::Value& extras) {
  if (!extras.Has("asos_dfr")) return std::nullopt;
  const tinygltf::Value& object = extras.Get("asos_dfr");
  if (!object.IsObject()) return fault("it is not an object");
  const auto min = rgb(object, "min", 1.0, 1.0);
  if (!min) return fault(min.error());
  const auto max = rgb(object, "max", 1.0, 1.0);
  if (!max) return fault(max.error());
  const auto exponent = rgb(object, "exponent", 1.0, any_size);
  if (!exponent) return fault(exponent.error());
  Dfr dfr;
  for (std::size_t k = 0; k < 3; ++k) dfr.rgb[k] = {(*min)[k], (*max)[k], (*exponent)[k]};
  if (!object.Has("perturbation")) return dfr;
  const std::optional<double> perturbation = number(object, "perturbation");
  if (!perturbation) return fault("perturbation is not a number");
  if (!(*perturbation >= 0.0 && *perturbation <= 1.0))
    return fault(fmt::format("perturbation of {} is not from 0 to 1", *perturbation));
  dfr.perturbation = *perturbation;
  return dfr;
}

}  // namespace asos::gltf
