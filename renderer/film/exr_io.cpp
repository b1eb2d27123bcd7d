#include "renderer/film/cryptomatte.h"
#include "renderer/film/exr_header.h"
#include "renderer/film/exr_stream.h"
#include "renderer/film/image_io.h"
#include "renderer/film/image_text.h"
#include "renderer/film/picture_writer.h"
#include "renderer/film/reduced_exr.h"

#include <fmt/format.h>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

namespace asos {
namespace {

constexpr std::int64_t max_pixels = std::int64_t{1} << 29;
constexpr std::uint64_t most_exr_bytes = std::uint64_t{8} << 30;
constexpr std::uint64_t most_pixels_per_byte = 1100;
constexpr std::size_t longest_name = 255;

// OpenEXR reports errors by exceptions; none leaves this file.

class BytesStream : public Imf::IStream {
 public:
  explicit BytesStream(const FileBytes& bytes) : Imf::IStream("picture"), bytes_(bytes) {}
  bool read(char to[], int count) override {
    const auto size = static_cast<std::size_t>(count);
    if (size > bytes_.size() - at_) throw std::runtime_error("it ends too early");
    std::memcpy(to, bytes_.data() + at_, size);
    at_ += size;
    return at_ < bytes_.size();
  }
  std::uint64_t tellg() override { return at_; }
  void seekg(std::uint64_t at) override {
    if (at > bytes_.size()) throw std::runtime_error("it ends too early");
    at_ = at;
  }

 private:
  const FileBytes& bytes_;
  std::size_t at_ = 0;
};

/// Returns the slices of red, green and blue for rows from `first` on.
Imf::FrameBuffer slices(const glm::vec3* radiance, const Imath::V2i& first, std::int64_t width,
                        std::int64_t rows) {
  Imf::FrameBuffer buffer;
  for (int c = 0; c < 3; ++c) {
    const float* channel = &radiance->x + c;
    buffer.insert(std::string(1, "RGB"[c]),
                  Imf::Slice::Make(Imf::FLOAT, channel, first, width, rows, sizeof(glm::vec3),
                                   sizeof(glm::vec3) * static_cast<std::size_t>(width)));
  }
  return buffer;
}

Imf::Slice alpha_slice(const float* alpha, const Imath::V2i& first, std::int64_t width,
                       std::int64_t rows) {
  return Imf::Slice::Make(Imf::FLOAT, alpha, first, width, rows, sizeof(float),
                          sizeof(float) * static_cast<std::size_t>(width));
}

Imf::Header header_of(PictureSizePx size, const ImageText& attributes, Alpha alpha) {
  Imf::Header header(size.width, size.height);
  header.compression() = Imf::ZIP_COMPRESSION;
  set_chromaticities(header);
  for (const char* channel : {"R", "G", "B"})
    header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
  if (alpha == Alpha::coverage) header.channels().insert("A", Imf::Channel(Imf::FLOAT));
  for (const auto& [key, value] : attributes) header.insert(key, Imf::StringAttribute(value));
  return header;
}

class ExrWriter : public PictureWriter {
 public:
  ExrWriter(PartFile file, std::string path, PictureSizePx size, const ImageText& attributes,
            Alpha alpha)
      : file_(std::move(file)), path_(std::move(path)), size_(size), alpha_(alpha), stream_(file_) {
    output_.emplace(stream_, header_of(size, attributes, alpha), 0);
  }

  [[nodiscard]] Result<void> add_rows(std::span<const glm::vec3> radiance,
                                      std::span<const float> coverage,
                                      std::span<const glm::vec4> /*unlit*/) override {
    const int rows = static_cast<int>(radiance.size() / static_cast<std::size_t>(size_.width));
    if (rows == 0) return {};
    try {
      const Imath::V2i first(0, output_->currentScanLine());
      Imf::FrameBuffer buffer = slices(radiance.data(), first, size_.width, rows);
      std::vector<float> covered(coverage.begin(), coverage.end());
      if (alpha_ == Alpha::coverage) {
        covered.resize(radiance.size(), 1.0f);
        buffer.insert("A", alpha_slice(covered.data(), first, size_.width, rows));
      }
      output_->setFrameBuffer(buffer);
      output_->writePixels(rows);
    } catch (const std::exception& e) {
      return unexpected(Error{path_, fmt::format("could not be written: {}", e.what())});
    }
    return {};
  }
  [[nodiscard]] Result<void> finish() override {
    output_.reset();  // writes its table of rows
    return file_.commit();
  }

