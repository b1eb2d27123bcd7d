#pragma once

#include "renderer/scene/scene.h"

#include <string>

namespace asos::gltf {

/// Why `light` is not what scene.h promises of its type, in words that follow its name; empty where
/// it is. The lights that the importer adds and those that the exporter writes have no fault.
[[nodiscard]] std::string light_fault(const Light& light);

}  // namespace asos::gltf
