#include "renderer/python/bind.h"

#include <functional>
#include <map>

namespace asos::python {

void raise(const api::Error& error) {
  const py::object exception =
      py::module_::import("asos.errors")
          .attr("exception_of")(static_cast<int>(error.code), error.subject, error.reason,
                                error.message());
  PyErr_SetObject(py::type::of(exception).ptr(), exception.ptr());
  throw py::error_already_set();
}

void check(const api::Result<void>& result) {
  if (!result) raise(result.error());
}

api::Matrix4 matrix_of(const Array<double>& rows) {
  if (rows.ndim() != 2 || rows.shape(0) != 4 || rows.shape(1) != 4)
    throw py::value_error("a matrix has the shape (4, 4)");
  api::Matrix4 columns{};
  for (py::ssize_t row = 0; row < 4; ++row)
    for (py::ssize_t column = 0; column < 4; ++column)
      columns[static_cast<std::size_t>(4 * column + row)] = rows.at(row, column);
  return columns;
}

Array<double> rows_of(const api::Matrix4& matrix) {
  Array<double> rows({4, 4});
  for (py::ssize_t row = 0; row < 4; ++row)
    for (py::ssize_t column = 0; column < 4; ++column)
      rows.mutable_at(row, column) = matrix[static_cast<std::size_t>(4 * column + row)];
  return rows;
}

namespace {

using Setter = std::function<void(api::Settings&, const py::handle&)>;

template <typename T>
Setter sets(T api::Settings::*member) {
  return [member](api::Settings& settings, const py::handle& value) {
    settings.*member = value.cast<T>();
  };
}

template <typename Enum>
Setter sets_by_name(Enum api::Settings::*member, std::map<std::string, Enum> names) {
  return [member, names = std::move(names)](api::Settings& settings, const py::handle& value) {
    const auto name = value.cast<std::string>();
    const auto found = names.find(name);
    if (found == names.end()) throw py::value_error("no such choice: '" + name + "'");
    settings.*member = found->second;
  };
}

void set_crop(api::Settings& settings, const py::handle& value) {
  if (value.is_none()) return settings.crop.reset();
  const auto [x, y, width, height] = value.cast<std::array<int, 4>>();
  settings.crop = api::Rect{x, y, width, height};
}

const std::map<std::string, Setter>& setters() {
  using api::Background, api::Ground, api::Settings, api::Tone;
  static const std::map<std::string, Setter> all{
      {"width", sets(&Settings::width)},
      {"height", sets(&Settings::height)},
      {"crop", set_crop},
      {"method", sets(&Settings::method)},
      {"max", sets(&Settings::max_level)},
      {"eps", sets(&Settings::eps)},
      {"samples", sets(&Settings::samples)},
      {"texture_resolution", sets(&Settings::texture_resolution)},
      {"shadows", sets(&Settings::shadows)},
      {"sky_shadows", sets(&Settings::sky_shadows)},
      {"bounces", sets(&Settings::bounces)},
      {"reflections", sets(&Settings::reflections)},
      {"sky", sets(&Settings::sky)},
      {"sky_turn_deg", sets(&Settings::sky_turn_deg)},
      {"sky_brightness", sets(&Settings::sky_brightness)},
      {"ground", sets_by_name<Ground>(&Settings::ground, {{"auto", Ground::automatic},
                                                          {"off", Ground::off},
                                                          {"on", Ground::on},
                                                          {"mirror", Ground::mirror}})},
      {"background",
       sets_by_name<Background>(&Settings::background, {{"auto", Background::automatic},
                                                        {"environment", Background::environment},
                                                        {"colours", Background::colours},
                                                        {"transparent", Background::transparent}})},
      {"background_top", sets(&Settings::background_top)},
      {"background_bottom", sets(&Settings::background_bottom)},
      {"tone",
       sets_by_name<Tone>(&Settings::tone,
                          {{"none", Tone::none}, {"neutral", Tone::neutral}, {"agx", Tone::agx}})},
      {"seed", sets(&Settings::seed)},
      {"threads", sets(&Settings::threads)}};
  return all;
}

}  // namespace

api::Settings settings_of(const py::dict& values) {
  api::Settings settings;
  for (const auto& [key, value] : values) {
    const auto name = key.cast<std::string>();
    const auto found = setters().find(name);
    if (found == setters().end()) throw py::type_error("there is no setting '" + name + "'");
    try {
      found->second(settings, value);
    } catch (const py::cast_error&) {
      throw py::type_error("setting '" + name + "' has another type");
    }
  }
  return settings;
}

}  // namespace asos::python

PYBIND11_MODULE(_asos, module) {
  module.doc() = "The compiled part of the package asos.";
  module.def("version", &asos::api::version);
  module.def("method_names", &asos::api::method_names);
  module.def("cause_name", &asos::api::cause_name);
  asos::python::bind_scene(module);
  asos::python::bind_render(module);
}
