#include "renderer/film/cryptomatte.h"
#include "renderer/film/exr_stream.h"
#include "renderer/film/image_io.h"
#include "renderer/film/picture_writer.h"

#include <fmt/format.h>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfMatrixAttribute.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfRationalAttribute.h>
#include <ImfStringAttribute.h>
#include <algorithm>
#include <exception>
#include <list>
#include <vector>

namespace asos {
namespace {

/// A channel of the file: every `step`th float from `first` on.
struct Channel {
  std::string name;
  const float* first = nullptr;
  std::size_t step = 1;
  bool colour = false;  ///< may be compressed with loss
};

/// The channels of a film's layers. Owns the values that the film does not store as floats.
class Channels {
 public:
  Channels(const Film& film, const ExrOptions& options) : film_(film) {
    add_beauty();
    for (const Layer layer : options.layers.layers()) add(layer, options);
  }
  [[nodiscard]] const std::vector<Channel>& all() const { return channels_; }
  /// The attributes of ids.
  [[nodiscard]] const ImageText& attributes() const { return attributes_; }

 private:
  void add_beauty() {
    for (int c = 0; c < 3; ++c)
      channels_.push_back({std::string(1, "RGB"[c]), &film_.radiance.data()->x + c, 3, true});
    if (!film_.coverage.empty()) channels_.push_back({"A", film_.coverage.data(), 1, true});
  }

  void add(Layer layer, const ExrOptions& options) {
    switch (layer) {
      case Layer::beauty:
        return;
      case Layer::level:
        return add_values(layer, [&](std::size_t i) { return film_.split_level[i]; });
      case Layer::cause:
        return add_values(layer, [&](std::size_t i) { return static_cast<int>(film_.cause[i]); });
      case Layer::rays:
        return add_values(layer, [&](std::size_t i) { return film_.rays[i]; });
      case Layer::time:
        return add_values(layer, [&](std::size_t i) { return film_.seconds[i]; });
      default:
        break;
    }
    const LayerPlane* plane = find_plane(film_.layers, layer);
    if (!plane) return;
    if (layer == Layer::object) {
      add_ids("CryptoObject", "object", *plane, options.object_names);
      if (!options.asset_names.empty())
        add_ids("CryptoAsset", "asset", *plane, options.asset_names);
      return;
    }
    if (layer == Layer::material)
      return add_ids("CryptoMaterial", "material", *plane, options.material_names);
    add_plane(layer, plane->values.data());
  }

  void add_plane(Layer layer, const float* values) {
    const LayerRow& row = row_of(layer);
    const std::size_t count = row.channel_count();
    for (std::size_t c = 0; c < count; ++c)
      channels_.push_back({fmt::format("{}.{}", row.name, row.channels[c]), values + c, count,
                           row.channels[c] == "RGB"[c]});
  }

  template <typename F>
  void add_values(Layer layer, const F& value) {
    std::vector<float>& values = own_.emplace_back();
    for (std::size_t i = 0; i < film_.radiance.size(); ++i)
      values.push_back(static_cast<float>(value(i)));
    add_plane(layer, values.data());
  }

  void add_ids(const char* name, const char* kind, const LayerPlane& plane,
               const std::vector<std::string>& names) {
    Cryptomatte& made = mattes_.emplace_back(cryptomatte(name, kind, plane.ids, names));
    for (std::size_t i = 0; i < made.channels.size(); ++i)
      channels_.push_back({made.channel_name(i), made.channels[i].data(), 1, false});
    attributes_.insert(attributes_.end(), made.attributes.begin(), made.attributes.end());
  }

