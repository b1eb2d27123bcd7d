#include "renderer/gltf/export/gltf_writer.h"

#include <fmt/format.h>

// stb_image_write is private to this file, so that it does not conflict with other copies of the
// library.
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb/stb_image_write.h>

namespace asos::exporting {

using nlohmann::json;

namespace {

int gl_wrap(Wrap wrap) {
  switch (wrap) {
    case Wrap::clamp_to_edge:
      return 33071;
    case Wrap::mirrored_repeat:
      return 33648;
    case Wrap::repeat:
      break;
  }
  return 10497;
}

void append_bytes(void* context, void* data, int size) {
  auto& bytes = *static_cast<std::vector<std::uint8_t>*>(context);
  const auto* first = static_cast<const std::uint8_t*>(data);
  bytes.insert(bytes.end(), first, first + size);
}

}  // namespace

Result<int> write_image(const Image& image, bool alpha, const std::string& path,
                        GltfDocument& document) {
  const int channels = alpha ? 4 : 3;
  std::vector<std::uint8_t> opaque;
  if (!alpha) {
    for (std::size_t i = 0; i < image.rgba.size(); ++i)
      if (i % 4 != 3) opaque.push_back(image.rgba.data()[i]);
  }
  const std::uint8_t* bytes = alpha ? image.rgba.data() : opaque.data();
  std::vector<std::uint8_t> png;
  if (stbi_write_png_to_func(append_bytes, &png, image.width, image.height, channels, bytes,
                             channels * image.width) == 0) {
    return unexpected(Error{path, fmt::format("image '{}' cannot be encoded as PNG", image.name)});
  }
  json out{{"bufferView", document.add_view(png, 0)}, {"mimeType", "image/png"}};
  if (!image.name.empty()) out["name"] = image.name;
  return document.add("images", std::move(out));
}

Result<void> write_images(const Scene& scene, const std::string& path, GltfDocument& document) {
  for (const Image& image : scene.images) {
    if (const Result<int> written = write_image(image, true, path, document); !written)
      return unexpected(written.error());
  }
  for (const Texture& texture : scene.textures) {
    const int filter = texture.filter == Filter::nearest ? 9728 : 9729;
    const int sampler = document.add("samplers", {{"magFilter", filter},
                                                  {"wrapS", gl_wrap(texture.wrap_u)},
                                                  {"wrapT", gl_wrap(texture.wrap_v)}});
    json out{{"sampler", sampler}, {"source", texture.image}};
    if (!texture.name.empty()) out["name"] = texture.name;
    document.add("textures", std::move(out));
  }
  return {};
}

}  // namespace asos::exporting
