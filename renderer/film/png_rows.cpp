#include "renderer/film/png_rows.h"

#include <algorithm>
#include <csetjmp>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace asos {
namespace {

bool is_plain_ascii(std::string_view text) {
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return c == '\n' || (c >= 32 && c < 127); });
}

bool is_valid_key(const std::string& key) {
  return !key.empty() && key.size() <= 79 && is_plain_ascii(key) &&
         key.find('\n') == std::string::npos && key.front() != ' ' && key.back() != ' ';
}

/// Returns libpng's structures for the text; they point into `text`.
Result<std::vector<png_text_struct>> as_chunks(const std::string& path, const ImageText& text) {
  std::vector<png_text_struct> chunks;
  for (const auto& [key, value] : text) {
    if (!is_valid_key(key)) return unexpected(Error{path, "text key \"" + key + "\" is not valid"});
    if (value.find('\0') != std::string::npos)
      return unexpected(Error{path, "the text of \"" + key + "\" holds a zero byte"});
    png_text_struct chunk{};
    const bool plain = is_plain_ascii(value);
    chunk.compression = plain ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
    chunk.key = const_cast<char*>(key.c_str());
    chunk.text = const_cast<char*>(value.c_str());
    (plain ? chunk.text_length : chunk.itxt_length) = value.size();
    chunks.push_back(chunk);
  }
  return chunks;
}

void keep_message(png_structp png, png_const_charp message) {
  *static_cast<std::string*>(png_get_error_ptr(png)) = message;
  png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

/// Runs a function that calls libpng, whose errors jump out of it: `f` must hold no objects with
/// destructors. Returns false if it failed.
template <typename F>
bool guarded(png_structp png, const F& f) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  f();
  return true;
}

}  // namespace

PngRows::PngRows(PartFile file, std::string path, std::size_t row_bytes)
    : file_(std::move(file)), path_(std::move(path)), row_bytes_(row_bytes) {}

Result<std::unique_ptr<PngRows>> PngRows::create(const std::string& path, int width, int height,
                                                 const ImageText& text, int channels) {
  if (width <= 0 || height <= 0) return unexpected(Error{path, "the picture is empty"});
  const auto chunks = as_chunks(path, text);
  if (!chunks) return unexpected(chunks.error());
  Result<PartFile> file = PartFile::create(path);
  if (!file) return unexpected(file.error());
  std::unique_ptr<PngRows> rows(
      new PngRows(std::move(*file), path,
                  static_cast<std::size_t>(width) * static_cast<std::size_t>(channels)));
  rows->png_ =
      png_create_write_struct(PNG_LIBPNG_VER_STRING, &rows->message_, keep_message, ignore_warning);
  if (rows->png_) rows->info_ = png_create_info_struct(rows->png_);
  if (!rows->info_) return unexpected(Error{path, "the picture could not be encoded"});
  const png_structp png = rows->png_;
  const png_infop info = rows->info_;
  std::FILE* const stream = rows->file_.stream();
  const png_text_struct* const first = chunks->data();
  const int kind = channels == 4 ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB;
  const int count = static_cast<int>(chunks->size());
  const bool begun = guarded(png, [&] {
    png_init_io(png, stream);
    png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), 8,
                 kind, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_text(png, info, first, count);
    png_write_info(png, info);
  });
  if (!begun) return unexpected(rows->failure());
  return rows;
}

PngRows::~PngRows() {
  if (png_) png_destroy_write_struct(&png_, info_ ? &info_ : nullptr);
}

Error PngRows::failure() const {
  if (std::ferror(file_.stream()) != 0) return file_.write_error();
  return {path_, "the picture could not be encoded (" + message_ + ")"};
}

Result<void> PngRows::add_rows(std::span<const std::uint8_t> pixels) {
  const std::size_t row = row_bytes_;
  const std::uint8_t* const end = pixels.data() + pixels.size() / row * row;
  const bool written = guarded(png_, [&] {
    for (const std::uint8_t* at = pixels.data(); at != end; at += row) png_write_row(png_, at);
  });
  return written ? Result<void>{} : unexpected(failure());
}

Result<void> PngRows::finish() {
  if (!guarded(png_, [&] { png_write_end(png_, nullptr); })) return unexpected(failure());
  return file_.commit();
}

}  // namespace asos
