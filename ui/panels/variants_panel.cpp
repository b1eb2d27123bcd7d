#include "ui/panels/variants_panel.h"

#include "renderer/files/printable.h"

#include <algorithm>
#include <string>
#include <vector>

namespace asos::ui {

void variants_panel(Controls& controls, OpenScene& scene) {
  if (!scene) return;
  const SceneContents& contents = scene->geometry->contents;
  if (contents.variants.empty() || !controls.section("Variants")) return;
  std::vector<std::string> names{"None"};
  for (const std::string& variant : contents.variants) names.push_back(printable(variant));
  const auto found =
      std::find(contents.variants.begin(), contents.variants.end(), contents.variant);
  int chosen = 0;
  if (!contents.variant.empty() && found != contents.variants.end())
    chosen = static_cast<int>(found - contents.variants.begin()) + 1;
  if (controls.list("Variant", "Material variant. None: default materials.", names, chosen, 0))
    scene.show_variant(chosen == 0 ? std::string()
                                   : contents.variants[static_cast<std::size_t>(chosen) - 1]);
}

}  // namespace asos::ui
