#include "renderer/python/bind.h"

#include <chrono>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

namespace asos::python {

namespace {

/// (height, width), or (height, width, channels) of a Layer or a LayerView.
template <typename Values>
std::vector<py::ssize_t> shape_of(const Values& layer) {
  std::vector<py::ssize_t> shape{layer.height, layer.width};
  if (layer.info.channels > 1) shape.push_back(layer.info.channels);
  return shape;
}

/// Hands a layer's values to numpy, which then owns them.
py::array_t<float> array_of(api::Layer layer) {
  auto values = std::make_unique<std::vector<float>>(std::move(layer.values));
  float* data = values->data();
  const py::capsule owner(values.release(),
                          [](void* held) { delete static_cast<std::vector<float>*>(held); });
  return py::array_t<float>(shape_of(layer), data, owner);
}

/// Shows numpy the values that the picture holds, for reading. The array keeps the picture.
py::array_t<float> array_of(const api::LayerView& view, const api::Picture& picture) {
  py::array_t<float> array(shape_of(view), view.values.data(), py::cast(api::Picture(picture)));
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

py::array_t<float> layer(const api::Picture& picture, const std::string& name) {
  if (const auto view = picture.view(name)) return array_of(*view, picture);
  return array_of(value_of(picture.layer(name)));
}

/// Columns of the parts of pixels: index of the pixel, id, share.
py::tuple id_shares(const api::Picture& picture, const std::string& name) {
  const std::vector<api::IdShare> shares = value_of(picture.id_shares(name));
  const auto count = static_cast<py::ssize_t>(shares.size());
  py::array_t<std::uint32_t> pixels(count);
  py::array_t<std::int32_t> ids(count);
  py::array_t<float> parts(count);
  for (py::ssize_t i = 0; i < count; ++i) {
    const api::IdShare& share = shares[static_cast<std::size_t>(i)];
    pixels.mutable_at(i) = share.pixel;
    ids.mutable_at(i) = share.id;
    parts.mutable_at(i) = share.share;
  }
  return py::make_tuple(pixels, ids, parts);
}

// Tells Python about a render, and stops it by a signal (Ctrl+C) or an exception of the callback.
// The interface would turn an exception into an error, so that it waits here.
class Listener {
 public:
  explicit Listener(py::object on_progress) : on_progress_(std::move(on_progress)) {}

  void hear(const api::Progress& progress) {
    const py::gil_scoped_acquire python;
    if (exception_) return;
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (!on_progress_.is_none()) on_progress_(progress);
    } catch (const py::error_already_set& raised) {
      exception_ = raised;
      stop_.request_stop();
    }
  }
  [[nodiscard]] std::stop_token stop() const { return stop_.get_token(); }
  void raise_what_came() {
    if (exception_) throw py::error_already_set(*exception_);
  }

 private:
  py::object on_progress_;
  std::optional<py::error_already_set> exception_;
  std::stop_source stop_;
};

api::Picture render(const api::Scene& scene, const api::Camera& camera, const py::dict& settings,
                    const py::object& on_progress, std::optional<double> time_limit) {
  const api::Settings wanted = settings_of(settings);
  Listener listener(on_progress);
  api::RenderOptions options;
  options.on_progress = [&](const api::Progress& progress) { listener.hear(progress); };
  options.stop = listener.stop();
  options.time_limit_seconds = time_limit;
  std::optional<api::Result<api::Picture>> rendered;
  {
    const py::gil_scoped_release others_go_on;
    rendered.emplace(api::render(scene, camera, wanted, options));
  }
  listener.raise_what_came();
  return value_of(std::move(*rendered));
}

template <typename T>
py::list list_of(const std::vector<T>& items, py::dict (*convert)(const T&)) {
  py::list list;
  for (const T& item : items) list.append(convert(item));
  return list;
}

py::dict dict_of(const api::TracedSample& s) {
  using namespace py::literals;
  return py::dict("x"_a = s.x, "y"_a = s.y, "weight"_a = s.weight, "radiance"_a = s.radiance);
}

py::dict dict_of(const api::TracedEdge& e) {
  using namespace py::literals;
  return py::dict("from_x"_a = e.from_x, "from_y"_a = e.from_y, "to_x"_a = e.to_x,
                  "to_y"_a = e.to_y);
}

py::dict dict_of(const api::TracedCell& c) {
  using namespace py::literals;
  return py::dict("level"_a = c.level, "x"_a = c.x, "y"_a = c.y, "side"_a = c.side,
                  "fate"_a = c.fate, "edges"_a = list_of<api::TracedEdge>(c.edges, dict_of),
                  "samples"_a = list_of<api::TracedSample>(c.samples, dict_of));
}

py::dict trace(const api::Scene& scene, const api::Camera& camera, const py::dict& settings, int x,
               int y) {
  using namespace py::literals;
  const api::Settings wanted = settings_of(settings);
  std::optional<api::Result<api::PixelTrace>> result;
  {
    const py::gil_scoped_release others_go_on;
    result.emplace(api::trace_pixel(scene, camera, wanted, x, y));
  }
  const api::PixelTrace traced = value_of(std::move(*result));
  return py::dict("radiance"_a = traced.radiance, "level"_a = traced.level,
                  "cause"_a = traced.cause, "unresolved_area"_a = traced.unresolved_area,
                  "cells"_a = list_of<api::TracedCell>(traced.cells, dict_of));
}

void bind_picture(py::module_& module) {
  using api::Picture;
  py::class_<Picture>(module, "PictureHandle")
      .def_property_readonly("width", &Picture::width)
      .def_property_readonly("height", &Picture::height)
      .def_property_readonly("finished", &Picture::finished)
      .def_property_readonly("seconds", &Picture::seconds)
      .def_property_readonly("rays", &Picture::rays)
      .def("layer_names",
           [](const Picture& picture) {
             std::vector<std::string> names;
             for (const api::LayerInfo& info : picture.layers()) names.push_back(info.name);
             return names;
           })
      .def("layer", layer)
      .def("id_shares", id_shares)
      .def("id_names", [](const Picture& picture,
                          const std::string& name) { return value_of(picture.id_names(name)); })
      .def("predicted_level",
           [](const Picture& picture, double eps, int max) {
             return array_of(value_of(picture.predicted_level(eps, max)));
           })
      .def("save",
           [](const Picture& picture, const std::string& path, float exposure_ev,
              const std::optional<std::string>& tone) {
             api::SaveOptions options{exposure_ev, std::nullopt};
             if (tone) options.tone = named(*tone, tone_names());
             check(picture.save(path, options));
           })
      .def("save_split_map",
           [](const Picture& picture, const std::string& path, const std::string& kind) {
             using Kind = api::SplitMapKind;
             check(picture.save_split_map(path, named<Kind>(kind, {{"level", Kind::level},
                                                                   {"cause", Kind::cause},
                                                                   {"rays", Kind::rays},
                                                                   {"time", Kind::time}})));
           });
  module.def("compare", [](const Picture& picture, const Picture& reference) {
    const api::Difference d = value_of(api::compare(picture, reference));
    return py::make_tuple(d.rmse, d.psnr_db, d.mean_absolute, d.p99, d.worst, d.rmse_display,
                          d.delta_e);
  });
}

std::vector<std::array<int, 4>> take_tiles(api::Session& session, py::array_t<float>& rgb) {
  const auto tiles =
      value_of(session.take_tiles({rgb.mutable_data(), static_cast<std::size_t>(rgb.size())}));
  std::vector<std::array<int, 4>> rectangles;
  for (const api::Rect& tile : tiles)
    rectangles.push_back({tile.x, tile.y, tile.width, tile.height});
  return rectangles;
}

void bind_session(py::module_& module) {
  using api::Session;
  const auto free = py::call_guard<py::gil_scoped_release>();
  py::class_<Session>(module, "SessionHandle")
      .def(py::init([] { return std::make_unique<Session>(); }))
      .def("start",
           [](Session& session, const api::Scene& scene, const api::Camera& camera,
              const py::dict& settings) {
             check(session.start(scene, camera, settings_of(settings)));
           })
      .def("cancel", &Session::cancel, free)
      .def("pause", &Session::pause)
      .def("resume", &Session::resume)
      .def("progress", &Session::progress)
      .def(
          "wait",
          [](Session& session, int milliseconds) {
            return session.wait(std::chrono::milliseconds(milliseconds));
          },
          free)
      .def("take_tiles", take_tiles)
      .def("picture", [](const Session& session) { return value_of(session.picture()); });
}

}  // namespace

void bind_render(py::module_& module) {
  using api::Progress;
  py::class_<Progress>(module, "Progress", "How far a render has come.")
      .def_readonly("running", &Progress::running)
      .def_readonly("paused", &Progress::paused)
      .def_readonly("finished", &Progress::finished)
      .def_readonly("failed", &Progress::failed)
      .def_readonly("fraction", &Progress::fraction, "Of the forecast work, 0 to 1.")
      .def_readonly("seconds", &Progress::seconds)
      .def_readonly("seconds_left", &Progress::seconds_left, "An estimate, or None.");
  bind_picture(module);
  bind_session(module);
  module.def("render", render);
  module.def("trace", trace);
}

}  // namespace asos::python