 private:
  PartFile file_;
  std::string path_;
  PictureSizePx size_;
  Alpha alpha_;
  PartStream stream_;
  std::optional<Imf::OutputFile> output_;
};

// OpenEXR's own attributes of a part, and those of ids, are no text of a picture.
bool is_text_key(std::string_view key) {
  return key != "type" && key != "name" && !is_cryptomatte_key(key);
}

ImageText attributes_of(const Imf::Header& header) {
  ImageText text;
  for (auto at = header.begin(); at != header.end(); ++at)
    if (const auto* value = dynamic_cast<const Imf::StringAttribute*>(&at.attribute());
        value && is_text_key(at.name()))
      text.emplace_back(at.name(), value->value());
  return text;
}

tl::unexpected<Error> unreadable(const std::string& path, std::string_view reason) {
  return unexpected(Error{path, fmt::format("is no EXR that can be read: {}", reason)});
}

// Leaves out the file name that OpenEXR's message contains.
tl::unexpected<Error> unreadable(const std::string& path, const std::exception& e) {
  const std::string_view what = e.what();
  const std::size_t head = what.find("\". ");
  return unreadable(path, head == std::string_view::npos ? what : what.substr(head + 3));
}

}  // namespace

Result<void> check_exr_attributes(const std::string& path, const ImageText& attributes) {
  for (const auto& [key, value] : attributes)
    if (key.empty() || key.size() > longest_name || key.find('\0') != std::string::npos)
      return unexpected(Error{path, "attribute \"" + key + "\" is not valid"});
  return {};
}

Result<std::unique_ptr<PictureWriter>> make_exr_writer(const std::string& path, PictureSizePx size,
                                                       const ImageText& attributes, Alpha alpha) {
  if (size.width <= 0 || size.height <= 0) return unexpected(Error{path, "the picture is empty"});
  if (auto valid = check_exr_attributes(path, attributes); !valid) return unexpected(valid.error());
  Result<PartFile> file = PartFile::create(path);
  if (!file) return unexpected(file.error());
  try {
    return std::make_unique<ExrWriter>(std::move(*file), path, size, attributes, alpha);
  } catch (const std::exception& e) {
    return unexpected(Error{path, fmt::format("could not be written: {}", e.what())});
  }
}

Result<ImageText> exr_text(const std::string& path, const FileBytes& file) {
  if (const std::string fault = exr_header_error(file); !fault.empty())
    return unreadable(path, fault);
  try {
    BytesStream stream(file);
    const Imf::InputFile input(stream, 0);
    ImageText text = attributes_of(input.header());
    std::size_t size = 0;
    for (const auto& [key, value] : text) size += key.size() + value.size();
    if (size > most_image_text)
      return unexpected(
          Error{path, fmt::format("holds more than {} MB of text", most_image_text >> 20)});
    return text;
  } catch (const std::exception& e) {
    return unreadable(path, e);
  }
}

namespace {

/// An EXR file that is open for reading.
class ExrInput {
 public:
  /// Reads the file. Errors: it cannot be read, or is no EXR.
  [[nodiscard]] static Result<FileBytes> bytes_of(const std::string& path) {
    const FileRules rules{most_exr_bytes, [](const FileHead& head) {
                            return is_exr(head.bytes) ? "" : "is no EXR that can be read";
                          }};
    auto file = read_file(path, rules);
    if (!file) return unexpected(Error{path, file.error()});
    if (const std::string fault = exr_header_error(*file); !fault.empty())
      return unreadable(path, fault);
    return *std::move(file);
  }

  /// Throws OpenEXR's exceptions.
  explicit ExrInput(const FileBytes& file) : bytes_(file), input_(bytes_, 0) {}

  [[nodiscard]] const Imf::Header& header() const { return input_.header(); }
  [[nodiscard]] Imath::V2i first() const { return header().dataWindow().min; }
  [[nodiscard]] std::int64_t width() const {
    const Imath::Box2i window = header().dataWindow();
    return std::int64_t{window.max.x} - window.min.x + 1;
  }
  [[nodiscard]] std::int64_t height() const {
    const Imath::Box2i window = header().dataWindow();
    return std::int64_t{window.max.y} - window.min.y + 1;
  }
  [[nodiscard]] bool has_alpha() const { return header().channels().findChannel("A") != nullptr; }

