// Opens a window and shows the tiles of a render as they come. Usage: tile_window [SCENE]
#include <GLFW/glfw3.h>

#include <algorithm>
#include <asos/asos.h>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

namespace {

namespace api = asos::api;

std::uint8_t display_byte(float radiance) {
  return static_cast<std::uint8_t>(255 * std::pow(std::clamp(radiance, 0.0f, 1.0f), 1 / 2.2f));
}

// Draws rows from top to bottom, scaled to the window.
void draw(GLFWwindow* window, const api::Settings& settings, const std::vector<float>& rgb) {
  std::vector<std::uint8_t> bytes(rgb.size());
  std::transform(rgb.begin(), rgb.end(), bytes.begin(), display_byte);
  int width = 0, height = 0;
  glfwGetFramebufferSize(window, &width, &height);
  glViewport(0, 0, width, height);
  glRasterPos2f(-1, 1);
  glPixelZoom(static_cast<float>(width) / static_cast<float>(settings.width),
              -static_cast<float>(height) / static_cast<float>(settings.height));
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glDrawPixels(settings.width, settings.height, GL_RGB, GL_UNSIGNED_BYTE, bytes.data());
  glfwSwapBuffers(window);
}

int fail(const api::Error& error) {
  std::fprintf(stderr, "%s\n", error.message().c_str());
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  const api::Result<api::Scene> scene = api::Scene::load(argc > 1 ? argv[1] : "builtin:office");
  if (!scene) return fail(scene.error());
  api::Settings settings;
  settings.width = 640;
  settings.height = 360;

  if (!glfwInit()) return 1;
  GLFWwindow* window = glfwCreateWindow(settings.width, settings.height, "ASOS", nullptr, nullptr);
  if (!window) return 1;
  glfwMakeContextCurrent(window);
  {
    // Workers wake the loop below.
    api::Session session([] { glfwPostEmptyEvent(); });
    const double aspect = static_cast<double>(settings.width) / settings.height;
    const auto started = session.start(*scene, scene->default_camera(aspect), settings);
    if (!started) return fail(started.error());
    std::vector<float> rgb(3 * 640 * 360);
    while (!glfwWindowShouldClose(window)) {
      if (const auto tiles = session.take_tiles(rgb); !tiles) return fail(tiles.error());
      draw(window, settings, rgb);
      glfwWaitEventsTimeout(0.5);
    }
  }
  glfwTerminate();
  return 0;
}
