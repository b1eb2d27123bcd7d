#include "renderer/kernels/arc_places.h"
#include "renderer/lights/prepared_light.h"
#include "renderer/scene/make_light.h"
#include "tests/support/random_space.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asos::test::capsule_lanes_test {
namespace {

namespace lanes = asos::HWY_NAMESPACE;

double lane(lanes::DoubleLane value) {
  return hwy::HWY_NAMESPACE::GetLane(value.raw);
}

TEST(CapsuleLanes, SampleAsScalarCode) {
  RandomSpace random(34);
  int outside = 0;
  for (int round = 0; round < 2000; ++round) {
    const double radius = std::pow(10.0, random.between(-4.0, 0.0));
    Light tube = make_tube(random.between(0.5, 3.0) * random.direction(),
                           random.between(0.1, 2.0) * random.direction());
    tube.radius = radius;
    const PreparedLight light = prepare_light(tube);
    const Receiver receiver = random.receiver({0, 0, 0}, light.position, round);
    const double u = random.between(0.0, 1.0), v = random.between(0.0, 1.0);
    const auto found = lanes::SharedGeometry<LightShape::capsule>::numbers(
        light, lanes::DoubleReceivers{receiver.geometric, receiver.normal},
        lanes::DoubleVectors(light.position - receiver.position), lanes::DoubleLane(u),
        lanes::DoubleLane(v));
    if (lane(found.fourth) < 0.0) continue;
    ++outside;
    const glm::vec4 expected = sample_numbers(light, receiver, u, v);
    const glm::dvec3 point(lane(found.first), lane(found.second), lane(found.third));
    EXPECT_LT(glm::length(point - glm::dvec3(expected)), 1e-6 * glm::length(point)) << round;
    EXPECT_NEAR(lane(found.fourth), expected.w, 1e-6 * expected.w + 1e-12) << round;
  }
  EXPECT_GT(outside, 1500);
}

}  // namespace
}  // namespace asos::test::capsule_lanes_test
