#include "renderer/gltf/export/gltf_writer.h"
#include "renderer/gltf/load.h"
#include "renderer/scene/posable_scene.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <array>
#include <cmath>

// Animations of scenes whose rig moves whole objects. The rig is sampled at equal intervals, which
// are halved until linear interpolation between the samples gives the rig's poses.

namespace asos::exporting {

using nlohmann::json;

namespace {

constexpr int number_type = 5126;  // 32-bit float
constexpr int most_intervals = 1024;
// Fractions of an interval where the interpolation is compared with the rig. They are irregular, so
// that no periodic motion matches by chance.
constexpr std::array<double, 3> compared_at = {0.31, 0.5, 0.77};

/// The placement of an object, in the components that glTF animates.
struct Placement {
  glm::dvec3 translation{0.0};
  glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
  glm::dvec3 scale{1.0};

  [[nodiscard]] glm::dmat4 matrix() const {
    const glm::dmat4 moved = glm::translate(glm::dmat4(1.0), translation);
    return glm::scale(moved * glm::mat4_cast(rotation), scale);
  }
};

/// Returns whether two placements differ by no more than the keys' rounding to 32 bits.
bool close(const glm::dmat4& a, const glm::dmat4& b) {
  double largest = 1.0, difference = 0.0;
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 4; ++r) {
      largest = std::max(largest, std::abs(a[c][r]));
      difference = std::max(difference, std::abs(a[c][r] - b[c][r]));
    }
  }
  return difference <= 1e-6 * largest;
}

/// Returns nullopt for a matrix that shears or has no volume.
std::optional<Placement> placement_of(const glm::dmat4& m) {
  Placement placed;
  placed.translation = glm::dvec3(m[3]);
  glm::dmat3 turn(m);
  for (int axis = 0; axis < 3; ++axis) {
    placed.scale[axis] = glm::length(turn[axis]);
    if (!(placed.scale[axis] > 0.0)) return std::nullopt;
    turn[axis] /= placed.scale[axis];
  }
  if (glm::determinant(turn) < 0.0) {
    placed.scale.x = -placed.scale.x;
    turn[0] = -turn[0];
  }
  placed.rotation = glm::normalize(glm::quat_cast(turn));
  return close(placed.matrix(), m) ? std::optional(placed) : std::nullopt;
}

Placement between(const Placement& a, const Placement& b, double t) {
  return {glm::mix(a.translation, b.translation, t), glm::slerp(a.rotation, b.rotation, t),
          glm::mix(a.scale, b.scale, t)};
}

/// Returns whether a pose differs from the pose at rest only by where its objects are.
bool moves_objects_only(const Scene& rest, const Scene& pose) {
  const auto same_mesh = [](const Mesh& a, const Mesh& b) {
    return a.positions == b.positions && a.normals == b.normals && a.material == b.material;
  };
  const auto same_object = [](const Instance& a, const Instance& b) {
    return a.mesh == b.mesh && a.shape == b.shape;
  };
  const auto same_camera = [](const Camera& a, const Camera& b) {
    return a.world_from_camera == b.world_from_camera && a.fov_y_rad == b.fov_y_rad;
  };
  return std::equal(rest.meshes.begin(), rest.meshes.end(), pose.meshes.begin(), pose.meshes.end(),
                    same_mesh) &&
         std::equal(rest.instances.begin(), rest.instances.end(), pose.instances.begin(),
                    pose.instances.end(), same_object) &&
         std::equal(rest.cameras.begin(), rest.cameras.end(), pose.cameras.begin(),
                    pose.cameras.end(), same_camera) &&
         rest.lights == pose.lights && rest.materials == pose.materials;
}

/// The placements of all objects at one time.
using Pose = std::vector<Placement>;

class Sampler {
 public:
  Sampler(const Scene& scene, int animation)
      : rig_(*scene.rig),
        animation_(animation),
        seconds_(scene.contents.animations[static_cast<std::size_t>(animation)].seconds),
        rest_(rig_.pose(std::nullopt)) {}

  /// Returns the keys, at equal intervals; nullopt: the animation cannot be written.
  std::optional<std::vector<Pose>> keys() {
    if (!rest_ || !(seconds_ > 0.0)) return std::nullopt;
    for (int intervals = 1; intervals <= most_intervals; intervals *= 2) {
      std::vector<Pose> sampled;
      for (int i = 0; i <= intervals; ++i) {
        std::optional<Pose> pose = pose_at(static_cast<double>(i) / intervals);
        if (!pose) return std::nullopt;
        sampled.push_back(std::move(*pose));
      }
      if (matches(sampled)) return sampled;
    }
    return std::nullopt;
  }

 private:
  std::optional<Pose> pose_at(double fraction) {
    const Result<Scene> scene = rig_.pose(ClipTime{animation_, fraction * seconds_});
    if (!scene || !moves_objects_only(*rest_, *scene)) return std::nullopt;
    Pose pose;
    for (const Instance& instance : scene->instances) {
      const std::optional<Placement> placed = placement_of(instance.world_from_mesh);
      if (!placed) return std::nullopt;
      pose.push_back(*placed);
    }
    return pose;
  }

