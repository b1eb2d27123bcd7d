#include "app/from_option.h"

#include <CLI/CLI.hpp>

#include <utility>

namespace asos {

void add_from_option(CLI::App& app, PictureArguments& arguments) {
  const auto take = [&arguments](const std::string& file) {
    arguments.from_file = file;
    Result<PictureDescription> read = read_description(file);
    if (!read) {
      arguments.from_error = read.error();
      return;
    }
    arguments.scene = read->scene;
    arguments.settings = read->settings;
    arguments.sky = read->sky;
    arguments.sky_chosen = arguments.ground_chosen = arguments.background_chosen = true;
    arguments.render_features = read->render_features;
    arguments.exposure_ev = read->display.exposure_ev;
    arguments.exposure_chosen = true;
    arguments.tone = read->display.tone;
    arguments.from = *std::move(read);
  };
  app.add_option_function<std::string>("--from", take,
                                       "Picture saved by ASOS: restores scene, camera, lights and "
                                       "settings; other options override")
      ->type_name("PICTURE.(png|exr)");
}

}  // namespace asos
