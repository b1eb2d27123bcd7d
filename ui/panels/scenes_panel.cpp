#include "ui/panels/scenes_panel.h"

#include "renderer/files/printable.h"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace asos::ui {

void scenes_panel(Controls& controls, OpenScene& scene) {
  if (!scene) return;
  const SceneContents& contents = scene->geometry->contents;
  if (contents.scenes.size() < 2 || !controls.section("Scenes")) return;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < contents.scenes.size(); ++i)
    names.push_back(contents.scenes[i].empty()
                        ? fmt::format("{}", i)
                        : fmt::format("{}: {}", i, printable(contents.scenes[i])));
  int chosen = contents.shown_scene;
  if (controls.list("Scene", "Scene of the file to show.", names, chosen, contents.default_scene))
    scene.show_scene(chosen);
}

}  // namespace asos::ui