  /// Returns whether the interpolated keys give the rig's poses.
  bool matches(const std::vector<Pose>& keys) {
    const std::size_t intervals = keys.size() - 1;
    for (std::size_t i = 0; i < intervals; ++i) {
      for (const double t : compared_at) {
        const auto pose = pose_at((static_cast<double>(i) + t) / static_cast<double>(intervals));
        if (!pose) return false;
        for (std::size_t k = 0; k < pose->size(); ++k)
          if (!matches(keys[i][k], keys[i + 1][k], t, (*pose)[k])) return false;
      }
    }
    return true;
  }
  static bool matches(const Placement& a, const Placement& b, double t, const Placement& expected) {
    // A turn by half a circle has no unique direction.
    constexpr double least_cosine = 0.5;  // of half the angle
    return std::abs(glm::dot(a.rotation, b.rotation)) > least_cosine &&
           close(between(a, b, t).matrix(), expected.matrix());
  }

  PosableScene& rig_;
  int animation_;
  double seconds_;
  Result<Scene> rest_;
};

/// Writes the channels of one animation.
class AnimationWriter {
 public:
  AnimationWriter(const SceneContents::Animation& animation, const std::vector<Pose>& keys,
                  GltfDocument& document)
      : keys_(keys), document_(document) {
    if (!animation.name.empty()) out_["name"] = animation.name;
    std::vector<float> times;
    for (std::size_t i = 0; i < keys.size(); ++i)
      times.push_back(static_cast<float>(animation.seconds * static_cast<double>(i) /
                                         static_cast<double>(keys.size() - 1)));
    times_ = document.add_accessor(times, "SCALAR", number_type, 0);
    json& accessor = document.root["accessors"][static_cast<std::size_t>(times_)];
    accessor["min"] = {times.front()};
    accessor["max"] = {times.back()};
  }

  /// Adds the components of an object that change.
  void add_object(std::size_t object) {
    const auto vector = [](const glm::dvec3& v) { return glm::vec3(v); };
    add(object, "translation", "VEC3", [&](const Placement& p) { return vector(p.translation); });
    glm::dquat last = keys_.front()[object].rotation;
    add(object, "rotation", "VEC4", [&](const Placement& p) {
      last = glm::dot(last, p.rotation) < 0.0 ? -p.rotation : p.rotation;
      return glm::vec4(last.x, last.y, last.z, last.w);
    });
    add(object, "scale", "VEC3", [&](const Placement& p) { return vector(p.scale); });
  }
  [[nodiscard]] json take() { return std::move(out_); }

 private:
  template <typename Component>
  void add(std::size_t object, const char* path, const char* type, const Component& component) {
    std::vector<decltype(component(Placement{}))> values;
    for (const Pose& pose : keys_) values.push_back(component(pose[object]));
    if (std::all_of(values.begin(), values.end(), [&](auto& v) { return v == values.front(); }))
      return;
    out_["samplers"].push_back(
        {{"input", times_}, {"output", document_.add_accessor(values, type, number_type, 0)}});
    out_["channels"].push_back(
        {{"sampler", out_["samplers"].size() - 1}, {"target", {{"node", object}, {"path", path}}}});
  }

  const std::vector<Pose>& keys_;
  GltfDocument& document_;
  json out_ = json::object();
  int times_ = -1;
};

/// Places a node by components, since a matrix cannot be animated.
void place_by_components(const Placement& placed, json& node) {
  node.erase("matrix");
  const glm::dvec3& t = placed.translation;
  const glm::dquat& q = placed.rotation;
  node["translation"] = {t.x, t.y, t.z};
  node["rotation"] = {q.x, q.y, q.z, q.w};
  node["scale"] = {placed.scale.x, placed.scale.y, placed.scale.z};
}

std::optional<std::vector<std::vector<Pose>>> keys_of_animations(const Scene& scene) {
  std::vector<std::vector<Pose>> all;
  for (std::size_t i = 0; scene.rig && i < scene.contents.animations.size(); ++i) {
    auto keys = Sampler(scene, static_cast<int>(i)).keys();
    if (!keys || keys->front().size() != scene.instances.size()) return std::nullopt;
    all.push_back(std::move(*keys));
  }
  return all.empty() ? std::nullopt : std::optional(std::move(all));
}

}  // namespace

void write_animations(const Scene& scene, GltfDocument& document) {
  const auto all = keys_of_animations(scene);
  if (!all) return;
  for (std::size_t i = 0; i < all->size(); ++i) {
    AnimationWriter writer(scene.contents.animations[i], (*all)[i], document);
    for (std::size_t k = 0; k < scene.instances.size(); ++k) writer.add_object(k);
    json animation = writer.take();
    if (!animation.contains("channels")) continue;
    for (const json& channel : animation["channels"]) {
      const auto node = channel["target"]["node"].get<std::size_t>();
      if (const auto rest = placement_of(scene.instances[node].world_from_mesh))
        place_by_components(*rest, document.root["nodes"][node]);
    }
    document.root["animations"].push_back(std::move(animation));
  }
}

}  // namespace asos::exporting

namespace asos {

bool writes_animations(const Scene& scene) {
  return exporting::keys_of_animations(scene).has_value();
}

}  // namespace asos
