#include "renderer/picture/light_json.h"

#include "renderer/lights/light_kinds.h"
#include "renderer/picture/json_fields.h"

namespace asos {
namespace {

template <typename Fields, typename L>
void each_light_value(Fields& fields, L& light) {
  fields("name", light.name);
  fields.named("type", light_type_names, light.type);
  fields("color", light.color);
  fields("intensity", light.intensity);
  fields("position", light.position);
  fields("direction", light.direction);
  fields.unbounded("range", light.range);
  fields("inner_cone_rad", light.inner_cone_rad);
  fields("outer_cone_rad", light.outer_cone_rad);
  fields("radius", light.radius);
  fields("angular_diameter_rad", light.angular_diameter_rad);
  fields("half_u", light.half_u);
  fields("half_v", light.half_v);
  fields("two_sided", light.two_sided);
  fields("casts_shadows", light.casts_shadows);
  fields("own_part", light.own_part);
}

OrderedJson outlines_json(const std::vector<std::vector<glm::dvec3>>& outlines) {
  OrderedJson all = OrderedJson::array();
  for (const auto& outline : outlines) {
    OrderedJson points = OrderedJson::array();
    for (const glm::dvec3& p : outline) points.push_back({p.x, p.y, p.z});
    all.push_back(std::move(points));
  }
  return all;
}

void read_outlines(FieldReader& fields, Light& light) {
  const OrderedJson* all = fields.take("outlines");
  if (!all) return;
  if (!all->is_array()) return fields.refuse("outlines", "is no list");
  for (const OrderedJson& points : *all) {
    if (!points.is_array()) return fields.refuse("outlines", "holds what is no list of points");
    auto& outline = light.outlines.emplace_back();
    for (const OrderedJson& point : points)
      fields.vector("outlines", point, outline.emplace_back(0.0));
  }
}

}  // namespace

OrderedJson lights_json(const std::vector<Light>& lights) {
  OrderedJson all = OrderedJson::array();
  for (const Light& light : lights) {
    FieldWriter fields;
    each_light_value(fields, light);
    fields.other("outlines", outlines_json(light.outlines));
    all.push_back(fields.take());
  }
  return all;
}

Result<std::vector<Light>> lights_from_json(const OrderedJson& json) {
  if (!json.is_array()) return unexpected(Error{"lights", "lights are no list"});
  std::vector<Light> lights;
  for (const OrderedJson& one : json) {
    FieldReader fields(one, fmt::format("light {}", lights.size() + 1));
    Light& light = lights.emplace_back();
    each_light_value(fields, light);
    read_outlines(fields, light);
    if (std::string fault = fields.fault(); !fault.empty())
      return unexpected(Error{"lights", std::move(fault)});
  }
  return lights;
}

}  // namespace asos
