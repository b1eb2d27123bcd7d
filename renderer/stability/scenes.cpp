#include "renderer/stability/scenes.h"

#include "renderer/lights/prepared_light.h"
#include "renderer/scene/builtin/shapes.h"
#include "renderer/scene/make_light.h"

#include <cmath>
#include <cstdint>

namespace asos::stability {

Material unlit(float grey) {
  Material material;
  material.base_color = glm::vec4(glm::vec3(grey), 1.0f);
  material.unlit = true;
  material.double_sided = true;
  return material;
}

Material matte(float grey) {
  Material material;
  material.base_color = glm::vec4(glm::vec3(grey), 1.0f);
  material.metallic = 0.0f;
  material.roughness = 1.0f;
  material.ior = 1.0f;
  material.specular = 0.0f;  // no gloss at grazing angles
  material.double_sided = true;
  return material;
}

Material mirror() {
  Material material = matte(1.0f);
  material.metallic = 1.0f;
  material.roughness = 0.0f;
  return material;
}

Material mirror(const DfrCurve& curve) {
  Material material = mirror();
  material.dfr = Dfr{{curve, curve, curve}, 0.0};
  return material;
}

void add_shape(Scene& scene, const Shape& shape, const Material& material,
               const glm::dmat4& world_from_shape) {
  place(scene, Mesh{}, material, world_from_shape);
  scene.instances.back().shape = static_cast<int>(scene.shapes.size());
  scene.shapes.push_back(shape);
}

Shape ball_shape(double radius) {
  Shape shape;
  shape.type = Shape::Type::sphere;
  shape.radius = radius;
  return shape;
}

Shape cylinder_shape(double height, double bottom, double top) {
  Shape shape;
  shape.type = Shape::Type::cylinder;
  shape.height = height;
  shape.radius_bottom = bottom;
  shape.radius_top = top;
  return shape;
}

void place(Scene& scene, Mesh mesh, const Material& material, const glm::dmat4& world_from_mesh) {
  mesh.material = static_cast<int>(scene.materials.size());
  scene.materials.push_back(material);
  Instance instance;
  instance.mesh = static_cast<int>(scene.meshes.size());
  instance.world_from_mesh = world_from_mesh;
  scene.meshes.push_back(std::move(mesh));
  scene.instances.push_back(instance);
}

Mesh mesh_of(const std::vector<glm::dvec3>& convex_corners) {
  Mesh mesh;
  for (const glm::dvec3& p : convex_corners) mesh.positions.emplace_back(p);
  for (std::uint32_t i = 1; i + 1 < mesh.positions.size(); ++i)
    mesh.triangles.emplace_back(0, i, i + 1);
  return mesh;
}

void add(Scene& scene, const Face& face) {
  place(scene, mesh_of(face.corners), unlit(face.colour));
}

Scene scene_of(const std::vector<Face>& faces, const Camera& camera) {
  Scene scene;
  scene.name = "stability";
  for (const Face& face : faces) add(scene, face);
  scene.cameras.push_back(camera);
  return scene;
}

void add_dark_light(Scene& scene) {
  Light light;
  light.intensity = 1e-30f;
  light.position = {0, 0, -99};
  scene.lights.push_back(light);
}

Camera look_at(glm::dvec3 eye, glm::dvec3 target, double fov_y_deg) {
  const glm::dvec3 back = glm::normalize(eye - target);
  const glm::dvec3 up = std::abs(back.y) > 0.999 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
  const glm::dvec3 right = glm::normalize(glm::cross(up, back));
  Camera camera;
  camera.fov_y_rad = glm::radians(fov_y_deg);
  camera.world_from_camera =
      glm::dmat4(glm::dvec4(right, 0), glm::dvec4(glm::cross(back, right), 0), glm::dvec4(back, 0),
                 glm::dvec4(eye, 1));
  return camera;
}

Camera parallel(glm::dvec3 eye, glm::dvec3 target, double height) {
  Camera camera = look_at(eye, target, 50.0);
  camera.type = Camera::Type::orthographic;
  camera.height = height;
  return camera;
}

Face tilted_card(float colour) {
  // A turn by about 21 degrees.
  const double c = 239.0 / 256.0;
  const double s = 92.0 / 256.0;
  return {{{-c + s, -s - c, 0}, {c + s, s - c, 0}, {c - s, s + c, 0}, {-c - s, -s + c, 0}}, colour};
}

Camera card_camera() {
  return look_at({0, 0, 4}, {0, 0, 0}, 50.0);
}

Scene still_life() {
  Scene scene;
  scene.name = "still life";
  place(scene, mesh_of({{-3, 0, 3}, {3, 0, 3}, {3, 0, -3}, {-3, 0, -3}}), matte(0.75f));
  Mesh box;
  builtin::add_box(box, {-0.5f, 0.125f, -0.375f}, {0.5f, 1.125f, 0.625f});
  place(scene, box, matte(0.5f));
  scene.lights.push_back(make_panel({1.0, 3.0, 0.5}, {0, -1, 0}, {0.5, 0, 0}, {0, 0, 0.5}, 8.0f));
  scene.cameras.push_back(look_at({1.5, 2.0, 4.0}, {0, 0.5, 0}, 50.0));
  return scene;
}

Scene transformed(Scene scene, const glm::dmat4& similarity, double scale) {
  for (Instance& instance : scene.instances)
    instance.world_from_mesh = similarity * instance.world_from_mesh;
  for (Light& light : scene.lights) {
    light.position = glm::dvec3(similarity * glm::dvec4(light.position, 1.0));
    light.half_u *= scale;
    light.half_v *= scale;
    light.radius *= scale;
    const LightTraits& traits = traits_of(light_shape(light));
    const bool in_candela = !traits.flat && !traits.infinite;
    if (in_candela) light.intensity *= static_cast<float>(scale * scale);
  }
  for (Camera& camera : scene.cameras) {
    camera.world_from_camera[3] = similarity * camera.world_from_camera[3];
    camera.height *= scale;
  }
  return scene;
}

}  // namespace asos::stability
