#include "renderer/film/layer_mean.h"

#include <algorithm>

namespace asos {

LayerSet LayerMean::needed(LayerSet asked) {
  for (const Layer layer : asked.layers())
    if (row_of(layer).filter == LayerFilter::nearest) asked.insert(Layer::distance);
  return asked;
}

// Returns which pixels' surfaces are nearer than in all renderings before.
std::vector<bool> LayerMean::nearer(std::span<const LayerPlane> planes) const {
  std::vector<bool> found;
  const LayerPlane* distances = find_plane(planes, Layer::distance);
  if (!distances) return found;
  const auto own = std::find_if(sums_.begin(), sums_.end(), [](const Sum& sum) {
    return sum.nearest.layer == Layer::distance;
  });
  for (std::size_t i = 0; i < distances->values.size(); ++i)
    found.push_back(distances->values[i] < own->nearest.values[i]);
  return found;
}

void LayerMean::add(std::span<const LayerPlane> planes, double weight) {
  if (sums_.empty()) {
    for (const LayerPlane& plane : planes) {
      const std::size_t pixels =
          plane.ids.empty() ? plane.values.size() / row_of(plane.layer).channel_count() : 0;
      sums_.push_back({LayerPlane(plane.layer, pixels), std::vector<double>(plane.values.size()),
                       std::vector<IdWeights>(plane.ids.size())});
    }
  }
  const std::vector<bool> replaced = nearer(planes);
  for (std::size_t k = 0; k < sums_.size(); ++k) {
    Sum& sum = sums_[k];
    const LayerPlane& plane = planes[k];
    const LayerRow& row = row_of(plane.layer);
    const std::size_t channels = std::max<std::size_t>(row.channel_count(), 1);
    const bool nearest = row.filter == LayerFilter::nearest;
    for (std::size_t i = 0; i < plane.values.size(); ++i) {
      if (!nearest)
        sum.values[i] += weight * static_cast<double>(plane.values[i]);
      else if (replaced[i / channels])
        sum.nearest.values[i] = plane.values[i];
    }
    for (std::size_t i = 0; i < plane.ids.size(); ++i)
      for (const IdShare& share : plane.ids[i])
        add_id(sum.ids[i], share.id, weight * static_cast<double>(share.share));
  }
}

std::vector<LayerPlane> LayerMean::planes(LayerSet asked) const {
  std::vector<LayerPlane> all;
  for (const Sum& sum : sums_) {
    if (!asked.has(sum.nearest.layer)) continue;
    LayerPlane& plane = all.emplace_back(sum.nearest);
    if (row_of(plane.layer).filter != LayerFilter::nearest)
      std::transform(sum.values.begin(), sum.values.end(), plane.values.begin(),
                     [](double value) { return static_cast<float>(value); });
    plane.ids.clear();
    for (const IdWeights& ids : sum.ids) plane.ids.push_back(shares_of(ids, 1.0));
  }
  return all;
}

}  // namespace asos
