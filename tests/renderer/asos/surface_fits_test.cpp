#include "renderer/asos/surface_fits.h"

#include "tests/support/tiny_scene.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <memory>
#include <vector>

namespace asos::test::surface_fits_test {
namespace {

constexpr int side = 8;
constexpr double noise = 0.01;

/// The leaves of a block on one plane, side x side of them, with the values of a function and
/// alternating errors of a tenth of their noise.
class SurfaceFits : public ::testing::Test {
 protected:
  SurfaceFits() {
    World world;
    add_quad(world, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, matte(glm::vec3(0.5f)));
    add_quad(world, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}, matte(glm::vec3(0.5f)));
    scene_ = make_render_scene(std::move(world), {});
  }

  template <typename Value>
  void set(Value&& value) {
    own_.clear();
    leaves_.clear();
    for (int i = 0; i < side * side; ++i) {
      Leaf& leaf = own_.emplace_back();
      leaf.at = (glm::vec2(i % side, i / side) + 0.5f) / static_cast<float>(side);
      leaf.hit.triangle = 0;
      leaf.point.position = {leaf.at, 0.0f};
      leaf.point.shading_normal = leaf.point.geometric_normal = {0, 0, 1};
      SampledLeaf& sampled = leaves_.emplace_back();
      sampled.leaf = &leaf;
      sampled.reflectance = glm::vec3(1.0f);
      const double error = ((i + i / side) % 2 == 0 ? 0.1 : -0.1) * noise;
      sampled.found = {glm::dvec3(value(leaf.at) + error), noise, 16.0};
    }
  }
  void fit() { fit_surfaces(scene_->features(), leaves_); }
  [[nodiscard]] std::ptrdiff_t fitted() const {
    return std::count_if(leaves_.begin(), leaves_.end(), [](const auto& l) { return l.fitted; });
  }
  [[nodiscard]] static double ramp(glm::vec2 at) { return 0.6 + 0.3 * static_cast<double>(at.x); }

  std::shared_ptr<const RenderScene> scene_;
  std::deque<Leaf> own_;
  std::vector<SampledLeaf> leaves_;
};

TEST_F(SurfaceFits, ShareSamplesOfSmoothVariation) {
  set(ramp);
  fit();
  EXPECT_EQ(fitted(), side * side);
  for (const SampledLeaf& leaf : leaves_)
    EXPECT_NEAR(leaf.found.value.x + leaf.correction.x, ramp(leaf.leaf->at), 0.04 * noise);
}

TEST_F(SurfaceFits, FollowTheReflectanceOfATexture) {
  set(ramp);
  for (std::size_t i = 0; i < leaves_.size(); i += 3) {
    leaves_[i].reflectance = {0.2f, 0.0f, 0.5f};
    leaves_[i].found.value *= glm::dvec3(leaves_[i].reflectance);
    leaves_[i].found.error *= 0.5;
  }
  fit();
  EXPECT_EQ(fitted(), side * side);
  EXPECT_NEAR(leaves_[0].found.value.z + leaves_[0].correction.z, 0.5 * ramp(leaves_[0].leaf->at),
              0.04 * noise);
}

// A shadow's edge, which no quadratic fits: the quarters of the block that it crosses are refused.
TEST_F(SurfaceFits, RefuseAnEdge) {
  set([](glm::vec2 at) { return at.x + 0.2f * at.y < 0.35f ? 0.9 : 0.55; });
  fit();
  EXPECT_LE(fitted(), side * side / 2);
  for (const SampledLeaf& leaf : leaves_)
    if (leaf.leaf->at.x < 0.5f) {
      EXPECT_FALSE(leaf.fitted);
    }
}

TEST_F(SurfaceFits, LeaveOutWhatContradicts) {
  set(ramp);
  leaves_[side + 1].found.value -= 6.0 * noise;
  fit();
  EXPECT_EQ(fitted(), side * side - 1);
  EXPECT_FALSE(leaves_[side + 1].fitted);
  EXPECT_EQ(leaves_[side + 1].correction, glm::dvec3(0.0));
}

// Half of the leaves lie on another surface, which is brighter.
TEST_F(SurfaceFits, KeepSurfacesApart) {
  set(ramp);
  for (std::size_t i = 0; i < leaves_.size(); i += 2) {
    own_[i].hit.triangle = 2;
    leaves_[i].found.value += 0.2;
  }
  fit();
  EXPECT_EQ(fitted(), side * side);
  EXPECT_NEAR(leaves_[0].found.value.x + leaves_[0].correction.x, 0.2 + ramp(leaves_[0].leaf->at),
              0.2 * noise);
}

TEST_F(SurfaceFits, NeedLeavesThatAreOpen) {
  set(ramp);
  for (SampledLeaf& leaf : leaves_) leaf.converged = true;
  fit();
  EXPECT_EQ(fitted(), 0) << "their own samples suffice";
  set(ramp);
  leaves_.resize(13);
  fit();
  EXPECT_EQ(fitted(), 0) << "too few";
}

}  // namespace
}  // namespace asos::test::surface_fits_test
