#include "renderer/film/hdr_io.h"

#include "renderer/files/read_file.h"

#include <fmt/format.h>
#include <tl/expected.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace asos {
namespace hdr {
namespace {

// Enough for 2^26 pixels, and a little more for rows that do not compress.
constexpr std::uint64_t most_bytes = std::uint64_t{300} << 20;
constexpr std::size_t longest_header = std::size_t{1} << 16;
constexpr std::int64_t longest_side = 1 << 20;
// This number of pixels is accepted from files of any size, at any compression ratio.
constexpr std::size_t free_pixels = std::size_t{1} << 25;
// Range of row widths that support run-length encoded channels (Ward, "Real Pixels", and Radiance's
// color.c).
constexpr std::size_t narrowest_packed = 8, widest_packed = 0x7fff;

using Bytes = std::span<const std::uint8_t>;
template <typename T>
using Checked = tl::expected<T, std::string>;

tl::unexpected<std::string> fault(std::string reason) {
  return tl::unexpected<std::string>(std::move(reason));
}

std::string fault_of_head(const FileHead& head) {
  const bool known = begins_with(head.bytes, "#?RADIANCE") || begins_with(head.bytes, "#?RGBE");
  return known ? "" : "is not a Radiance picture";
}

/// Removes the next line of the header from `rest` and returns it.
std::optional<std::string_view> take_line(std::string_view& rest) {
  const std::size_t end = rest.substr(0, longest_header).find('\n');
  if (end == std::string_view::npos) return std::nullopt;
  const std::string_view line = rest.substr(0, end);
  rest.remove_prefix(end + 1);
  return line;
}

std::optional<std::int64_t> take_number(std::string_view& text) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{}) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

bool take(std::string_view& text, std::string_view word) {
  if (!text.starts_with(word)) return false;
  text.remove_prefix(word.size());
  return true;
}

/// Reads a finite number above 0, with blanks before it.
std::optional<double> take_factor(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t+"), text.size()));
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || !std::isfinite(value) || value <= 0.0) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

/// Returns the factors that an EXPOSURE or COLORCORR line declares for the pixels (several lines
/// multiply); 1 for other lines, none if its numbers are invalid (Radiance's filefmts.pdf).
std::optional<glm::dvec3> factors_of(std::string_view line) {
  const bool of_all = take(line, "EXPOSURE=");
  if (!of_all && !take(line, "COLORCORR=")) return glm::dvec3(1.0);
  glm::dvec3 factors(1.0);
  for (int c = 0; c < (of_all ? 1 : 3); ++c) {
    const std::optional<double> factor = take_factor(line);
    if (!factor) return std::nullopt;
    factors[c] = *factor;
  }
  if (line.find_first_not_of(" \t\r") != std::string_view::npos) return std::nullopt;
  return of_all ? glm::dvec3(factors.x) : factors;
}

struct Header {
  std::int64_t width = 0;
  std::int64_t height = 0;
  glm::vec3 scale{1.0f};
  Bytes pixels;
};

Checked<Header> read_header(Bytes file) {
  std::string_view rest(reinterpret_cast<const char*>(file.data()), file.size());
  std::optional<std::string_view> line = take_line(rest);
  glm::dvec3 multiplied(1.0);
  for (; line && !line->empty(); line = take_line(rest)) {
    const std::optional<glm::dvec3> factors = factors_of(*line);
    if (!factors)
      return fault(fmt::format("its line '{}' has no usable number", line->substr(0, 80)));
    multiplied *= *factors;
    if (line->starts_with("FORMAT=") && *line != "FORMAT=32-bit_rle_rgbe")
      return fault(
          fmt::format("has the format '{}'; only 32-bit_rle_rgbe is read", line->substr(7)));
  }
  if (line) line = take_line(rest);
  if (!line) return fault("its header cannot be read");
  std::optional<std::int64_t> height, width;
  std::string_view size = *line;
  if (take(size, "-Y ")) height = take_number(size);
  if (height && take(size, " +X ")) width = take_number(size);
  if (!width || !size.empty())
    return fault(
        fmt::format("its size '{}' is none that is read, such as '-Y 512 +X 1024'", *line));
  if (*width < 1 || *height < 1 || *width > longest_side || *height > longest_side)
    return fault(
        fmt::format("has {} x {} pixels; a side has 1 to {}", *width, *height, longest_side));
  const glm::vec3 scale(1.0 / multiplied);
  for (int c = 0; c < 3; ++c)
    if (!std::isnormal(scale[c]))
      return fault("its EXPOSURE and COLORCORR multiply to what no number holds");
  return Header{*width, *height, scale, file.last(rest.size())};
}

/// Unpacks rows one after the other. Every step consumes bytes, so it terminates.
class Rows {
 public:
  explicit Rows(Bytes bytes) : bytes_(bytes) {}

