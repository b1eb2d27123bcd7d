// Renders a file with a progress bar. Ctrl+C stops the render.
// Usage: render_file SCENE OUT.(png|exr) [WIDTH HEIGHT]
#include <asos/asos.h>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>

namespace {

volatile std::sig_atomic_t interrupted = 0;

int fail(const asos::api::Error& error) {
  std::fprintf(stderr, "%s\n", error.message().c_str());
  return 1;
}

void show(const asos::api::Progress& progress) {
  const std::string bar(static_cast<std::size_t>(40 * progress.fraction), '#');
  std::fprintf(stderr, "\r[%-40s] %3.0f %%", bar.c_str(), 100 * progress.fraction);
}

}  // namespace

int main(int argc, char** argv) {
  namespace api = asos::api;
  if (argc != 3 && argc != 5) {
    std::fprintf(stderr, "usage: render_file SCENE OUT.(png|exr) [WIDTH HEIGHT]\n");
    return 2;
  }
  const api::Result<api::Scene> scene = api::Scene::load(argv[1]);
  if (!scene) return fail(scene.error());
  for (const std::string& warning : scene->warnings())
    std::fprintf(stderr, "warning: %s\n", warning.c_str());

  api::Settings settings;
  if (argc == 5) {
    settings.width = std::atoi(argv[3]);
    settings.height = std::atoi(argv[4]);
  }
  std::stop_source stop;
  std::signal(SIGINT, [](int) { interrupted = 1; });
  api::RenderOptions options;
  options.stop = stop.get_token();
  options.on_progress = [&](const api::Progress& progress) {
    show(progress);
    if (interrupted) stop.request_stop();
  };
  const double aspect = static_cast<double>(settings.width) / settings.height;
  const api::Result<api::Picture> picture =
      api::render(*scene, scene->default_camera(aspect), settings, options);
  std::fprintf(stderr, "\n");
  if (!picture) return fail(picture.error());
  if (const api::Result<void> saved = picture->save(argv[2]); !saved) return fail(saved.error());
  std::printf("%s: %dx%d pixels, %.2f s, %llu rays\n", argv[2], picture->width(), picture->height(),
              picture->seconds(), static_cast<unsigned long long>(picture->rays()));
  return 0;
}
