#include "renderer/gltf/keys.h"

#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>

namespace asos::gltf {

namespace {

// Bytes of keys that a file of any size may have, and additional ones for each of its bytes: a byte
// becomes a float.
constexpr std::uint64_t free_key_bytes = std::uint64_t{16} << 20;
constexpr std::uint64_t key_bytes_per_byte = 8;

// Shorter quaternions have no direction.
constexpr double shortest_rotation = 1e-12;

glm::dquat quaternion(const std::vector<double>& v) {
  return {v[3], v[0], v[1], v[2]};
}

std::vector<double> numbers_of(const glm::dquat& q) {
  const glm::dquat unit = glm::normalize(q);
  return {unit.x, unit.y, unit.z, unit.w};
}

bool all_are_finite(const std::vector<float>& values) {
  return std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); });
}

std::string fault_of_times(const std::vector<float>& seconds) {
  if (!all_are_finite(seconds)) return "its times are not finite";
  if (seconds.front() < 0.0f) return "its first key is before time 0";
  if (!std::is_sorted(seconds.begin(), seconds.end())) return "its times do not increase";
  return {};
}

bool has_zero_rotation(const Keys& keys) {
  const bool cubic = keys.interpolation == Interpolation::cubic_spline;
  const std::size_t stride = cubic ? 12 : 4, first = cubic ? 4 : 0;
  for (std::size_t i = first; i + 3 < keys.values->size(); i += stride) {
    const float* v = keys.values->data() + i;
    if (std::hypot(std::hypot(v[0], v[1]), std::hypot(v[2], v[3])) <= shortest_rotation)
      return true;
  }
  return false;
}

}  // namespace

double Keys::number(std::size_t key, std::size_t group, std::size_t i) const {
  const std::size_t groups = interpolation == Interpolation::cubic_spline ? 3 : 1;
  return static_cast<double>((*values)[(key * groups + group) * width + i]);
}

std::vector<double> Keys::value(std::size_t key) const {
  const std::size_t group = interpolation == Interpolation::cubic_spline ? 1 : 0;
  std::vector<double> v(width);
  for (std::size_t i = 0; i < width; ++i) v[i] = number(key, group, i);
  return rotation ? numbers_of(quaternion(v)) : v;
}

std::vector<double> Keys::between(std::size_t key, double share) const {
  std::vector<double> a = value(key);
  const std::vector<double> b = value(key + 1);
  // glm uses the shorter of the two arcs.
  if (rotation) return numbers_of(glm::slerp(quaternion(a), quaternion(b), share));
  for (std::size_t i = 0; i < width; ++i) a[i] = (1.0 - share) * a[i] + share * b[i];
  return a;
}

// Hermite's polynomial (appendix C.5), with tangents per second.
std::vector<double> Keys::spline(std::size_t key, double t) const {
  const double span =
      static_cast<double>((*seconds)[key + 1]) - static_cast<double>((*seconds)[key]);
  const double t2 = t * t, t3 = t2 * t;
  std::vector<double> v(width);
  for (std::size_t i = 0; i < width; ++i) {
    v[i] = (2.0 * t3 - 3.0 * t2 + 1.0) * number(key, 1, i) +
           span * (t3 - 2.0 * t2 + t) * number(key, 2, i) +
           (-2.0 * t3 + 3.0 * t2) * number(key + 1, 1, i) +
           span * (t3 - t2) * number(key + 1, 0, i);
  }
  if (!rotation) return v;
  // A spline may pass through 0, where it has no direction.
  return glm::length(quaternion(v)) > shortest_rotation ? numbers_of(quaternion(v)) : value(key);
}

std::vector<double> Keys::at(double time) const {
  const std::vector<float>& times = *seconds;
  const auto after = std::upper_bound(times.begin(), times.end(), time, [](double t, float key) {
    return t < static_cast<double>(key);
  });
  if (after == times.begin()) return value(0);
  const auto key = static_cast<std::size_t>(after - times.begin()) - 1;
  if (after == times.end() || interpolation == Interpolation::step) return value(key);
  const double begin = static_cast<double>(times[key]);
  const double share = (time - begin) / (static_cast<double>(*after) - begin);
  return interpolation == Interpolation::linear ? between(key, share) : spline(key, share);
}

KeyReader::KeyReader(const Document& document, Accessors& accessors)
    : accessors_(accessors),
      budget_bytes_(free_key_bytes + key_bytes_per_byte * document.honest_bytes) {}

Checked<KeyReader::Numbers> KeyReader::numbers(int accessor, int components) {
  const auto key = std::make_pair(accessor, components);
  if (const auto known = known_.find(key); known != known_.end()) return known->second;
  const Checked<std::size_t> count = accessors_.count(accessor);
  if (!count) return fault(count.error());
  const std::uint64_t bytes = *count * static_cast<std::uint64_t>(components) * sizeof(float);
  if (bytes > budget_bytes_)
    return fault("the animations' keys are more than a file of this size can hold");
  budget_bytes_ -= bytes;
  Checked<std::vector<float>> values = accessors_.floats(accessor, components);
  if (!values) return fault(values.error());
  return known_[key] = std::make_shared<const std::vector<float>>(std::move(*values));
}

Checked<Keys> KeyReader::read(const tinygltf::AnimationSampler& sampler, int components,
                              std::size_t groups, bool rotation) {
  Keys keys;
  keys.rotation = rotation;
  keys.width = groups * static_cast<std::size_t>(components);
  if (sampler.interpolation == "STEP") {
    keys.interpolation = Interpolation::step;
  } else if (sampler.interpolation == "CUBICSPLINE") {
    keys.interpolation = Interpolation::cubic_spline;
  } else if (sampler.interpolation != "LINEAR") {
    return fault(fmt::format("its interpolation '{}' is unknown", sampler.interpolation));
  }
  const Checked<Numbers> seconds = numbers(sampler.input, 1);
  if (!seconds) return fault(seconds.error());
  if (const std::string why = fault_of_times(**seconds); !why.empty()) return fault(why);
  keys.seconds = *seconds;
  const Checked<Numbers> values = numbers(sampler.output, components);
  if (!values) return fault(values.error());
  if (!all_are_finite(**values)) return fault("its values are not finite");
  keys.values = *values;

  const bool cubic = keys.interpolation == Interpolation::cubic_spline;
  const std::size_t wanted = keys.seconds->size() * keys.width * (cubic ? 3 : 1);
  if (keys.values->size() != wanted) {
    return fault(fmt::format("it has {} numbers for {} keys, which take {}", keys.values->size(),
                             keys.seconds->size(), wanted));
  }
  if (keys.rotation && has_zero_rotation(keys)) return fault("a rotation of it has no direction");
  return keys;
}

}  // namespace asos::gltf
