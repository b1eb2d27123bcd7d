#include "renderer/gltf/pictures/formats.h"
#include "renderer/gltf/pictures/row_means.h"

#include <fmt/format.h>

#include <algorithm>
#include <csetjmp>
#include <cstddef>
#include <cstdio>  // jpeglib.h needs it
#include <jerror.h>
#include <jpeglib.h>
#include <memory>
#include <utility>
#include <vector>

namespace asos {
namespace jpeg {
namespace {

// Progressive pictures have about ten scans. Each passes over the whole picture, even with few
// bytes, so thousands of them would take hours.
constexpr int most_scans = 200;

/// libjpeg's error handler, which returns by a jump.
struct Errors {
  jpeg_error_mgr base;
  std::jmp_buf back;
  char message[JMSG_LENGTH_MAX];
  char damage[JMSG_LENGTH_MAX];  ///< the first damage of the data; empty: none
};

Errors& errors_of(j_common_ptr info) {
  return *reinterpret_cast<Errors*>(info->err);
}

[[noreturn]] void leave(j_common_ptr info) {
  Errors& errors = errors_of(info);
  errors.base.format_message(info, errors.message);
  std::longjmp(errors.back, 1);
}

void note(j_common_ptr info, int level) {
  Errors& errors = errors_of(info);
  // Other warnings have no effect, such as bytes between the parts.
  const int code = errors.base.msg_code;
  const bool damaged = level < 0 && (code == JWRN_HIT_MARKER || code == JWRN_HUFF_BAD_CODE ||
                                     code == JWRN_JPEG_EOF || code == JWRN_MUST_RESYNC ||
                                     code == JWRN_BOGUS_PROGRESSION);
  if (damaged && errors.damage[0] == '\0') errors.base.format_message(info, errors.damage);
}

void say_nothing(j_common_ptr) {}

void end_endless_scans(j_common_ptr info) {
  if (!info->is_decompressor) return;
  if (reinterpret_cast<j_decompress_ptr>(info)->input_scan_number > most_scans) {
    std::snprintf(errors_of(info).message, JMSG_LENGTH_MAX, "more than %d scans", most_scans);
    std::longjmp(errors_of(info).back, 1);
  }
}

/// Converts a row of CMYK inks to colours, in place. Adobe stores them inverted.
void make_rgba(std::span<std::uint8_t> row, bool inverted) {
  for (std::size_t i = 0; i < row.size(); i += 4) {
    const auto ink = [&](std::size_t c) {
      return static_cast<unsigned>(inverted ? row[i + c] : 255 - row[i + c]);
    };
    const unsigned black = ink(3);
    for (std::size_t c = 0; c < 3; ++c)
      row[i + c] = static_cast<std::uint8_t>((ink(c) * black + 127) / 255);
    row[i + 3] = 255;
  }
}

/// Decodes one picture. Functions that call libjpeg have no objects with destructors, because of
/// its jumps.
class Decoder {
 public:
  Decoder() {
    info_.err = jpeg_std_error(&errors_.base);
    errors_.base.error_exit = leave;
    errors_.base.emit_message = note;
    errors_.base.output_message = say_nothing;
    progress_.progress_monitor = end_endless_scans;
  }
  ~Decoder() {
    if (made_) jpeg_destroy_decompress(&info_);
  }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;

  [[nodiscard]] bool read_head(PictureBytes bytes) {
    if (setjmp(errors_.back) != 0) return false;
    jpeg_create_decompress(&info_);
    made_ = true;
    info_.progress = &progress_;
    jpeg_mem_src(&info_, bytes.data(), static_cast<unsigned long>(bytes.size()));
    jpeg_read_header(&info_, TRUE);
    return true;
  }

