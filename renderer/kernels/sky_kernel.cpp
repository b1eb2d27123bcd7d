#include "renderer/kernels/sky_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/kernels/sky_kernel.cpp"
#include <hwy/foreach_target.h>  // this file again, once for each instruction set
// Include after foreach_target.h, whose definitions these use.
#include "renderer/kernels/lanes.h"
#include "renderer/shading/environment.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace asos::HWY_NAMESPACE {
namespace {

constexpr std::size_t most_lanes = hn::MaxLanes(FloatTag());
/// The four components of a node, all at once where there are lanes.
using NodeTag = hn::CappedTag<float, 4>;
using NodeLanes = LaneOf<NodeTag>;

struct PlaceLanes {
  Lane x, y;
};

/// As OctahedralMap::place.
HWY_INLINE PlaceLanes octahedral_place(const Vectors& d) {
  const auto sum = abs(d.x) + abs(d.y) + abs(d.z);
  const auto scale = 1.0f / sum;
  const PlaceLanes p{d.x * scale, d.z * scale};
  const auto down = d.y < 0.0f;
  return {selected(down, copysign(1.0f - abs(p.y), p.x), p.x),
          selected(down, copysign(1.0f - abs(p.x), p.y), p.y)};
}

/// The number below each coordinate and the rest; 0 for NaN, which must not become an index.
struct Split {
  Lane below, rest;
};
HWY_INLINE Split split(Lane x, Lane most) {
  const auto below = where(x >= 0.0f, min(floor(x), most));
  return {below, x - below};
}

/// One point per element.
struct Places {
  HWY_ALIGN float x[most_lanes];
  HWY_ALIGN float y[most_lanes];
  HWY_INLINE explicit Places(const PlaceLanes& lanes) {
    lanes.x.store(x);
    lanes.y.store(y);
  }
};

HWY_INLINE NodeLanes between(NodeLanes a, NodeLanes b, float rest) {
  return a + rest * (b - a);
}

/// The cell of a map around a place.
struct Cell {
  const float* above;
  const float* below;
  float right, down;

  /// As OctahedralMap::at.
  HWY_INLINE Cell(const OctahedralMap& map, float x, float y) {
    const float cells = static_cast<float>(map.cells);
    const float half = 0.5f * cells;
    const auto lower = [cells](float at)
                           HWY_ATTR { return at >= 0.0f ? std::min(std::floor(at), cells) : 0.0f; };
    const float across = (x + 1.0f) * half, along = (y + 1.0f) * half;
    const float column = lower(across), row = lower(along);
    above = &map.nodes[static_cast<std::size_t>(static_cast<std::int32_t>(row) * map.stride() +
                                                static_cast<std::int32_t>(column))]
                 .x;
    below = above + 4 * map.stride();
    right = across - column;
    down = along - row;
  }
  /// Returns components from c on.
  [[nodiscard]] HWY_INLINE NodeLanes value(std::size_t c) const {
    const auto a = between(NodeLanes::loaded(above + c), NodeLanes::loaded(above + 4 + c), right);
    const auto b = between(NodeLanes::loaded(below + c), NodeLanes::loaded(below + 4 + c), right);
    return between(a, b, down);
  }
};

/// Values of one vector per point, stored component by component.
struct Values {
  HWY_ALIGN float x[most_lanes];
  HWY_ALIGN float y[most_lanes];
  HWY_ALIGN float z[most_lanes];

