#include "renderer/gltf/images.h"

#include "renderer/gltf/pictures/picture.h"
#include "renderer/gltf/texture_budget.h"
#include "renderer/gltf/values.h"
#include "renderer/load_progress.h"
#include "renderer/tasks.h"
#include "renderer/work_counts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace asos::gltf {

namespace {

constexpr int unknown = -2;
constexpr int none = -1;
constexpr const char* basisu_advice =
    ". KHR_texture_basisu's KTX2 textures are not supported: convert them to PNG or WebP";
Wrap wrap_of(int value, bool& known) {
  if (value == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return Wrap::clamp_to_edge;
  if (value == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT) return Wrap::mirrored_repeat;
  if (value != TINYGLTF_TEXTURE_WRAP_REPEAT) known = false;
  return Wrap::repeat;
}

/// Returns read_picture, and counts its bytes.
PictureResult<Picture> decoded_picture(PictureBytes bytes, int shrink) {
  PictureResult<Picture> picture = read_picture(bytes, shrink);
  if (picture)
    WorkDone::add(Work::decoded_bytes, picture->image.rgba.size() + picture->image.low.size());
  return picture;
}

}  // namespace

Checked<ImageBytes> image_bytes(Document& document, Accessors& accessors, int index) {
  if (index < 0 || static_cast<std::size_t>(index) >= document.images.size())
    return fault("it does not exist");
  const ImageSource& source = document.images[static_cast<std::size_t>(index)];
  if (source.buffer_view >= 0) {
    const Checked<Bytes> bytes = accessors.view(source.buffer_view);
    if (!bytes) return fault(bytes.error());
    return ImageBytes{{}, *bytes, {}};
  }
  Checked<UriBytes> read = document.files.read(source.uri);
  if (!read) return fault(read.error());
  ImageBytes bytes{std::move(read->bytes), {}, std::move(read->remark)};
  bytes.bytes = bytes.read;
  return bytes;
}

Textures::Textures(Document& document, Accessors& accessors, Scene& scene)
    : doc_(document),
      accessors_(accessors),
      scene_(scene),
      texture_of_(document.model.textures.size(), unknown),
      image_of_(document.images.size(), unknown) {}

int Textures::use(int texture) {
  if (texture < 0) return none;
  if (noting_) return note(texture);
  if (static_cast<std::size_t>(texture) >= texture_of_.size()) {
    doc_.warnings.add(fmt::format("texture {} does not exist; left out", texture));
    return none;
  }
  int& known = texture_of_[static_cast<std::size_t>(texture)];
  if (known == unknown) known = load(texture);
  return known;
}

int Textures::load(int index) {
  const tinygltf::Texture& source = doc_.model.textures[static_cast<std::size_t>(index)];
  Texture texture;
  texture.name = source.name;
  texture.image = image_of(source, index);
  if (texture.image < 0) return none;
  if (source.sampler >= 0 &&
      static_cast<std::size_t>(source.sampler) >= doc_.model.samplers.size()) {
    doc_.warnings.add(
        fmt::format("texture {} has sampler {}, which does not exist", index, source.sampler));
  } else if (source.sampler >= 0) {
    const auto& sampler = doc_.model.samplers[static_cast<std::size_t>(source.sampler)];
    bool known = true;
    texture.wrap_u = wrap_of(sampler.wrapS, known);
    texture.wrap_v = wrap_of(sampler.wrapT, known);
    if (sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST) texture.filter = Filter::nearest;
    if (!known) doc_.warnings.add(fmt::format("sampler {} wraps unknown", source.sampler));
  }
  scene_.textures.push_back(std::move(texture));
  return static_cast<int>(scene_.textures.size()) - 1;
}

int Textures::image_of(const tinygltf::Texture& source, int index) {
  // The image of EXT_texture_webp comes first; `source` is for programs without the extension.
  if (const auto* e = extension(source.extensions, "EXT_texture_webp")) {
    if (const auto webp = whole(*e, "source"); webp && *webp >= 0) {
      const int image = use_image(*webp);
      if (image >= 0 || source.source < 0) return image;
      doc_.warnings.add(fmt::format("texture {} falls back to its PNG or JPEG image", index));
    }
  }
  if (source.source >= 0) return use_image(source.source);
  const bool basisu =
      std::find(doc_.unsupported_extensions.begin(), doc_.unsupported_extensions.end(),
                "KHR_texture_basisu") != doc_.unsupported_extensions.end();
  doc_.warnings.add(fmt::format("texture {} has no PNG, JPEG or WebP image; left out{}", index,
                                basisu ? basisu_advice : ""));
  return none;
}

int Textures::use_image(int index) {
  if (static_cast<std::size_t>(index) >= image_of_.size()) {
    doc_.warnings.add(fmt::format("image {} does not exist; its textures are left out", index));
    return none;
  }
  int& known = image_of_[static_cast<std::size_t>(index)];
  if (known != unknown) return known;
  known = none;
  const Checked<int> image = add_image(index);
  if (image) return known = *image;
  doc_.warnings.add(
      fmt::format("{}: {}; its textures are left out", name_of(index), image.error()));
  return none;
}

std::string Textures::name_of(int index) const {
  const ImageSource& source = doc_.images[static_cast<std::size_t>(index)];
  return fmt::format("image {} '{}'", index,
                     source.name.empty() ? shown_uri(source.uri) : source.name);
}

int Textures::image_named(int texture) const {
  if (texture < 0 || static_cast<std::size_t>(texture) >= texture_of_.size()) return none;
  const tinygltf::Texture& source = doc_.model.textures[static_cast<std::size_t>(texture)];
  const auto* e = extension(source.extensions, "EXT_texture_webp");
  return e ? whole(*e, "source").value_or(source.source) : source.source;
}

/// Leaves images out for now if the load allows that and they would delay the first picture. A
/// white texel stands for an image, so that the material's factor shows. Emissive images are
/// needed, since they decide on the lighting.
void Textures::leave_out_images() {
  constexpr std::uint64_t fewest_pixels = std::uint64_t{1} << 22;
  // Opening the geometry a second time takes about a fifth of decoding this number of pixels.
  constexpr std::uint64_t pixels_a_triangle = 400;
  constexpr std::uint32_t white = 0xffffffffu, straight = 0xffff8080u;  // as RGBA bytes
  LoadProgress* const progress = LoadProgress::current();
  const auto preview = progress && progress->may_miss_textures() ? progress->preview() : nullptr;
  if (!preview) return;
  std::map<int, std::uint32_t> later;
  for (const int index : noted_) later.emplace(index, white);
  for (const tinygltf::Material& m : doc_.model.materials) {
    // Its roughness is computed from texels.
    if (extension(m.extensions, "KHR_materials_pbrSpecularGlossiness")) return;
    if (const auto normal = later.find(image_named(m.normalTexture.index)); normal != later.end())
      normal->second = straight;
    later.erase(image_named(m.emissiveTexture.index));
  }
  std::erase_if(later, [&](const auto& image) {
    return pixels_[static_cast<std::size_t>(image.first)] == 0;
  });
  std::uint64_t pixels = 0;
  for (const auto& [index, texel] : later) pixels += pixels_[static_cast<std::size_t>(index)];
  if (pixels < fewest_pixels || pixels / pixels_a_triangle < preview->triangles) return;
  progress->note_missing_textures(later.size());
  later_ = std::move(later);
}

/// Returns the place of an image's bytes; empty if no other image can have the same.
Textures::ImagePlace Textures::place_of(const ImageSource& source) {
  if (source.buffer_view >= 0) {
    const Checked<Bytes> bytes = accessors_.view(source.buffer_view);
    return bytes ? ImagePlace{bytes->data(), bytes->size(), {}} : ImagePlace{};
  }
  const auto file = doc_.files.find(source.uri);
  return file ? ImagePlace{nullptr, 0, file->path.string()} : ImagePlace{};
}

/// Reads the heads of all images, and decides which ones to reduce so that they fit the budget.
void Textures::plan() {
  // Encoded bytes of files to keep; files beyond it are read a second time.
  constexpr std::size_t most_kept = std::size_t{1} << 28;
  std::size_t kept = 0;
  std::set<ImagePlace> seen;
  std::vector<DecodedImageSize> claims(doc_.images.size());
  pixels_.assign(claims.size(), 0);
  for (std::size_t i = 0; i < claims.size(); ++i) {
    const auto index = static_cast<int>(i);
    const ImagePlace place = place_of(doc_.images[i]);
    if (place != ImagePlace{} && !seen.insert(place).second) continue;
    Checked<ImageBytes> bytes = image_bytes(doc_, accessors_, index);
    if (!bytes) continue;  // the warning comes when the image is used
    const PictureResult<PictureHead> head = picture_head(bytes->bytes);
    if (!head) continue;
    claims[i] = {head->width, head->height, bytes->bytes.size()};
    pixels_[i] = head->pixels();
    all_bytes_ += bytes->bytes.size();
    if (bytes->read.empty() || kept + bytes->read.size() > most_kept) continue;
    kept += bytes->read.size();
    read_.emplace(index, std::move(*bytes));
  }
  shrinks_ = shrinks_of(claims);
}

int Textures::note(int texture) {
  if (static_cast<std::size_t>(texture) >= texture_of_.size()) return none;
  const int image = image_named(texture);
  if (image >= 0 && static_cast<std::size_t>(image) < image_of_.size()) noted_.insert(image);
  return texture;
}

/// Decodes the noted images, except those that would have to be read again or that together take
/// too much memory while they are decoded. These follow when they are used.
void Textures::decode_noted() {
  constexpr std::uint64_t most_held = std::uint64_t{1} << 28;
  if (noted_.empty()) return;
  plan();
  leave_out_images();
  struct Task {
    int index;
    ImageBytes bytes;
    PictureResult<Picture> picture;
  };
  std::vector<Task> tasks;
  std::set<ImagePlace> seen;
  std::uint64_t held = 0;
  for (const int index : noted_) {
    if (later_.contains(index)) continue;
    const ImageSource& source = doc_.images[static_cast<std::size_t>(index)];
    const ImagePlace place = place_of(source);
    if (place != ImagePlace{} && !seen.insert(place).second) continue;
    if (source.buffer_view < 0 && !read_.contains(index)) continue;
    Checked<ImageBytes> bytes = take_bytes(index);
    if (!bytes) continue;  // the warning comes when the image is used
    const PictureResult<PictureHead> head = picture_head(bytes->bytes);
    held += head ? head->held_bytes : 0;
    if (held > most_held) {
      if (source.buffer_view < 0) read_.emplace(index, *std::move(bytes));
      break;
    }
    tasks.push_back({index, *std::move(bytes), {}});
  }
  in_tasks(tasks.size(), [&, progress = LoadProgress::current()](std::size_t i) {
    const LoadProgress::Scope scope(progress);
    Task& task = tasks[i];
    task.picture =
        decoded_picture(task.bytes.bytes, shrinks_[static_cast<std::size_t>(task.index)]);
    task.bytes.read = {};
    if (progress) progress->note_decoded_texture();
  });
  for (Task& task : tasks)
    decoded_.emplace(task.index,
                     DecodedImage{std::move(task.bytes.remark), std::move(task.picture)});
}

Checked<Textures::DecodedImage> Textures::take_decoded(int index) {
  if (const auto later = later_.find(index); later != later_.end()) {
    Image texel;
    texel.width = texel.height = 1;
    for (int c = 0; c < 4; ++c)
      texel.rgba.own().push_back(static_cast<std::uint8_t>(later->second >> (8 * c)));
    return DecodedImage{{}, Picture{std::move(texel), {}}};
  }
  auto known = decoded_.extract(index);
  if (!known.empty()) return std::move(known.mapped());
  Checked<ImageBytes> bytes = take_bytes(index);
  if (!bytes) return fault(bytes.error());
  return DecodedImage{std::move(bytes->remark),
                      decoded_picture(bytes->bytes, shrinks_[static_cast<std::size_t>(index)])};
}

Checked<ImageBytes> Textures::take_bytes(int index) {
  auto known = read_.extract(index);
  if (!known.empty()) return std::move(known.mapped());
  return image_bytes(doc_, accessors_, index);
}

Checked<int> Textures::add_image(int index) {
  if (shrinks_.empty()) plan();
  const ImageSource& source = doc_.images[static_cast<std::size_t>(index)];
  ImagePlace place = place_of(source);
  const bool shareable = place != ImagePlace{};
  if (const auto known = image_at_.find(place); shareable && known != image_at_.end())
    return known->second;
  const int shrink = shrinks_[static_cast<std::size_t>(index)];
  Checked<DecodedImage> decoded = take_decoded(index);
  if (!decoded) return fault(decoded.error());
  if (!decoded->remark.empty())
    doc_.warnings.add(fmt::format("{}: {}", name_of(index), decoded->remark));
  PictureResult<Picture>& picture = decoded->picture;
  if (!picture) return fault(picture.error());
  Image& image = picture->image;
  if (!picture->remark.empty())
    doc_.warnings.add(fmt::format("{}: {}", name_of(index), picture->remark));
  if (shrink > 1)
    doc_.warnings.add(
        fmt::format("{}: the textures are more than a file of this size has use for; it is shown "
                    "with {} x {} pixels",
                    name_of(index), image.width, image.height));
  image.name = source.name;
  const auto made = static_cast<int>(scene_.images.size());
  scene_.images.push_back(std::move(image));
  if (shareable) image_at_.emplace(std::move(place), made);
  return made;
}

int Textures::roughness_of(int texture, float factor) {
  constexpr std::size_t most_factors = 4;
  if (noting_) return texture;
  Texture rough = scene_.textures[static_cast<std::size_t>(texture)];
  auto& made = roughness_of_[rough.image];
  auto found = std::find_if(made.begin(), made.end(),
                            [factor](const auto& known) { return known.first == factor; });
  if (found == made.end()) {
    if (made.size() == most_factors) {
      doc_.warnings.add(
          fmt::format("texture '{}' is used with more than {} factors of glossiness; the rest go "
                      "by the factor alone",
                      rough.name, most_factors));
      return none;
    }
    const std::uint64_t texels =
        scene_.images[static_cast<std::size_t>(rough.image)].rgba.size() / 4;
    if (copied_texels_ + texels > most_texels(all_bytes_) / 2) {
      doc_.warnings.add(fmt::format(
          "the roughness of texture '{}' would be more than a file of this size has use "
          "for; its factor alone is used",
          rough.name));
      return none;
    }
    Image image = scene_.images[static_cast<std::size_t>(rough.image)];
    copied_texels_ += texels;
    image.low = {};  // 8 bits are enough for glossiness
    SharedBytes::Bytes& rgba = image.rgba.own();
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
      const float glossiness = factor * static_cast<float>(rgba[i + 3]);
      rgba[i + 1] = static_cast<std::uint8_t>(std::lround(255.0f - glossiness));
      rgba[i] = rgba[i + 2] = rgba[i + 3] = 255;
    }
    found = made.insert(made.end(), {factor, static_cast<int>(scene_.images.size())});
    scene_.images.push_back(std::move(image));
  }
  rough.image = found->second;
  scene_.textures.push_back(std::move(rough));
  return static_cast<int>(scene_.textures.size()) - 1;
}

}  // namespace asos::gltf