  /// Returns the bytes of coefficients that are in memory until the last scan; 0 if rows are
  /// decoded one by one.
  [[nodiscard]] std::uint64_t held_bytes() {
    if (jpeg_has_multiple_scans(&info_) == FALSE) return 0;
    std::uint64_t blocks = 0;
    for (int i = 0; i < info_.num_components; ++i)
      blocks += std::uint64_t{info_.comp_info[i].width_in_blocks} *
                std::uint64_t{info_.comp_info[i].height_in_blocks};
    return blocks * DCTSIZE2 * sizeof(JCOEF);
  }

  /// Starts decoding. The decoder itself can reduce up to 8 x 8 pixels to one.
  [[nodiscard]] bool start(int shrink) {
    if (setjmp(errors_.back) != 0) return false;
    const bool inks = info_.jpeg_color_space == JCS_CMYK || info_.jpeg_color_space == JCS_YCCK;
    info_.out_color_space = inks ? JCS_CMYK : JCS_EXT_RGBA;
    info_.scale_num = 1;
    info_.scale_denom = static_cast<unsigned>(std::min(shrink, 8));
    jpeg_start_decompress(&info_);
    return true;
  }

  /// Reads a row. Returns false if it failed; then `rows_left` returns whether any were left.
  [[nodiscard]] bool read_row(std::uint8_t* row) {
    if (setjmp(errors_.back) != 0) return false;
    return jpeg_read_scanlines(&info_, &row, 1) == 1;
  }

  [[nodiscard]] bool rows_left() const { return info_.output_scanline < info_.output_height; }
  [[nodiscard]] bool has_inks() const { return info_.out_color_space == JCS_CMYK; }
  [[nodiscard]] bool inks_inverted() const { return info_.saw_Adobe_marker != FALSE; }
  [[nodiscard]] int width() const { return static_cast<int>(info_.image_width); }
  [[nodiscard]] int height() const { return static_cast<int>(info_.image_height); }
  [[nodiscard]] int output_width() const { return static_cast<int>(info_.output_width); }
  [[nodiscard]] int output_height() const { return static_cast<int>(info_.output_height); }
  [[nodiscard]] const char* message() const { return errors_.message; }
  [[nodiscard]] const char* damage() const { return errors_.damage; }

 private:
  Errors errors_{};
  jpeg_decompress_struct info_{};
  jpeg_progress_mgr progress_{};
  bool made_ = false;
};

}  // namespace
}  // namespace jpeg

bool is_jpeg(PictureBytes bytes) {
  return bytes.size() >= 3 && bytes[0] == 0xff && bytes[1] == 0xd8 && bytes[2] == 0xff;
}

PictureResult<PictureHead> jpeg_head(PictureBytes bytes) {
  const auto decoder = std::make_unique<jpeg::Decoder>();
  if (!decoder->read_head(bytes))
    return tl::unexpected(fmt::format("it is no usable JPEG ({})", decoder->message()));
  return PictureHead{decoder->width(), decoder->height(), decoder->held_bytes()};
}

PictureResult<Picture> read_jpeg_picture(PictureBytes bytes, const PictureHead& head, int shrink) {
  const auto decoder = std::make_unique<jpeg::Decoder>();
  const auto broken = [&] {
    return tl::unexpected(fmt::format("it cannot be decoded ({})", decoder->message()));
  };
  if (!decoder->read_head(bytes) || !decoder->start(shrink)) return broken();
  RowMeans rows(decoder->output_width(), decoder->output_height(), std::max(1, shrink / 8));
  while (decoder->rows_left()) {
    const std::span<std::uint8_t> row = rows.next();
    if (!decoder->read_row(row.data())) return broken();
    if (decoder->has_inks()) jpeg::make_rgba(row, decoder->inks_inverted());
    rows.add();
  }
  Picture picture{rows.take(), {}};
  if (decoder->damage()[0] != '\0')
    picture.remark = fmt::format("its data is damaged ({}); it is shown as far as it can be read",
                                 decoder->damage());
  if (picture.image.width != shrunk(head.width, shrink) ||
      picture.image.height != shrunk(head.height, shrink))
    return tl::unexpected<std::string>("it has another size than its head says");
  return picture;
}

}  // namespace asos
