#pragma once

#include "tests/support/rendering_equation.h"
#include "tests/support/tiny_world.h"

#include <cmath>

namespace asos::test {

/// The material with the lobes of the formula.
inline Material material_of(const Reflector& reflector) {
  Material material = matte(glm::vec3(reflector.base));
  material.metallic = static_cast<float>(reflector.metallic);
  material.roughness = static_cast<float>(reflector.roughness);
  material.coat.factor = static_cast<float>(reflector.coat);
  material.coat.roughness = static_cast<float>(reflector.coat_roughness);
  material.sheen.color = glm::vec3(reflector.sheen);
  material.sheen.roughness = static_cast<float>(reflector.sheen_roughness);
  // For the plane: u grows along x, the bitangent is z.
  material.anisotropy.strength = static_cast<float>(reflector.anisotropy);
  material.anisotropy.rotation_rad =
      static_cast<float>(std::atan2(reflector.tangent.z, reflector.tangent.x));
  return material;
}

}  // namespace asos::test
