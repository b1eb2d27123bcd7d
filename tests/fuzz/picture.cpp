#include "renderer/picture/picture_description.h"
#include "tests/fuzz/harness.h"
#include "tests/fuzz/json_mutator.h"
#include "tests/support/temporary_folder.h"

#include <array>
#include <utility>

// Any picture's text is either a description that survives writing and reading, or is rejected with
// an error.

namespace asos::fuzz {
namespace {

constexpr std::array<const char*, 24> words{
    "builtin:boxes", "neutral",  "all",          "scene",       "perspective", "orthographic",
    "asos",          "sobol",    "null",         "lights",      "camera",      "settings",
    "sky",           "dfrs",     "display",      "origin",      "type",        "point light",
    "file",          "turn_deg", "scene_number", "environment", "dusk",        "brightness"};

/// The picture with mutations of its description; empty if it has none.
std::string with_other_description(const std::uint8_t* data, std::size_t size, unsigned seed) {
  const std::string path = input_file("from", data, size);
  Result<ImageText> text = read_image_text(path);
  if (!text) return "";
  for (auto& [key, value] : *text) {
    if (key != PictureDescription::key) continue;
    Json json = Json::parse(value, nullptr, false);
    std::mt19937 random(seed);
    if (!json.is_discarded()) mutate(json, words, random);
    value = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  const bool png = size > 0 && data[0] == 0x89;
  const Result<void> written = png ? write_png(path, RgbImage{1, 1, {1, 2, 3}, std::move(*text)})
                                   : write_exr(path, Film(1, 1), *text);
  return written ? test::content_of(path) : "";
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string path = input_file("picture", data, size);
  const auto description = read_description(path);
  if (description) {
    const std::string text = description_text(*description);
    const auto again = parse_description(text, path);
    require(again.has_value(),
            again ? "" : "a description can be read back: " + again.error().reason);
    require(description_text(*again) == text, "it comes back as it was");
  } else {
    require(description.error().subject == path && !description.error().reason.empty(),
            "the error names the file");
  }
  // The window also reads the pixels.
  if (size > 0 && data[0] == 0x89) {
    const auto picture = read_png(path);
    require(
        !picture || picture->rgb.size() ==
                        std::size_t{3} * static_cast<std::size_t>(picture->width * picture->height),
        "a picture has all of its pixels");
  }
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most_bytes, unsigned int seed) {
  const std::string made = seed % 3 == 0 ? "" : with_other_description(data, size, seed);
  return mutated(made, data, size, most_bytes);
}

}  // namespace asos::fuzz