  /// Calls value(c) for the components from c on.
  template <class Value>
  HWY_INLINE void set(std::size_t i, const Value& value) {
    HWY_ALIGN float node[4];
    for (std::size_t c = 0; c < 4; c += NodeLanes::count()) value(c).store(node + c);
    x[i] = node[0], y[i] = node[1], z[i] = node[2];
  }
  HWY_INLINE void clear(std::size_t i) { x[i] = y[i] = z[i] = 0.0f; }
  [[nodiscard]] HWY_INLINE Vectors lanes() const {
    return {Lane::loaded(x), Lane::loaded(y), Lane::loaded(z)};
  }
};

/// As Sky::PictureLobes::turned.
HWY_INLINE Vectors turned(const Sky::PictureLobes& sky, const Vectors& d) {
  const auto c = sky.turn_cos, s = sky.turn_sin;
  return {c * d.x - s * d.z, d.y, s * d.x + c * d.z};
}

/// Returns the part of reflected_sky by the lobe, for points from i on.
HWY_INLINE Vectors by_lobe(const Sky::PictureLobes& sky, const Vectors& normal, Lane reflects,
                           Lane roughness, const Vectors& to_viewer, const Vectors& specular,
                           std::size_t count) {
  const Vectors ray = -to_viewer;
  const auto cosine = dot(normal, ray);
  const Vectors mirrored = ray - 2.0f * (cosine * normal);
  const Places places(octahedral_place(turned(sky, mirrored)));
  const auto step =
      roughness * static_cast<float>(SkyLobes::steps) - static_cast<float>(SkyLobes::first_step);
  const auto at = clamp(step, 0.0f, static_cast<float>(SkyLobes::maps - 1));
  const Split maps = split(at, static_cast<float>(SkyLobes::maps - 2));
  HWY_ALIGN float map[most_lanes];
  HWY_ALIGN float rest[most_lanes];
  HWY_ALIGN float wanted[most_lanes];
  maps.below.store(map);
  maps.rest.store(rest);
  reflects.store(wanted);
  Values around;
  for (std::size_t k = 0; k < Lane::count(); ++k) {
    if (k < count && wanted[k] > 0.0f) {
      const auto finer = static_cast<std::size_t>(map[k]);
      const Cell a(sky.lobes->lobe(finer), places.x[k], places.y[k]);
      const Cell b(sky.lobes->lobe(finer + 1), places.x[k], places.y[k]);
      around.set(k,
                 [&](std::size_t c) HWY_ATTR { return between(a.value(c), b.value(c), rest[k]); });
    } else {
      around.clear(k);
    }
  }
  const auto loss = (1.0f - sky_visibility) * roughness * roughness;
  const auto visible = 1.0f - loss;
  const Vectors lit = visible * (sky.brightness * around.lanes());
  const auto some = reflects > 0.0f;
  return {where(some, lit.x * specular.x), where(some, lit.y * specular.y),
          where(some, lit.z * specular.z)};
}

void reflect(const Sky::PictureLobes& sky, const MaterialBatch& materials,
             const ShadingPoints& points, SkyBatch& reflected) {
  const auto brightness = sky_visibility * sky.brightness;
  for (std::size_t i = 0; i < points.count; i += Lane::count()) {
    const std::size_t count = std::min(points.count - i, Lane::count());
    const Vectors normal = loaded(points.normal, i);
    const Places places(octahedral_place(turned(sky, normal)));
    Values irradiance;
    for (std::size_t k = 0; k < Lane::count(); ++k) {
      if (k < count) {
        const Cell cell(sky.lobes->irradiance(), places.x[k], places.y[k]);
        irradiance.set(k, [&](std::size_t c) HWY_ATTR { return cell.value(c); });
      } else {
        irradiance.clear(k);
      }
    }
    const Vectors ambient = loaded(materials.ambient, i);
    const Vectors lit = brightness * irradiance.lanes();
    store({lit.x * ambient.x, lit.y * ambient.y, lit.z * ambient.z}, reflected.diffuse, i);
    const auto reflects = loaded(reflected.lobe_reflects, i);
    const auto wanted = reflects > 0.0f && LaneMask::first(count);
    Vectors specular{0.0f, 0.0f, 0.0f};
    if (!none(wanted))
      specular = by_lobe(sky, normal, reflects, loaded(materials.roughness, i),
                         loaded(points.to_viewer, i), loaded(materials.specular, i), count);
    store(specular, reflected.by_lobe, i);
  }
}

}  // namespace
}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace asos {

HWY_EXPORT(reflect);

void reflect_sky(const Sky::PictureLobes& sky, const MaterialBatch& materials,
                 const ShadingPoints& points, SkyBatch& reflected) {
  HWY_DYNAMIC_DISPATCH(reflect)(sky, materials, points, reflected);
}

}  // namespace asos
#endif
