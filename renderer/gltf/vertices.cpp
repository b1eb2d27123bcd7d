#include "renderer/gltf/vertices.h"

#include "renderer/load_progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asos::gltf {

namespace {

template <typename T>
std::vector<T> selected(std::vector<T> all, std::size_t components, const Selection& selection) {
  if (!selection) return all;
  std::vector<T> chosen;
  chosen.reserve(selection->size() * components);
  for (const std::uint32_t i : *selection) {
    for (std::size_t c = 0; c < components; ++c) chosen.push_back(all[i * components + c]);
  }
  return chosen;
}

bool outside_selection(std::size_t count, const Selection& selection) {
  return selection && !selection->empty() && selection->back() >= count;
}

}  // namespace

bool AttributeSource::has(const std::string& name) const {
  return (draco_ && draco_->has(name)) || request_.primitive.attributes.contains(name);
}

Checked<std::size_t> AttributeSource::vertex_count() const {
  if (draco_ && draco_->has("POSITION")) return draco_->vertex_count();
  const auto found = request_.primitive.attributes.find("POSITION");
  if (found == request_.primitive.attributes.end()) return fault("it has no positions");
  return accessors_.count(found->second);
}

Checked<int> AttributeSource::components(const std::string& name) const {
  if (draco_ && draco_->has(name)) return draco_->components(name);
  return accessors_.components(request_.primitive.attributes.at(name));
}

Checked<std::vector<float>> AttributeSource::floats(const std::string& name, int components,
                                                    const Selection& selection) const {
  stop_point();
  const auto found = request_.primitive.attributes.find(name);
  if (draco_ && draco_->has(name)) {
    bool normalized = false;
    if (found != request_.primitive.attributes.end()) {
      normalized = accessors_.normalized(found->second);
    }
    if (outside_selection(draco_->vertex_count(), selection)) return fault("it is too short");
    Checked<std::vector<float>> all = draco_->floats(name, components, normalized);
    if (!all) return all;
    return selected(std::move(*all), static_cast<std::size_t>(components), selection);
  }
  if (const Checked<std::size_t> count = accessors_.count(found->second); !count) {
    return fault(count.error());
  } else if (*count != declared_ && name != "POSITION") {
    return fault(fmt::format("it has {} elements for {} vertices", *count, declared_));
  }
  return accessors_.floats(found->second, components, selection);
}

std::vector<float> AttributeSource::optional(const std::string& name, int components,
                                             const Selection& selection) {
  if (!has(name)) return {};
  Checked<std::vector<float>> values = floats(name, components, selection);
  if (values) return std::move(*values);
  warnings_.add(fmt::format("{}: {} is left out: {}", request_.place, name, values.error()));
  return {};
}

Checked<VertexData> AttributeSource::read(const Selection& selection) {
  VertexData data;
  const Checked<std::size_t> count = vertex_count();
  if (!count) return fault(count.error());
  declared_ = *count;
  const Checked<std::vector<float>> positions = floats("POSITION", 3, selection);
  if (!positions) return fault(positions.error());
  data.positions = as_vectors<glm::vec3>(*positions);
  data.normals = as_vectors<glm::vec3>(optional("NORMAL", 3, selection));
  data.tangents = as_vectors<glm::vec4>(optional("TANGENT", 4, selection));
  for (int set = 0; set < 2; ++set) {
    const std::string name = fmt::format("TEXCOORD_{}", set);
    data.texcoords[set] = as_vectors<glm::vec2>(optional(name, 2, selection));
    for (glm::vec2& uv : data.texcoords[set]) {
      if (std::isfinite(uv.x) && std::isfinite(uv.y)) continue;
      warnings_.add(
          fmt::format("{}: {} has values that are not finite; 0 is used", request_.place, name));
      uv = glm::vec2(0.0f);
    }
  }
  read_colors(data, selection);
  if (request_.skin) read_influences(data, selection);
  morph(data, selection);
  return data;
}

