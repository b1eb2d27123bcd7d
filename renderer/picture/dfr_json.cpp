#include "renderer/picture/dfr_json.h"

#include "renderer/picture/json_fields.h"

#include <array>
#include <utility>

namespace asos {
namespace {

constexpr std::array<const char*, 3> channel_names{"red", "green", "blue"};

template <typename Fields, typename Curve>
void each_curve_value(Fields& fields, Curve& curve) {
  fields("min", curve.min);
  fields("max", curve.max);
  fields("exponent", curve.exponent);
}

}  // namespace

OrderedJson dfr_json(const std::optional<Dfr>& dfr) {
  if (!dfr) return nullptr;
  FieldWriter fields;
  for (std::size_t i = 0; i < channel_names.size(); ++i) {
    FieldWriter curve;
    each_curve_value(curve, dfr->rgb[i]);
    fields.other(channel_names[i], curve.take());
  }
  fields("perturbation", dfr->perturbation);
  return fields.take();
}

Result<std::optional<Dfr>> dfr_from_json(const OrderedJson& json) {
  if (json.is_null()) return std::nullopt;
  FieldReader fields(json, "dfr");
  Dfr dfr;
  for (std::size_t i = 0; i < channel_names.size(); ++i) {
    const OrderedJson* channel = fields.take(channel_names[i]);
    if (!channel) break;
    FieldReader curve(*channel, channel_names[i]);
    each_curve_value(curve, dfr.rgb[i]);
    if (const std::string fault = curve.fault(); !fault.empty())
      fields.refuse(channel_names[i], fault);
  }
  fields("perturbation", dfr.perturbation);
  if (std::string fault = fields.fault(); !fault.empty())
    return unexpected(Error{"dfr", std::move(fault)});
  return dfr;
}

OrderedJson dfrs_json(const std::vector<std::optional<Dfr>>& dfrs) {
  OrderedJson list = OrderedJson::array();
  for (const std::optional<Dfr>& dfr : dfrs) list.push_back(dfr_json(dfr));
  return list;
}

Result<std::vector<std::optional<Dfr>>> dfrs_from_json(const OrderedJson& json) {
  if (!json.is_array()) return unexpected(Error{"dfrs", "dfrs are no list"});
  std::vector<std::optional<Dfr>> dfrs;
  for (const OrderedJson& one : json) {
    auto read = dfr_from_json(one);
    if (!read)
      return unexpected(
          Error{"dfrs", fmt::format("material {}: {}", dfrs.size() + 1, read.error().reason)});
    dfrs.push_back(*std::move(read));
  }
  return dfrs;
}

}  // namespace asos
