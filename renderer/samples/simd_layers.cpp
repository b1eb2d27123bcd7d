#include "renderer/geometry/largest.h"
#include "renderer/samples/simd_samples.h"
#include "renderer/shading/anisotropy.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

// Materials of the points in a batch, and the layers of their surfaces.

namespace asos {
namespace {

/// Returns a material whose light is all its emission.
SurfaceMaterial black_material() {
  SurfaceMaterial black;
  black.base_color = black.f0 = glm::vec3(0.0f);
  black.f90 = black.dielectric_f0 = black.dielectric_f90 = 0.0f;
  return black;
}

bool finite(const ViewedMaterial& m) {
  const glm::vec3 sum =
      m.diffuse + m.specular + m.ambient + m.lobe.f0 + m.lobe.f90 + m.lobe.stretch.along;
  return std::isfinite(sum.x + sum.y + sum.z);
}

}  // namespace

// Looks up the textures of all hits whose materials have some, one material after the other.
void SimdSamples::look_up_textures() {
  arrays_->texels.clear();
  auto& sorted = arrays_->by_material;
  const auto end = std::copy_if(
      arrays_->looked_up.begin(), arrays_->looked_up.begin() + arrays_->looked_up_count,
      sorted.begin(), [&](std::size_t top) { return arrays_->material[top]->has_textures(); });
  const auto material = [&](std::size_t top) { return arrays_->material[top]; };
  const auto before = [&](std::size_t a, std::size_t b) {
    return material(a) == material(b) ? a < b : std::less<>()(material(a), material(b));
  };
  if (!std::is_sorted(sorted.begin(), end, before)) std::sort(sorted.begin(), end, before);
  for (auto first = sorted.begin(); first != end;) {
    const auto last = std::find_if(
        first, end, [&](std::size_t top) { return material(top) != material(*first); });
    look_up_textures({first, last});
    first = last;
  }
}

// Looks up the textures at hits of one material: its normal maps, and those of surface_material.
void SimdSamples::look_up_textures(std::span<const std::size_t> tops) {
  const SimdMaterial& plain = *arrays_->material[tops.front()];
  BatchTextures::Points& points = arrays_->textures.points();
  const SurfaceRest& rest = arrays_->rest;
  points.count = tops.size();
  points.masked = plain.masked;
  for (std::size_t k = 0; k < tops.size(); ++k) {
    const std::size_t top = tops[k];
    const Hit& hit = arrays_->hit[top];
    points.triangle[k] = hit.triangle;
    points.b1[k] = hit.b1, points.b2[k] = hit.b2;
    points.footprint.right_x[k] = rest.right_b1[top],
    points.footprint.right_y[k] = rest.right_b2[top];
    points.footprint.down_x[k] = rest.down_b1[top], points.footprint.down_y[k] = rest.down_b2[top];
    points.side[k] = arrays_->hits.side[top];
    points.colours[k] = arrays_->colours[top];
    if (plain.masked) points.cutoff[k] = *texel_cutoff(world_, needs_, hit);
  }
  arrays_->textures.start(world_, mips_);
  std::size_t next = arrays_->texels.size();
  for (std::size_t k = 0; k < tops.size(); ++k) {
    arrays_->first_texel[tops[k]] = next + k;
    arrays_->texel_stride[tops[k]] = tops.size();
  }
  arrays_->texels.resize(next + tops.size() * plain.texels());
  const auto look_up = [&](const TextureUse& use, TexelKind kind) {
    arrays_->textures.look_up(use, kind, std::span(arrays_->texels).subspan(next, tops.size()));
    next += tops.size();
  };
  const Material& material = world_.material_of(arrays_->hit[tops.front()].triangle);
  if (plain.normal_map) look_up(material.normal_texture, TexelKind::normal);
  if (plain.coat_map) look_up(material.coat.normal_texture, TexelKind::normal);
  for (const TextureLookUp& texture : plain.look_ups) look_up(texture.use, texture.kind);
}

// Returns the values of a hit's textures.
LookedUpTexels SimdSamples::texels(std::size_t top) const {
  const SimdMaterial& plain = *arrays_->material[top];
  if (!plain.has_textures()) return {};
  return {&arrays_->texels[arrays_->first_texel[top]], arrays_->texel_stride[top],
          mips_ && arrays_->hits.side[top] > 0.0f};
}

void SimdSamples::map_normals(std::size_t i, const TextureUse& map, glm::vec4 mean,
                              ShadingPoints& points) {
  SurfacePoint turned;
  turned.shading_normal = points.normal.at(i);
  turned.geometric_normal = arrays_->rest.geometric.at(i);
  map_normal(world_, arrays_->hit[i], map, MeanNormal{glm::vec3(mean), mean.w},
             arrays_->rest.normal_side[i], turned);
  points.normal.set(i, turned.shading_normal);
  points.spread_variance[i] = turned.spread.variance;
}

// Looks up the material of the hit whose first point is `top`, and sets that of its points.
void SimdSamples::look_up_material(std::size_t top, ShadingPoints& points) {
  const SimdMaterial& plain = *arrays_->material[top];
  const Hit& hit = arrays_->hit[top];
  const Material& material = world_.material_of(hit.triangle);
  LookedUpTexels values = texels(top);
  const glm::vec4* const normals = values.first;
  for (std::size_t k = 0; k < plain.layers.size(); ++k) {
    const bool coat = plain.layers[k] == MaterialLayer::coat;
    if (!(coat ? plain.coat_map : plain.normal_map)) continue;
    map_normals(top + k, coat ? material.coat.normal_texture : material.normal_texture,
                normals[coat && plain.normal_map ? values.stride : 0], points);
  }
  SurfaceMaterial found = plain.surface;
  if (plain.looked_up) {
    values.first += values.stride * plain.maps();
    found = surface_material(world_, needs_, hit, values);
  }
  if (found.anisotropy.strength > 0.0f)
    found.stretch =
        lobe_stretch(world_, hit, found.anisotropy, found.roughness,
                     points.normal.at(top + plain.layers.base()), points.to_viewer.at(top));
  if (const MetVolume* volume = volume_of(top)) volume->boundary.set_reflectance(found);
  set_material(top, found);
  if (plain.layered()) arrays_->layered.push_back({top, found});
}

// Sets the material of a hit's points, as far as a batch views it.
void SimdSamples::set_material(std::size_t top, const SurfaceMaterial& material) {
  const SimdMaterial& plain = *arrays_->material[top];
  if (plain.layers.size() == 1 && !material.unlit) {
    arrays_->materials.set(top, material);
    arrays_->emission[top] = shown(top, material.emission);
    return;
  }
  for (std::size_t k = 0; k < plain.layers.size(); ++k) {
    const bool own = k == plain.layers.base() && !material.unlit;
    SurfaceMaterial seen = own ? material : black_material();
    if (plain.layers[k] == MaterialLayer::coat) seen.roughness = material.coat.roughness;
    arrays_->materials.set(top + k, seen);
    arrays_->emission[top + k] = glm::vec3(0.0f);
  }
  const std::size_t base = top + plain.layers.base();
  arrays_->emission[base] = material.unlit ? (1.0f - material.transmission) * material.base_color
                                           : shown(base, material.emission);
}

// Turns a point to the other side of its surface, as for light that is transmitted diffusely.
void SimdSamples::turn_behind(std::size_t i, ShadingPoints& points) {
  const glm::vec3 normal = points.normal.at(i);
  SurfaceRest& rest = arrays_->rest;
  points.to_viewer.set(i, glm::reflect(points.to_viewer.at(i), normal));
  points.normal.set(i, -normal);
  points.position.set(i, rest.position.at(i));
  rest.geometric.set(i, -rest.geometric.at(i));
  points.geometric.set(i, rest.geometric.at(i));
  rest.lift.set(i, glm::vec3(0.0f));
  rest.smooth_normal.set(i, glm::vec3(0.0f));
}

// Views the layers of a hit that the batch has not viewed. Returns false if any value is not
// finite.
bool SimdSamples::view_layers(const LayeredHit& hit, ShadingPoints& points) {
  const SimdMaterial& plain = *arrays_->material[hit.top];
  bool all_finite = true;
  for (std::size_t k = 0; k < plain.layers.size(); ++k) {
    const MaterialLayer layer = plain.layers[k];
    const std::size_t i = hit.top + k;
    const MetVolume* volume = layer == MaterialLayer::base ? volume_of(i) : nullptr;
    if (layer == MaterialLayer::base && !plain.own_lobe && !volume) continue;
    const float n_dot_v = points.n_dot_v[i];
    if (layer == MaterialLayer::behind) turn_behind(i, points);
    const SurfacePoint place = point(i, points);
    const ViewedPoint view{place, points.to_viewer.at(i), n_dot_v};
    const float cosine = cosine_for(layer, view);
    const ViewedMaterial seen =
        volume ? volume->boundary.viewed(hit.material, cosine, volume->reflected())
               : viewed(hit.material, layer, cosine);
    all_finite = all_finite && finite(seen);
    set_viewed(i, seen, points);
  }
  return all_finite;
}

void SimdSamples::set_viewed(std::size_t i, const ViewedMaterial& seen, ShadingPoints& points) {
  points.set_material(i, seen, glm::vec3(1.0f));
  if (seen.lobe.is_sheen() || !seen.lobe.stretch.none()) points.turns[i] = 1.0f;
  MaterialBatch& materials = arrays_->materials;
  materials.specular.set(i, seen.specular);
  materials.ambient.set(i, seen.ambient);
  materials.below[i] = seen.below;
  materials.roughness[i] = seen.lobe.roughness;
}

// Computes the weights of a hit's layers, as Shader::add_material does, and of the light behind it.
void SimdSamples::weigh_layers(const LayeredHit& hit, const ShadingPoints& points) {
  const SimdMaterial& plain = *arrays_->material[hit.top];
  const MetVolume* volume = volume_of(hit.top);
  const bool hidden = volume && volume->boundary.hidden();
  const float opacity = hidden ? 0.0f : plain.blended ? hit.material.opacity : 1.0f;
  const glm::vec3 weight = arrays_->share[hit.top];
  float left = 1.0f;
  for (std::size_t k = 0; k < plain.layers.size(); ++k) {
    const std::size_t i = hit.top + k;
    arrays_->share[i] = (opacity * left) * weight;
    left *= passed_below(plain.layers[k], points.f0.at(i), arrays_->materials.ambient.at(i));
  }
  if (plain.blended) add_passage(hit, weight, opacity, left);
}

// Adds the way behind a blended surface. `left` is the fraction of light that passes the layers
// above it.
void SimdSamples::add_passage(const LayeredHit& hit, glm::vec3 weight, float opacity, float left) {
  const SurfaceMaterial& material = hit.material;
  Passage next;
  next.point = hit.top + arrays_->material[hit.top]->layers.base();
  if (!material.unlit) left *= arrays_->materials.below[next.point] * (1.0f - material.metallic);
  next.beside = (1.0f - opacity) * weight;
  next.through = (opacity * left * material.transmission) * material.base_color * weight;
  next.roughness = material.roughness;
  next.bends = material.transmission > 0.0f && material.roughness > 0.0f && !material.unlit;
  next.clear = opacity == 0.0f;
  if (const MetVolume* volume = volume_of(hit.top)) {
    const VolumeBoundary& boundary = volume->boundary;
    next.boundary = boundary;
    next.before = volume->before;
    next.bends = !boundary.hidden();
    next.clear = next.clear && next.bends;
    next.behind = next.bends ? boundary.refracted(volume->before) : boundary.passed(volume->before);
    if (next.bends) next.behind.straight = next.behind.in_medium();
  }
  arrays_->passages.push_back(next);
}

}  // namespace asos