void AttributeSource::read_colors(VertexData& data, const Selection& selection) {
  if (!has("COLOR_0")) return;
  const int n = components("COLOR_0").value_or(4) == 3 ? 3 : 4;
  const std::vector<float> values = optional("COLOR_0", n, selection);
  if (n == 4) {
    data.colors = as_vectors<glm::vec4>(values);
  } else {
    for (const glm::vec3 c : as_vectors<glm::vec3>(values)) data.colors.emplace_back(c, 1.0f);
  }
  for (glm::vec4& color : data.colors) {
    for (int c = 0; c < 4; ++c) {
      if (color[c] >= 0.0f && color[c] <= 1.0f) continue;
      warnings_.add(request_.place + ": COLOR_0 has values outside 0 to 1; brought into it");
      color[c] = std::isfinite(color[c]) ? std::clamp(color[c], 0.0f, 1.0f) : 1.0f;
    }
  }
}

void AttributeSource::read_influences(VertexData& data, const Selection& selection) {
  for (int set = 0;; ++set) {
    const std::string joints = fmt::format("JOINTS_{}", set);
    const std::string weights = fmt::format("WEIGHTS_{}", set);
    if (!has(joints) && !has(weights)) break;
    if (!has(joints) || !has(weights)) {
      warnings_.add(fmt::format("{}: {} and {} do not come together; ignored", request_.place,
                                joints, weights));
      break;
    }
    const auto fit =
        [&](Checked<std::vector<std::uint32_t>> all) -> Checked<std::vector<std::uint32_t>> {
      if (all && outside_selection(all->size() / 4, selection)) return fault("it is too short");
      return all;
    };
    const auto numbers =
        draco_ && draco_->has(joints)
            ? fit(draco_->integers(joints, 4))
            : accessors_.integers(request_.primitive.attributes.at(joints), 4, selection);
    const std::vector<float> values = optional(weights, 4, selection);
    if (!numbers) {
      warnings_.add(fmt::format("{}: {} is left out: {}", request_.place, joints, numbers.error()));
      break;
    }
    const std::vector<std::uint32_t> wanted =
        draco_ && draco_->has(joints) ? selected(*numbers, 4, selection) : *numbers;
    Influences influences{{}, as_vectors<glm::vec4>(values)};
    for (std::size_t i = 0; i + 3 < wanted.size(); i += 4) {
      influences.joints.emplace_back(wanted[i], wanted[i + 1], wanted[i + 2], wanted[i + 3]);
    }
    if (influences.joints.size() != data.positions.size() ||
        influences.weights.size() != data.positions.size()) {
      warnings_.add(
          fmt::format("{}: {} is left out: it is not as long as POSITION", request_.place, joints));
      break;
    }
    data.influences.push_back(std::move(influences));
  }
}

void AttributeSource::morph(VertexData& data, const Selection& selection) {
  const auto& targets = request_.primitive.targets;
  const auto add = [&](const auto& target, const char* name, float weight, auto& values) {
    const auto found = target.find(name);
    if (found == target.end() || values.empty()) return;
    const Checked<std::size_t> count = accessors_.count(found->second);
    Checked<std::vector<float>> deltas = count && *count != declared_
                                             ? fault("it is not as long as POSITION")
                                             : accessors_.floats(found->second, 3, selection);
    if (!deltas) {
      warnings_.add(fmt::format("{}: a morph target's {} is left out: {}", request_.place, name,
                                deltas.error()));
      return;
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
      for (int c = 0; c < 3; ++c) {
        values[i][c] += weight * (*deltas)[i * 3 + static_cast<std::size_t>(c)];
      }
    }
  };
  for (std::size_t t = 0; t < targets.size(); ++t) {
    const double weight = t < request_.weights.size() ? request_.weights[t] : 0.0;
    if (!std::isfinite(weight)) {
      warnings_.add(request_.place + ": a morph weight is not finite; ignored");
      continue;
    }
    if (weight == 0.0) continue;
    add(targets[t], "POSITION", static_cast<float>(weight), data.positions);
    add(targets[t], "NORMAL", static_cast<float>(weight), data.normals);
    add(targets[t], "TANGENT", static_cast<float>(weight), data.tangents);
  }
}

}  // namespace asos::gltf
