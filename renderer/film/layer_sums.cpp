#include "renderer/film/layer_sums.h"

#include <algorithm>

namespace asos {
namespace {

glm::vec3 vector_of(const LayerSum& pixel, Layer layer) {
  const double scale = pixel.weight > 0.0 ? 1.0 / pixel.weight : 0.0;
  switch (layer) {
    case Layer::direct:
      return {pixel.light.mean(LightPart::direct)};
    case Layer::emission:
      return {pixel.light.mean(LightPart::emission)};
    case Layer::reflection:
      return {pixel.light.mean(LightPart::reflection)};
    case Layer::transmission:
      return {pixel.light.mean(LightPart::transmission)};
    case Layer::background:
      return {pixel.light.mean(LightPart::background)};
    case Layer::alpha:
      return glm::vec3(static_cast<float>(pixel.alpha * scale));
    case Layer::albedo:
      return {pixel.albedo * scale};
    case Layer::normal:
      return {pixel.normal * scale};
    case Layer::geometric_normal:
      return {pixel.geometric_normal * scale};
    case Layer::position:
      return pixel.nearest.position;
    case Layer::uv:
      return {pixel.nearest.uv, 0.0f};
    case Layer::depth:
      return glm::vec3(pixel.nearest.depth);
    case Layer::distance:
      return glm::vec3(pixel.nearest.distance);
    default:
      return glm::vec3(0.0f);
  }
}

}  // namespace

void add_id(IdWeights& ids, std::uint32_t id, double weight) {
  for (auto& [known, sum] : ids) {
    if (known != id) continue;
    sum += weight;
    return;
  }
  ids.emplace_back(id, weight);
}

IdShares shares_of(const IdWeights& ids, double weight) {
  IdShares shares;
  shares.reserve(ids.size());
  for (const auto& [id, sum] : ids) shares.push_back({id, static_cast<float>(sum / weight)});
  std::sort(shares.begin(), shares.end(), [](const IdShare& a, const IdShare& b) {
    return a.share != b.share ? a.share > b.share : a.id < b.id;
  });
  return shares;
}

void LayerSum::add_ids(const LayerSample& sample, double sample_weight) {
  if (sample.covers.empty()) {
    add_id(objects, sample.object, sample_weight);
    add_id(materials, sample.material, sample_weight);
    return;
  }
  double left = sample_weight;
  for (const ObjectCover& cover : sample.covers) {
    const double covered = sample_weight * static_cast<double>(cover.share);
    add_id(objects, cover.object, covered);
    add_id(materials, cover.material, covered);
    left -= covered;
  }
  constexpr double rounding = 1e-6;  // of the shares
  if (!(left > rounding * sample_weight)) return;
  add_id(objects, no_id, left);
  add_id(materials, no_id, left);
}

void LayerSum::add(const LayerSample& sample, double sample_weight) {
  weight += sample_weight;
  add_ids(sample, sample_weight);
  if (sample.object == no_id) return;
  alpha += sample_weight * static_cast<double>(sample.alpha);
  albedo += sample_weight * glm::dvec3(sample.albedo);
  normal += sample_weight * glm::dvec3(sample.normal);
  geometric_normal += sample_weight * glm::dvec3(sample.geometric_normal);
  if (!(sample.distance < nearest.distance)) return;
  nearest = sample;
  nearest.covers.clear();
}

void LayerSum::add(const LayerSum& part, double part_weight) {
  light.add(part.light, part_weight);
  if (!(part.weight > 0.0)) return;
  const double scale = part_weight / part.weight;
  weight += part_weight;
  for (const auto& [id, sum] : part.objects) add_id(objects, id, scale * sum);
  for (const auto& [id, sum] : part.materials) add_id(materials, id, scale * sum);
  alpha += scale * part.alpha;
  albedo += scale * part.albedo;
  normal += scale * part.normal;
  geometric_normal += scale * part.geometric_normal;
  if (part.nearest.distance < nearest.distance) nearest = part.nearest;
}

std::vector<LayerPlane> planes_of(std::span<const LayerSum> pixels, LayerSet layers) {
  std::vector<LayerPlane> planes = blank_planes(layers, pixels.size());
  for (LayerPlane& plane : planes) {
    const LayerRow& row = row_of(plane.layer);
    if (!row.of_surfaces()) continue;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const LayerSum& pixel = pixels[i];
      if (row.holds_ids()) {
        if (!(pixel.weight > 0.0)) continue;
        plane.ids[i] =
            shares_of(plane.layer == Layer::object ? pixel.objects : pixel.materials, pixel.weight);
        continue;
      }
      const glm::vec3 value = vector_of(pixel, plane.layer);
      for (std::size_t c = 0; c < row.channel_count(); ++c)
        plane.values[i * row.channel_count() + c] = value[static_cast<int>(c)];
    }
  }
  return planes;
}

}  // namespace asos