  /// Reads rows of the picture; `coverage` if it has alpha. Throws.
  void read(glm::vec3* radiance, float* coverage, std::int64_t y, std::int64_t rows) {
    const Imath::V2i at(first().x, first().y + static_cast<int>(y));
    Imf::FrameBuffer buffer = slices(radiance, at, width(), rows);
    if (has_alpha()) buffer.insert("A", alpha_slice(coverage, at, width(), rows));
    input_.setFrameBuffer(buffer);
    input_.readPixels(at.y, at.y + static_cast<int>(rows) - 1);
  }

 private:
  BytesStream bytes_;
  Imf::InputFile input_;
};

ExrReduction reduction_of(const ExrInput& input, std::uint64_t bytes, const MostPixels& most) {
  ExrReduction reduction{input.width(), input.height()};
  while (most &&
         most(bytes) < reduction.smaller(reduction.width) * reduction.smaller(reduction.height))
    reduction.shrink *= 2;
  return reduction;
}

/// Returns the mean of a square of pixels, as far as it lies inside the strip of rows.
template <typename Sum, typename Value>
Sum mean_of(const std::vector<Value>& strip, std::int64_t width, std::int64_t rows,
            std::int64_t left, int side) {
  const std::int64_t columns = std::min<std::int64_t>(side, width - left);
  Sum sum(0.0);
  for (std::int64_t i = 0; i < rows * columns; ++i)
    sum += Sum(strip[static_cast<std::size_t>(i / columns * width + left + i % columns)]);
  return sum / static_cast<double>(rows * columns);
}

/// Fills the film; if it is smaller than the file, one strip of the file's rows at a time. Throws.
void read_film(ExrInput& input, const ExrReduction& reduction, Film& film) {
  film = Film(static_cast<int>(reduction.smaller(reduction.width)),
              static_cast<int>(reduction.smaller(reduction.height)));
  if (input.has_alpha()) film.coverage.resize(film.radiance.size());
  if (reduction.shrink == 1)
    return input.read(film.radiance.data(), film.coverage.data(), 0, reduction.height);
  const auto pixels = static_cast<std::size_t>(reduction.width * reduction.shrink);
  std::vector<glm::vec3> radiance(pixels);
  std::vector<float> coverage(input.has_alpha() ? pixels : 0);
  for (int y = 0; y < film.height; ++y) {
    const std::int64_t top = std::int64_t{y} * reduction.shrink;
    const std::int64_t rows = std::min<std::int64_t>(reduction.shrink, reduction.height - top);
    input.read(radiance.data(), coverage.data(), top, rows);
    for (int x = 0; x < film.width; ++x) {
      const std::int64_t left = std::int64_t{x} * reduction.shrink;
      film.radiance[film.index(x, y)] =
          glm::vec3(mean_of<glm::dvec3>(radiance, reduction.width, rows, left, reduction.shrink));
      if (input.has_alpha())
        film.coverage[film.index(x, y)] = static_cast<float>(
            mean_of<double>(coverage, reduction.width, rows, left, reduction.shrink));
    }
  }
}

}  // namespace

Result<ExrReduction> exr_reduction(const std::string& path, const MostPixels& most) {
  const Result<FileBytes> file = ExrInput::bytes_of(path);
  if (!file) return unexpected(file.error());
  try {
    return reduction_of(ExrInput(*file), file->size(), most);
  } catch (const std::exception& e) {
    return unreadable(path, e);
  }
}

Result<ExrImage> read_exr(const std::string& path, const SizeCheck& check) {
  return read_reduced_exr(path, check, {});
}

Result<ExrImage> read_reduced_exr(const std::string& path, const SizeCheck& check,
                                  const MostPixels& most) {
  const Result<FileBytes> file = ExrInput::bytes_of(path);
  if (!file) return unexpected(file.error());
  try {
    ExrInput input(*file);
    for (const char* channel : {"R", "G", "B"})
      if (!input.header().channels().findChannel(channel))
        return unexpected(Error{path, "has no R, G and B channels"});
    const std::int64_t width = input.width(), height = input.height();
    if (width > max_pixels / height) return unexpected(Error{path, "the picture is too big"});
    if (check) {
      if (std::string unwanted = check(width, height); !unwanted.empty())
        return unexpected(Error{path, std::move(unwanted)});
    }
    // No compression packs more pixels into a byte. This is checked first, since memory for rows is
    // allocated before they are read.
    if (static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) >
        most_pixels_per_byte * file->size())
      return unreadable(path, "it ends too early");
    ExrImage read;
    read_film(input, reduction_of(input, file->size(), most), read.film);
    read.attributes = attributes_of(input.header());
    return read;
  } catch (const std::exception& e) {
    return unreadable(path, e);
  }
}

}  // namespace asos
