#include "renderer/python/bind.h"

#include <algorithm>
#include <functional>
#include <map>
#include <vector>

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
    settings.*member = named(value.cast<std::string>(), names);
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
                                                        {"blurred", Background::blurred},
                                                        {"colours", Background::colours},
                                                        {"transparent", Background::transparent}})},
      {"background_top", sets(&Settings::background_top)},
      {"background_bottom", sets(&Settings::background_bottom)},
      {"tone", sets_by_name<Tone>(&Settings::tone, tone_names())},
      {"shutter_seconds", sets(&Settings::shutter_seconds)},
      {"layers", sets(&Settings::layers)},
      {"seed", sets(&Settings::seed)},
      {"threads", sets(&Settings::threads)}};
  return all;
}

/// Whether the interface lists a setting of this name.
bool is_listed(const std::string& name) {
  static const std::vector<api::SettingInfo> list = api::setting_list();
  return std::any_of(list.begin(), list.end(),
                     [&](const api::SettingInfo& info) { return info.name == name; });
}

/// The text of a value: "on", "0.5", "exact", or "0.05,1,32" for a sequence.
std::string text_of(const py::handle& value) {
  if (py::isinstance<py::bool_>(value)) return value.cast<bool>() ? "on" : "off";
  if (py::isinstance<py::str>(value) || !py::isinstance<py::sequence>(value)) return py::str(value);
  std::string text;
  for (const py::handle& one : value) text += (text.empty() ? "" : ",") + text_of(one);
  return text;
}

py::list setting_list() {
  py::list list;
  for (const api::SettingInfo& info : api::setting_list())
    list.append(
        py::make_tuple(info.name, info.about, info.usual, info.choices, info.least, info.most));
  return list;
}

py::list layer_list() {
  py::list list;
  for (const api::LayerInfo& info : api::layer_list())
    list.append(py::make_tuple(info.name, info.channels, info.unit, info.about, info.ids));
  return list;
}

}  // namespace

const std::map<std::string, api::Tone>& tone_names() {
  static const std::map<std::string, api::Tone> names{
      {"none", api::Tone::none}, {"neutral", api::Tone::neutral}, {"agx", api::Tone::agx}};
  return names;
}

void bind_lists(py::module_& module) {
  module.def("setting_list", setting_list);
  module.def("layer_list", layer_list);
}

api::Settings settings_of(const py::dict& values) {
  api::Settings settings;
  for (const auto& [key, value] : values) {
    const auto name = key.cast<std::string>();
    const auto found = setters().find(name);
    if (found == setters().end()) {
      if (!is_listed(name)) throw py::type_error("there is no setting '" + name + "'");
      settings.more[name] = text_of(value);
      continue;
    }
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
  asos::python::bind_lists(module);
  asos::python::bind_scene(module);
  asos::python::bind_render(module);
}
