#include "asos/picture.h"
#include "renderer/api/convert.h"
#include "renderer/api/picture_impl.h"
#include "renderer/asos/predicted_level.h"
#include "renderer/film/layers.h"
#include "renderer/picture/exr_picture.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace asos::api {
namespace {

static_assert(sizeof(glm::vec3) == 3 * sizeof(float));

LayerInfo info_of(const LayerRow& row) {
  return {row.name, std::max(1, static_cast<int>(row.channel_count())), row.unit, row.about,
          row.holds_ids()};
}

std::span<const float> floats(const std::vector<glm::vec3>& values) {
  return {&values.data()->x, 3 * values.size()};
}

/// The values of a layer that are stored as floats; empty: none are.
std::span<const float> stored(const Film& film, asos::Layer layer) {
  switch (layer) {
    case asos::Layer::beauty:
      return floats(film.radiance);
    case asos::Layer::rays:
      return film.rays;
    case asos::Layer::time:
      return film.seconds;
    default:
      break;
  }
  if (const LayerPlane* plane = find_plane(film.layers, layer)) return plane->values;
  if (layer == asos::Layer::alpha) return film.coverage;
  return {};
}

bool has_layer(const Film& film, asos::Layer layer) {
  return !has_plane(layer) || find_plane(film.layers, layer) ||
         (layer == asos::Layer::alpha && !film.coverage.empty());
}

Error no_layer(const std::string& name) {
  return failure(ErrorCode::invalid_argument, "layer '" + name + "'",
                 "the picture has no layer of this name");
}

/// The picture's layer of this name; null: none.
const LayerRow* find_layer(const Film& film, const std::string& name) {
  for (const LayerRow& row : layer_table())
    if (name == row.name && has_layer(film, row.value)) return &row;
  return nullptr;
}

float id_of(const IdShares& shares) {
  return shares.empty() || shares.front().id == no_id ? -1.0f
                                                      : static_cast<float>(shares.front().id);
}

/// The values of a layer that is not stored as floats.
std::vector<float> converted(const Film& film, asos::Layer layer) {
  std::vector<float> values;
  values.reserve(film.radiance.size());
  if (layer == asos::Layer::level)
    for (const std::uint8_t level : film.split_level) values.push_back(level);
  else if (layer == asos::Layer::cause)
    for (const SplitCause cause : film.cause) values.push_back(static_cast<float>(cause));
  else if (const LayerPlane* plane = find_plane(film.layers, layer))
    for (const IdShares& shares : plane->ids) values.push_back(id_of(shares));
  return values;
}

/// The layer of ids of this name; null: there is none.
const LayerPlane* find_ids(const Film& film, const std::string& name) {
  const LayerRow* row = find_layer(film, name);
  return row && row->holds_ids() ? find_plane(film.layers, row->value) : nullptr;
}

}  // namespace

std::vector<LayerInfo> layer_list() {
  std::vector<LayerInfo> all;
  for (const LayerRow& row : layer_table()) all.push_back(info_of(row));
  return all;
}

std::vector<LayerInfo> Picture::layers() const {
  std::vector<LayerInfo> infos;
  for (const LayerRow& row : layer_table())
    if (has_layer(impl_->result.film, row.value)) infos.push_back(info_of(row));
  return infos;
}

Result<Layer> Picture::layer(const std::string& name) const {
  return guarded("layer", [&]() -> Result<Layer> {
    const Film& film = impl_->result.film;
    const LayerRow* row = find_layer(film, name);
    if (!row) return no_layer(name);
    const std::span<const float> values = stored(film, row->value);
    Layer layer{info_of(*row), film.width, film.height, {values.begin(), values.end()}};
    if (values.empty()) layer.values = converted(film, row->value);
    return layer;
  });
}

Result<LayerView> Picture::view(const std::string& name) const {
  return guarded("layer", [&]() -> Result<LayerView> {
    const Film& film = impl_->result.film;
    const LayerRow* row = find_layer(film, name);
    if (!row) return no_layer(name);
    const std::span<const float> values = stored(film, row->value);
    if (values.empty())
      return failure(ErrorCode::invalid_argument, "layer '" + name + "'",
                     "is not stored as floats");
    return LayerView{info_of(*row), film.width, film.height, values};
  });
}

Result<std::vector<IdShare>> Picture::id_shares(const std::string& name) const {
  return guarded("layer", [&]() -> Result<std::vector<IdShare>> {
    const LayerPlane* plane = find_ids(impl_->result.film, name);
    if (!plane) return no_layer(name);
    std::vector<IdShare> shares;
    for (std::size_t i = 0; i < plane->ids.size(); ++i)
      for (const asos::IdShare& share : plane->ids[i])
        shares.push_back({static_cast<std::uint32_t>(i),
                          share.id == no_id ? -1 : static_cast<std::int32_t>(share.id),
                          share.share});
    return shares;
  });
}

Result<std::vector<std::string>> Picture::id_names(const std::string& name) const {
  return guarded("layer", [&]() -> Result<std::vector<std::string>> {
    const LayerPlane* plane = find_ids(impl_->result.film, name);
    if (!plane) return no_layer(name);
    const Snapshot& of = impl_->snapshot;
    ExrOptions named = exr_options(*of.scene, of.camera, of.settings);
    return plane->layer == asos::Layer::object ? std::move(named.object_names)
                                               : std::move(named.material_names);
  });
}

Result<Layer> Picture::predicted_level(double eps, int max_level) const {
  return guarded("prediction", [&]() -> Result<Layer> {
    const Film& film = impl_->result.film;
    if (film.outlook.empty())
      return failure(ErrorCode::invalid_argument, "prediction",
                     "only pictures by asos can be predicted");
    RenderSettings asked = impl_->snapshot.settings;
    asked.asos.eps = eps;
    asked.asos.max_level = max_level;
    if (const auto valid = validated(asked); !valid)
      return failure(ErrorCode::invalid_argument, valid.error());
    const LevelPrediction prediction(impl_->snapshot.settings, asked);
    Layer layer{info_of(row_of(asos::Layer::level)), film.width, film.height, {}};
    for (const SplitPredictionData& pixel : film.outlook)
      layer.values.push_back(static_cast<float>(prediction.level_of(pixel)));
    return layer;
  });
}

}  // namespace asos::api
