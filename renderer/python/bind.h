#pragma once

#include <array>
#include <asos/asos.h>
#include <cstddef>
#include <map>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <string>
#include <utility>

// Shared by the files of the Python module.

namespace asos::python {

namespace py = pybind11;

/// An array of Python's, converted to this type and to contiguous rows where it has others.
template <typename T>
using Array = py::array_t<T, py::array::c_style | py::array::forcecast>;

/// Raises the Python exception of asos.errors that belongs to the error's code.
[[noreturn]] void raise(const api::Error& error);

/// Returns the value, or raises the error's exception.
template <typename T>
T value_of(api::Result<T> result) {
  if (!result) raise(result.error());
  return std::move(*result);
}
void check(const api::Result<void>& result);

/// Takes a 4x4 matrix whose rows are Python's rows. Raises ValueError for another shape.
[[nodiscard]] api::Matrix4 matrix_of(const Array<double>& rows);
[[nodiscard]] Array<double> rows_of(const api::Matrix4& matrix);

/// Returns the value of a name. Raises ValueError for another name.
template <typename Enum>
Enum named(const std::string& name, const std::map<std::string, Enum>& names) {
  const auto found = names.find(name);
  if (found == names.end()) throw py::value_error("no such choice: '" + name + "'");
  return found->second;
}
[[nodiscard]] const std::map<std::string, api::Tone>& tone_names();

/// Reads settings by their names in `Scene.render`. Raises TypeError for another name, or another
/// type.
[[nodiscard]] api::Settings settings_of(const py::dict& values);

void bind_lists(py::module_& module);
void bind_scene(py::module_& module);
void bind_render(py::module_& module);

}  // namespace asos::python
