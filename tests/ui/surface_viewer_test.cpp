#include "ui/surface_viewer.h"

#include "renderer/world/ground.h"
#include "tests/ui/panels_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace asos::test::surface_viewer_test {
using namespace ui;
namespace {

class SurfaceViewerTest : public PanelsTest {
 protected:
  SurfaceViewerTest() : PanelsTest(1, {660, 600}) {}

  SurfaceChoice& choice() { return rig.state().surfaces; }
  [[nodiscard]] bool shown() {
    return rig.frames_until(
        [&] { return rig.content().surfaces().picture() && !rig.content().surfaces().busy(); });
  }
  [[nodiscard]] glm::u8vec3 at(glm::ivec2 pixel) {
    return rig.pixels()[static_cast<std::size_t>(pixel.y * rig.size().x + pixel.x)];
  }
  [[nodiscard]] glm::ivec2 centre() {
    const PixelRect rect = rig.content().picture_rect();
    return {rect.width / 2, rect.height / 2};
  }
  [[nodiscard]] glm::u8vec3 middle() { return at(centre()); }
  [[nodiscard]] Hit seen(glm::ivec2 pixel) {
    return rig.viewpoint().seen_at(pixel.x + 0.5, pixel.y + 0.5);
  }
};

// The red triangle faces the camera at (0, 0, 3).
TEST_F(SurfaceViewerTest, KeysShowAPropertyAndThePictureAgain) {
  const glm::u8vec3 picture = middle();
  rig.key(Key::n);
  ASSERT_TRUE(shown());
  rig.frame();
  EXPECT_EQ(choice().property, SurfaceProperty::normal);
  EXPECT_EQ(middle(), glm::u8vec3(128, 128, 255));
  rig.key(Key::b);
  ASSERT_TRUE(rig.frames_until([&] { return middle() == glm::u8vec3(255, 0, 0); }));
  rig.key(Key::b);
  rig.frame();
  EXPECT_FALSE(choice().property);
  EXPECT_EQ(middle(), picture);
  EXPECT_EQ(rig.content().surfaces().picture(), nullptr);
}

// The plate under the model is no part of the file: it once hid what is behind it.
TEST_F(SurfaceViewerTest, LeavesTheGroundOut) {
  choice().property = SurfaceProperty::base_color;
  settings().ground = Ground::on;
  ASSERT_TRUE(rig.frames_until([&] { return ground_of(rig.scene()->world()) == Ground::on; }));
  ASSERT_TRUE(rig.settle());
  ASSERT_TRUE(shown());
  const SurfacePicture& surfaces = *rig.content().surfaces().picture();
  const World& world = rig.scene()->world();
  int on_ground = 0;
  for (int y = 0; y < surfaces.film.height; y += 7) {
    for (int x = 0; x < surfaces.film.width; x += 7) {
      const Hit hit = seen({x, y});
      if (!hit.valid() || world.triangle_part[hit.triangle] + 1 != world.solid_parts()) continue;
      ++on_ground;
      EXPECT_LT(surfaces.film.coverage[surfaces.film.index(x, y)], 1.0f) << x << ' ' << y;
    }
  }
  EXPECT_GT(on_ground, 20);
}

TEST_F(SurfaceViewerTest, FollowsTheCamera) {
  choice().property = SurfaceProperty::base_color;
  ASSERT_TRUE(shown());
  rig.frame();
  EXPECT_EQ(middle(), glm::u8vec3(255, 0, 0));
  const std::uint64_t before = rig.content().surfaces().revision();
  rig.camera().orbit(2.8, 0.0);  // the grey one is in front now
  ASSERT_TRUE(rig.frames_until([&] {
    return rig.content().surfaces().revision() > before && !rig.content().surfaces().busy();
  }));
  rig.frame();
  const World& world = rig.scene()->world();
  int surfaces = 0;
  for (int y = 5; y < rig.content().picture_rect().height; y += 45) {
    const Hit hit = seen({centre().x, y});
    if (!hit.valid()) continue;
    ++surfaces;
    EXPECT_EQ(at({centre().x, y}),
              display_bytes(glm::vec3(world.material_of(hit.triangle).base_color), 0.0f))
        << y;
  }
  EXPECT_GE(surfaces, 3);
}

TEST_F(SurfaceViewerTest, TheWireframeLiesOverThePicture) {
  const auto colours = [&] {
    std::set<std::array<int, 3>> found;
    const PixelRect rect = rig.content().picture_rect();
    const auto pixels = rig.pixels();
    for (int y = 0; y < rect.height; ++y) {
      for (int x = 0; x < rect.width; ++x) {
        const glm::u8vec3 c = pixels[static_cast<std::size_t>(y * rig.size().x + x)];
        found.insert({c.x, c.y, c.z});
      }
    }
    return found;
  };
  const auto is_line = [](const std::array<int, 3>& c) {
    return c[0] > 200 && c[1] > 100 && c[1] < 170 && c[2] < 80;
  };
  const auto plain = colours();
  EXPECT_EQ(std::count_if(plain.begin(), plain.end(), is_line), 0);
  rig.key(Key::y);
  ASSERT_TRUE(shown());
  rig.frame();
  EXPECT_FALSE(choice().property);
  const auto lined = colours();
  EXPECT_GT(std::count_if(lined.begin(), lined.end(), is_line), 0);
}

TEST_F(SurfaceViewerTest, NamesWhatIsUnderThePointer) {
  EXPECT_EQ(surface_names(rig.previewer(), centre()).joined(), "Object 1, Material 1");
  const glm::ivec2 corner(0, 0);
  ASSERT_FALSE(seen(corner).valid());
  EXPECT_EQ(surface_names(rig.previewer(), corner).joined(), "");
  rig.move_to(glm::vec2(centre()) + 0.5f);
  rig.frame();
  EXPECT_TRUE(rig.state().hovered);
}

TEST_F(SurfaceViewerTest, TheListChoosesAProperty) {
  rig.unfold("Surfaces");
  rig.click("Wireframe");
  EXPECT_TRUE(choice().wireframe);
  ASSERT_TRUE(shown());
}

}  // namespace
}  // namespace asos::test::surface_viewer_test
