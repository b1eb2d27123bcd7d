#pragma once

#include "asos/error.h"
#include "asos/types.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace asos::api {

struct LoadOptions {
  std::string scene = {};    ///< of the file's scenes, by number or name; empty: its default
  std::string variant = {};  ///< of its materials (KHR_materials_variants); empty: none
  /// Folder that buffers and images may come from; empty: at most three levels above the file.
  std::string asset_root = {};
  /// A moment of one of the file's animations: which of them, by number from 0 or name (empty: the
  /// first), and seconds from its beginning. Without `seconds` the scene is at rest.
  std::string animation = {};
  std::optional<double> seconds = {};
};

/// An animation of a file.
struct AnimationInfo {
  std::string name;      ///< may be empty
  double seconds = 0.0;  ///< to its last key; later times show its last pose
};

/// A scene that is ready to render: an immutable handle that is cheap to copy. All members may be
/// called from any thread at once. A handle that was moved from may only be destroyed or assigned.
class ASOS_API Scene {
 public:
  struct Impl;
  explicit Scene(std::shared_ptr<const Impl> impl);  ///< made by the functions below
  Scene(const Scene&);
  Scene(Scene&&) noexcept;
  Scene& operator=(const Scene&);
  Scene& operator=(Scene&&) noexcept;
  ~Scene();

  /// Opens a .gltf or .glb file, or a built-in scene ("builtin:office"). Blocks while it reads.
  /// Fails with `cannot_open` where the file is missing, damaged or too large, and with
  /// `invalid_argument` where it has no such animation or the time is not 0 or more.
  [[nodiscard]] static Result<Scene> load(const std::string& path, const LoadOptions& options = {});

  /// Returns the same scene in other light: these lights replace its own and its default lighting.
  /// Luminous surfaces go on shining. Geometry and materials are shared. Fails with
  /// `invalid_argument` where a light is not finite or has no size.
  [[nodiscard]] Result<Scene> with_lights(std::span<const Light> lights) const;

  /// Returns the scene at a moment of one of its file's animations, as LoadOptions selects it. Only
  /// what moves is built again, and the file is not read again. Its lights are those of this scene
  /// after `with_lights`. Fails with `invalid_argument` where there is no such animation, or the
  /// time is not 0 or more.
  [[nodiscard]] Result<Scene> at(double seconds, const std::string& animation = {}) const;

  [[nodiscard]] std::string name() const;
  /// Repaired or ignored parts of the file, each as a sentence.
  [[nodiscard]] std::vector<std::string> warnings() const;
  /// The scene's cameras, in the file's order.
  [[nodiscard]] std::vector<Camera> cameras() const;
  /// Returns the first camera (`fitted`), or one that frames the scene, for a picture of this
  /// aspect ratio (width over height, above 0).
  [[nodiscard]] Camera default_camera(double aspect_ratio) const;
  /// The file's animations.
  [[nodiscard]] std::vector<AnimationInfo> animations() const;
  /// Triangles of all instances; analytic shapes other than boxes have none.
  [[nodiscard]] std::uint64_t triangles() const;

  [[nodiscard]] const Impl& impl() const { return *impl_; }  ///< for the library itself

 private:
  std::shared_ptr<const Impl> impl_;
};

/// Collects a scene from the caller's arrays. Numbers of meshes, materials and images count from 0
/// in the order of the calls. One thread at a time. A call that fails adds nothing.
class ASOS_API SceneBuilder {
 public:
  /// `name`: of the scene, in messages.
  explicit SceneBuilder(std::string name = "scene");
  SceneBuilder(SceneBuilder&&) noexcept;
  SceneBuilder& operator=(SceneBuilder&&) noexcept;
  ~SceneBuilder();

  /// Adds an image of 8-bit sRGB with linear alpha, rows from the top. Fails with
  /// `invalid_argument` unless there are 4 * width * height bytes.
  [[nodiscard]] Result<int> add_image(int width, int height, std::span<const std::uint8_t> rgba);
  /// Adds a material. Fails with `invalid_argument` where a factor is out of range, or the image
  /// does not exist.
  [[nodiscard]] Result<int> add_material(const Material& material);
  /// Adds a mesh, which shows once it is placed. Fails with `invalid_argument` where arrays do not
  /// fit each other, an index is out of range, or a value is not finite.
  [[nodiscard]] Result<int> add_mesh(const MeshData& mesh, int material);
  /// Places a mesh. It may be placed any number of times. Fails with `invalid_argument` where there
  /// is no such mesh or the matrix is not affine.
  Result<void> place_mesh(int mesh, const Matrix4& world_from_mesh = identity,
                          const std::string& name = {});
  /// Places an analytic shape. Fails with `invalid_argument` as `place_mesh` does, and for sizes
  /// that are out of range.
  Result<void> place_shape(const Shape& shape, int material,
                           const Matrix4& world_from_shape = identity,
                           const std::string& name = {});
  /// Adds a light. Fails with `invalid_argument` where it is not finite or has no size.
  Result<void> add_light(const Light& light);
  /// Adds a camera. Fails with `invalid_argument` where a value is out of range.
  Result<void> add_camera(const Camera& camera);

  /// Makes the scene ready to render. The builder keeps its contents and can go on. Fails with
  /// `out_of_memory`, or with `invalid_argument` for more than 60 million triangles.
  [[nodiscard]] Result<Scene> build() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace asos::api
