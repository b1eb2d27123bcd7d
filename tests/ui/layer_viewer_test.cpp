#include "ui/layer_viewer.h"

#include "renderer/film/image_io.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/panels_fixture.h"

#include <gtest/gtest.h>

#include <string>

namespace asos::test::layer_viewer_test {
namespace {

class LayerViewerTest : public PanelsTest {
 protected:
  /// The colour in the middle of the picture, where the layer is drawn in its place.
  [[nodiscard]] glm::u8vec3 middle() {
    const Film& film = *rig.content().layers().film();
    return display_bytes(film.radiance[film.index(film.width / 2, film.height / 2)], 0.0f);
  }
  void show(Layer layer) {
    display().layer = layer;
    rig.frame();
    ASSERT_TRUE(rig.settle());
    rig.frame();
  }
};

// The red triangle faces the camera at (0, 0, 3).
TEST_F(LayerViewerTest, KeysGoThroughTheLayers) {
  rig.key(Key::left_bracket);
  EXPECT_EQ(display().layer, Layer::error) << "the last one";
  rig.key(Key::right_bracket);
  EXPECT_FALSE(display().layer);
  rig.key(Key::right_bracket);
  EXPECT_EQ(display().layer, Layer::alpha);
  EXPECT_EQ(rig.state().message, "Alpha");
  show(Layer::normal);
  EXPECT_EQ(middle(), glm::u8vec3(128, 128, 255));
  show(Layer::albedo);
  EXPECT_EQ(middle(), glm::u8vec3(255, 0, 0));
  display().layer.reset();
  rig.frame();
  EXPECT_EQ(rig.content().layers().film(), nullptr) << "the picture";
}

TEST_F(LayerViewerTest, LegendAndPointerHaveTheUnit) {
  show(Layer::distance);
  const std::string legend = rig.controls().at("Layer scale").words;
  EXPECT_EQ(legend.substr(legend.size() - 2), " m") << legend;
  const Film& film = rig.film();
  const std::string words =
      layer_words(film, Layer::distance, film.index(film.width / 2, film.height / 2));
  EXPECT_NEAR(std::stof(words), 3.0f, 0.05f) << words;
  EXPECT_EQ(words.substr(words.size() - 2), " m");
}

// A layer is rendered while it is shown, and only then.
TEST_F(LayerViewerTest, RendersOnlyTheLayerThatIsShown) {
  EXPECT_TRUE(rig.film().layers.empty());
  show(Layer::object);
  ASSERT_EQ(rig.film().layers.size(), 1u);
  show(Layer::depth);
  ASSERT_EQ(rig.film().layers.size(), 1u);
  EXPECT_EQ(rig.film().layers[0].layer, Layer::depth);
  EXPECT_TRUE(settings().layers.empty()) << "it is no setting of the person's";
  settings().method = Method::beam;
  show(Layer::depth);
  EXPECT_TRUE(rig.film().layers.empty());
  EXPECT_EQ(rig.controls().at("Layer scale").words, "This method does not render it.");
}

TEST_F(LayerViewerTest, SavesAllOrTheOneThatIsShown) {
  const TemporaryFolder folder;
  show(Layer::depth);
  for (const bool all : {false, true}) {
    SaveChoice& save = rig.state().save;
    save.exr = true;
    save.layers = all ? SaveChoice::Layers::all : SaveChoice::Layers::shown;
    save.size = {16, 9};
    save.stem = folder.file(all ? "all" : "one");
    const std::string path = save.path();
    save.asked = true;
    ASSERT_TRUE(rig.frames_until([&] { return std::filesystem::exists(path); }));
    const std::string bytes = content_of(path);
    EXPECT_NE(bytes.find("depth.Z"), std::string::npos);
    EXPECT_EQ(bytes.find("normal.X") != std::string::npos, all);
    EXPECT_EQ(read_exr(path)->film.width, 16);
  }
}

}  // namespace
}  // namespace asos::test::layer_viewer_test
