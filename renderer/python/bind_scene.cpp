#include "renderer/python/bind.h"

#include <optional>
#include <span>

namespace asos::python {

namespace {

template <typename T>
std::span<const T> values_of(const std::optional<Array<T>>& array, py::ssize_t columns,
                             const char* name) {
  if (!array) return {};
  if (array->ndim() != 2 || array->shape(1) != columns)
    throw py::value_error(std::string(name) + " has the shape (n, " + std::to_string(columns) +
                          ")");
  return {array->data(), static_cast<std::size_t>(array->size())};
}

int add_mesh(api::SceneBuilder& builder, const std::string& name, const Array<float>& positions,
             const Array<std::uint32_t>& triangles, const std::optional<Array<float>>& normals,
             const std::optional<Array<float>>& uvs, const std::optional<Array<float>>& colors,
             int material) {
  const std::optional<Array<float>> places(positions);
  const std::optional<Array<std::uint32_t>> corners(triangles);
  api::MeshData mesh;
  mesh.name = name;
  mesh.positions = values_of(places, 3, "positions");
  mesh.triangles = values_of(corners, 3, "triangles");
  mesh.normals = values_of(normals, 3, "normals");
  mesh.texcoords = values_of(uvs, 2, "uvs");
  mesh.colors = values_of(colors, 4, "colors");
  return value_of(builder.add_mesh(mesh, material));
}

int add_image(api::SceneBuilder& builder, const Array<std::uint8_t>& rgba) {
  if (rgba.ndim() != 3 || rgba.shape(2) != 4)
    throw py::value_error("an image has the shape (height, width, 4)");
  return value_of(builder.add_image(static_cast<int>(rgba.shape(1)),
                                    static_cast<int>(rgba.shape(0)),
                                    {rgba.data(), static_cast<std::size_t>(rgba.size())}));
}

api::Scene load(const std::string& path, const std::string& scene, const std::string& variant,
                const std::string& asset_root, const std::string& animation,
                std::optional<double> seconds) {
  const py::gil_scoped_release others_go_on;
  auto loaded = api::Scene::load(path, {scene, variant, asset_root, animation, seconds});
  const py::gil_scoped_acquire again;
  return value_of(std::move(loaded));
}

api::Scene build(const api::SceneBuilder& builder) {
  const py::gil_scoped_release others_go_on;
  auto built = builder.build();
  const py::gil_scoped_acquire again;
  return value_of(std::move(built));
}

void bind_camera(py::module_& module) {
  using api::Camera;
  py::class_<Camera>(module, "Camera",
                     "A camera that looks along -Z of its 4x4 matrix, with +Y up. Lengths are in "
                     "metres, angles in radians.")
      .def(py::init<>())
      .def_readwrite("name", &Camera::name)
      .def_readwrite("perspective", &Camera::perspective, "Else orthographic.")
      .def_property(
          "world_from_camera", [](const Camera& c) { return rows_of(c.world_from_camera); },
          [](Camera& c, const Array<double>& rows) { c.world_from_camera = matrix_of(rows); })
      .def_readwrite("fov_y_rad", &Camera::fov_y_rad, "Full vertical angle, in (0, pi).")
      .def_readwrite("height", &Camera::height, "Orthographic: full height.")
      .def_readwrite("near_depth", &Camera::near_depth)
      .def_readwrite("far_depth", &Camera::far_depth)
      .def_readwrite("aperture_radius", &Camera::aperture_radius, "0: a pinhole.")
      .def_readwrite("focus", &Camera::focus, "Depth of the focus plane; None: automatic.")
      .def_readwrite("blades", &Camera::blades, "Corners of the aperture; 0: a disk.")
      .def_readwrite("blade_turn_rad", &Camera::blade_turn_rad)
      .def_readwrite("aspect_ratio", &Camera::aspect_ratio, "Width over height; None: any.")
      .def_readwrite("follows", &Camera::follows,
                     "The scene's camera whose motion it follows; -1: none.");
  using Fit = api::CameraFit;
  module.def(
      "fitted",
      [](const Camera& camera, double aspect_ratio, const std::string& fit) {
        return api::fitted(
            camera, aspect_ratio,
            named<Fit>(fit, {{"crop", Fit::crop}, {"fit", Fit::fit}, {"fill", Fit::fill}}));
      },
      py::arg("camera"), py::arg("aspect_ratio"), py::arg("fit") = "fit");
  module.def("aperture_of_f_stop", &api::aperture_of_f_stop, py::arg("f_stop"),
             py::arg("fov_y_rad"));
  module.def("look_at", &api::look_at, py::arg("eye"), py::arg("target"),
             py::arg("fov_y_rad") = 0.87266462);
}

void bind_light(py::module_& module) {
  using api::Light, api::LightType;
  py::enum_<LightType>(module, "LightType")
      .value("point", LightType::point)
      .value("spot", LightType::spot)
      .value("directional", LightType::directional)
      .value("linear", LightType::linear)
      .value("rectangle", LightType::rectangle)
      .value("disk", LightType::disk);
  py::class_<Light>(module, "Light",
                    "A light. Intensity: candela (point, spot, linear), lux (directional) or nits "
                    "(rectangle, disk).")
      .def(py::init<>())
      .def_readwrite("name", &Light::name)
      .def_readwrite("type", &Light::type)
      .def_readwrite("color", &Light::color)
      .def_readwrite("intensity", &Light::intensity)
      .def_readwrite("position", &Light::position)
      .def_readwrite("direction", &Light::direction)
      .def_readwrite("range", &Light::range)
      .def_readwrite("inner_cone_rad", &Light::inner_cone_rad)
      .def_readwrite("outer_cone_rad", &Light::outer_cone_rad)
      .def_readwrite("radius", &Light::radius)
      .def_readwrite("angular_diameter_rad", &Light::angular_diameter_rad)
      .def_readwrite("half_u", &Light::half_u)
      .def_readwrite("half_v", &Light::half_v)
      .def_readwrite("two_sided", &Light::two_sided)
      .def_readwrite("casts_shadows", &Light::casts_shadows);
}

void bind_material(py::module_& module) {
  using api::Material;
  py::class_<Material>(module, "Material", "A material of glTF's metallic-roughness model.")
      .def(py::init<>())
      .def_readwrite("name", &Material::name)
      .def_readwrite("base_color", &Material::base_color)
      .def_readwrite("base_color_image", &Material::base_color_image)
      .def_readwrite("metallic", &Material::metallic)
      .def_readwrite("roughness", &Material::roughness)
      .def_readwrite("emissive", &Material::emissive, "Nits.")
      .def_readwrite("ior", &Material::ior)
      .def_readwrite("transmission", &Material::transmission)
      .def_readwrite("thickness", &Material::thickness)
      .def_readwrite("blended", &Material::blended)
      .def_readwrite("double_sided", &Material::double_sided)
      .def_readwrite("unlit", &Material::unlit);
}

void bind_builder(py::module_& module) {
  using api::SceneBuilder;
  py::class_<SceneBuilder>(module, "SceneBuilder")
      .def(py::init<std::string>())
      .def("add_image", add_image)
      .def("add_material",
           [](SceneBuilder& b, const api::Material& m) { return value_of(b.add_material(m)); })
      .def("add_mesh", add_mesh)
      .def("place_mesh",
           [](SceneBuilder& b, int mesh, const Array<double>& world_from_mesh,
              const std::string& name) {
             check(b.place_mesh(mesh, matrix_of(world_from_mesh), name));
           })
      .def("add_light", [](SceneBuilder& b, const api::Light& l) { check(b.add_light(l)); })
      .def("add_camera", [](SceneBuilder& b, const api::Camera& c) { check(b.add_camera(c)); })
      .def("build", build);
}

}  // namespace

void bind_scene(py::module_& module) {
  using api::Scene;
  bind_camera(module);
  bind_light(module);
  bind_material(module);
  bind_builder(module);
  py::class_<api::AnimationInfo>(module, "AnimationInfo")
      .def_readonly("name", &api::AnimationInfo::name)
      .def_readonly("seconds", &api::AnimationInfo::seconds);
  py::class_<Scene>(module, "SceneHandle")
      .def_property_readonly("name", &Scene::name)
      .def_property_readonly("warnings", &Scene::warnings)
      .def_property_readonly("cameras", &Scene::cameras)
      .def_property_readonly("animations", &Scene::animations)
      .def_property_readonly("triangles", &Scene::triangles)
      .def("default_camera", &Scene::default_camera)
      .def("at",
           [](const Scene& scene, double seconds, const std::string& animation) {
             std::optional<api::Result<Scene>> moved;
             {
               const py::gil_scoped_release others_go_on;
               moved.emplace(scene.at(seconds, animation));
             }
             return value_of(*std::move(moved));
           })
      .def("with_lights", [](const Scene& scene, const std::vector<api::Light>& lights) {
        return value_of(scene.with_lights(lights));
      });
  module.def("load", load);
}

}  // namespace asos::python