  /// Fills one row; false if there are too few bytes.
  [[nodiscard]] bool next(std::span<Rgbe> row) {
    if (row.size() < narrowest_packed || row.size() > widest_packed || !is_packed(row.size()))
      return flat(row);
    bytes_ = bytes_.subspan(4);
    for (std::size_t channel = 0; channel < 4; ++channel)
      if (!packed(row, channel)) return false;
    return true;
  }

 private:
  [[nodiscard]] bool is_packed(std::size_t width) const {
    return bytes_.size() >= 4 && bytes_[0] == 2 && bytes_[1] == 2 &&
           (std::size_t{bytes_[2]} << 8 | bytes_[3]) == width;
  }

  [[nodiscard]] bool packed(std::span<Rgbe> row, std::size_t channel) {
    std::size_t at = 0;
    while (at < row.size()) {
      if (bytes_.size() < 2) return false;
      const bool repeats = bytes_[0] > 128;
      const std::size_t count = repeats ? bytes_[0] - 128u : bytes_[0];
      const std::size_t taken = repeats ? 2 : 1 + count;
      if (count == 0 || count > row.size() - at || taken > bytes_.size()) return false;
      for (std::size_t i = 0; i < count; ++i) row[at + i][channel] = bytes_[repeats ? 1 : 1 + i];
      at += count;
      bytes_ = bytes_.subspan(taken);
    }
    return true;
  }

  /// Reads uncompressed pixels, with the old run-length code: 1, 1, 1, n repeats the previous pixel
  /// n times, and the next such code 256 n times.
  [[nodiscard]] bool flat(std::span<Rgbe> row) {
    std::size_t at = 0;
    unsigned shift = 0;
    while (at < row.size()) {
      if (bytes_.size() < 4) return false;
      const Rgbe pixel{bytes_[0], bytes_[1], bytes_[2], bytes_[3]};
      bytes_ = bytes_.subspan(4);
      if (at == 0 || pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
        row[at++] = pixel;
        shift = 0;
        continue;
      }
      const std::size_t count = shift < 24 ? std::size_t{pixel[3]} << shift : row.size() + 1;
      if (count > row.size() - at) return false;
      std::fill_n(row.begin() + static_cast<std::ptrdiff_t>(at), count, row[at - 1]);
      at += count;
      shift += 8;
    }
    return true;
  }

  Bytes bytes_;
};

Checked<HdrImage> read(Bytes file, const SizeCheck& check) {
  const Checked<Header> header = read_header(file);
  if (!header) return fault(header.error());
  if (check) {
    if (std::string unwanted = check(header->width, header->height); !unwanted.empty())
      return fault(std::move(unwanted));
  }
  // A run of two bytes covers at most 127 values, but an old code of 4 bytes covers any number of
  // pixels.
  constexpr std::int64_t least_bytes_a_row = 4;
  if (header->height > static_cast<std::int64_t>(header->pixels.size()) / least_bytes_a_row)
    return fault("its picture cannot be read: it ends too early");
  HdrImage image;
  image.width = static_cast<int>(header->width);
  image.height = static_cast<int>(header->height);
  image.scale = header->scale;
  const auto width = static_cast<std::size_t>(header->width);
  const std::size_t pixels = width * static_cast<std::size_t>(header->height);
  if (pixels > std::max(free_pixels, file.size()))
    return fault(
        fmt::format("has {} x {} pixels in {} bytes; where there are more than {}, each "
                    "takes a byte at least",
                    header->width, header->height, file.size(), free_pixels));
  Rows rows(header->pixels);
  image.pixels.resize(pixels);
  for (std::int64_t y = 0; y < header->height; ++y) {
    const auto row = std::span(image.pixels).subspan(static_cast<std::size_t>(y) * width, width);
    if (!rows.next(row))
      return fault(fmt::format("its picture cannot be read: row {} is damaged or missing", y));
  }
  return image;
}

}  // namespace
}  // namespace hdr

Result<HdrImage> read_hdr(const std::string& path, const SizeCheck& check) {
  const auto file = read_file(path, {hdr::most_bytes, hdr::fault_of_head});
  if (!file) return unexpected(Error{path, file.error()});
  return hdr::read(*file, check).map_error([&](std::string reason) {
    return Error{path, std::move(reason)};
  });
}

}  // namespace asos
