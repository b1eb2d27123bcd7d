#pragma once

namespace asos {

class AreaShadows;
class SubdivisionVariant;

/// The parts of the engine that a method replaces (renderer/published). Null: the engine's own.
struct EngineVariant {
  const SubdivisionVariant* pixels = nullptr;  ///< for pixels and reflected pyrays
  const SubdivisionVariant* shadow_pyrays = nullptr;
  const AreaShadows* area_shadows = nullptr;
};

}  // namespace asos
