#pragma once

#include "tests/renderer/gltf/gltf_builder.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/ui_rig.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>

namespace asos::test {
using namespace ui;

/// Opens a file that offers choices in a list of the panel.
class ChoiceTest : public testing::Test {
 protected:
  /// `list`: the control's name.
  ChoiceTest(std::string list, const GltfBuilder& file) : list_(std::move(list)) {
    rig.set_pixel_size(3);
    rig.settings().asos.max_level = 1;
    open(folder_.write("file.glb", file.glb()));
  }
  void open(const std::string& source) {
    const std::uint64_t opened = scene().times_opened();
    scene().open(source);
    arrive(opened);
  }
  void arrive(std::uint64_t opened) {
    EXPECT_TRUE(rig.frames_until([&] { return scene().times_opened() > opened; }));
    EXPECT_TRUE(rig.settle());
  }
  void choose(const std::string& name) {
    const std::uint64_t opened = scene().times_opened();
    rig.click(list_);
    rig.frame();
    rig.click(list_ + "/" + name);
    arrive(opened);
  }
  OpenScene& scene() { return rig.scene(); }

  TemporaryFolder folder_;
  UiRig rig{{}, {660, 700}};

 private:
  std::string list_;
};

}  // namespace asos::test