  const Film& film_;
  std::vector<Channel> channels_;
  ImageText attributes_;
  std::list<std::vector<float>> own_;
  std::list<Cryptomatte> mattes_;
};

Imath::M44f exr_matrix(const glm::dmat4& matrix) {
  // OpenEXR multiplies row vectors: its rows are our columns.
  Imath::M44f made;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) made[i][j] = static_cast<float>(matrix[i][j]);
  return made;
}

Imath::V2i first_pixel(const ExrOptions& options) {
  return options.window ? Imath::V2i(options.window->x, options.window->y) : Imath::V2i(0, 0);
}

Imf::Header header_in_window(const Film& film, const ExrOptions& options) {
  if (!options.window) return {film.width, film.height};
  const ExrWindow& whole = *options.window;
  const Imath::V2i first = first_pixel(options);
  const Imath::V2i last = first + Imath::V2i(film.width - 1, film.height - 1);
  return {Imath::Box2i({0, 0}, {whole.width - 1, whole.height - 1}), Imath::Box2i(first, last)};
}

Imf::Header common_header(const Film& film, const ExrOptions& options) {
  Imf::Header header = header_in_window(film, options);
  header.compression() = Imf::ZIP_COMPRESSION;
  set_chromaticities(header);
  if (options.world_to_camera) Imf::addWorldToCamera(header, exr_matrix(*options.world_to_camera));
  if (options.world_to_ndc) Imf::addWorldToNDC(header, exr_matrix(*options.world_to_ndc));
  if (options.frames_a_second)
    Imf::addFramesPerSecond(header, Imf::Rational(*options.frames_a_second));
  return header;
}

/// A part of the file.
struct ExrPart {
  Imf::Header header;
  Imf::FrameBuffer buffer;
};

void add_channel(const Film& film, const Channel& channel, Imath::V2i first, ExrPart& part) {
  part.header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
  part.buffer.insert(channel.name, Imf::Slice::Make(Imf::FLOAT, channel.first, first, film.width,
                                                    film.height, channel.step * sizeof(float),
                                                    channel.step * sizeof(float) *
                                                        static_cast<std::size_t>(film.width)));
}

// Only colours are compressed with loss, which would corrupt ids and depths.
std::vector<ExrPart> parts_of(const Film& film, const Channels& channels, const ImageText& text,
                              const ExrOptions& options) {
  const bool lossy = options.compression == ExrCompression::dwaa;
  std::vector<ExrPart> parts(1, {common_header(film, options), {}});
  if (lossy) parts[0].header.compression() = Imf::DWAA_COMPRESSION;
  const bool all_colours = std::all_of(channels.all().begin(), channels.all().end(),
                                       [](const Channel& channel) { return channel.colour; });
  if (lossy && !all_colours) {
    parts.push_back({common_header(film, options), {}});
    parts[0].header.setName("colour");
    parts[1].header.setName("data");
    for (ExrPart& part : parts) part.header.setType(Imf::SCANLINEIMAGE);
  }
  for (const Channel& channel : channels.all())
    add_channel(film, channel, first_pixel(options), channel.colour ? parts.front() : parts.back());
  for (const auto& [key, value] : text)
    parts.front().header.insert(key, Imf::StringAttribute(value));
  for (const auto& [key, value] : channels.attributes())
    parts.back().header.insert(key, Imf::StringAttribute(value));
  return parts;
}

void write_parts(PartStream& stream, const std::vector<ExrPart>& parts, int rows) {
  if (parts.size() == 1) {
    Imf::OutputFile output(stream, parts[0].header, 0);
    output.setFrameBuffer(parts[0].buffer);
    output.writePixels(rows);
    return;
  }
  std::vector<Imf::Header> headers;
  for (const ExrPart& part : parts) headers.push_back(part.header);
  Imf::MultiPartOutputFile output(stream, headers.data(), static_cast<int>(headers.size()), false,
                                  0);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Imf::OutputPart part(output, static_cast<int>(i));
    part.setFrameBuffer(parts[i].buffer);
    part.writePixels(rows);
  }
}

}  // namespace

Result<void> write_exr(const std::string& path, const Film& film, const ImageText& attributes,
                       const ExrOptions& options) {
  if (film.width <= 0 || film.height <= 0) return unexpected(Error{path, "the picture is empty"});
  if (auto valid = check_exr_attributes(path, attributes); !valid) return valid;
  Result<PartFile> file = PartFile::create(path);
  if (!file) return unexpected(file.error());
  try {
    const Channels channels(film, options);
    const std::vector<ExrPart> parts = parts_of(film, channels, attributes, options);
    PartStream stream(*file);
    write_parts(stream, parts, film.height);
  } catch (const std::exception& e) {
    return unexpected(Error{path, fmt::format("could not be written: {}", e.what())});
  }
  return file->commit();
}

}  // namespace asos
