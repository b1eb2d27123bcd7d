#pragma once

#include "renderer/film/image_io.h"
#include "renderer/film/part_file.h"

#include <ImfChromaticitiesAttribute.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfStandardAttributes.h>
#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace asos {

/// Stream by which OpenEXR writes a PartFile. Throws, as OpenEXR expects.
class PartStream : public Imf::OStream {
 public:
  explicit PartStream(const PartFile& file) : Imf::OStream("picture"), file_(file) {}
  void write(const char bytes[], int count) override {
    const auto size = static_cast<std::size_t>(count);
    if (std::fwrite(bytes, 1, size, file_.stream()) != size)
      throw std::runtime_error(file_.write_error().reason);
  }
  std::uint64_t tellp() override { return static_cast<std::uint64_t>(std::ftell(file_.stream())); }
  void seekp(std::uint64_t at) override {
    if (std::fseek(file_.stream(), static_cast<long>(at), SEEK_SET) != 0)
      throw std::runtime_error(file_.write_error().reason);
  }

 private:
  const PartFile& file_;
};

/// Returns an error for a key that is no attribute name.
[[nodiscard]] Result<void> check_exr_attributes(const std::string& path,
                                                const ImageText& attributes);

/// Colours are those of sRGB and Rec. 709, whose chromaticities are OpenEXR's default.
inline void set_chromaticities(Imf::Header& header) {
  Imf::addChromaticities(header, Imf::Chromaticities());
}

}  // namespace asos
