#include "renderer/film/cryptomatte.h"
#include "renderer/film/image_io.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <ImfChannelList.h>
#include <ImfChromaticitiesAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <cmath>
#include <string>
#include <vector>

namespace asos {
namespace {

/// A film of 3 x 2 pixels with all layers and distinct values.
Film film_with_layers() {
  Film film(3, 2);
  float next = 0.25f;
  for (glm::vec3& pixel : film.radiance) pixel = {next, next + 0.5f, next + 1.0f}, next += 1.0f;
  film.layers = blank_planes(LayerSet::all(), film.radiance.size());
  for (LayerPlane& plane : film.layers) {
    for (float& value : plane.values) value = next += 1.0f;
    for (std::size_t i = 0; i < plane.ids.size(); ++i)
      plane.ids[i] = {{static_cast<std::uint32_t>(i % 2), 0.75f}, {no_id, 0.25f}};
  }
  for (std::size_t i = 0; i < film.rays.size(); ++i) film.rays[i] = 7.0f + static_cast<float>(i);
  film.split_level[4] = 3;
  film.cause[4] = SplitCause::outline;
  return film;
}

ExrOptions all_layers(ExrCompression compression) {
  ExrOptions options;
  options.compression = compression;
  options.layers = LayerSet::all();
  options.object_names = {"left", "right"};
  options.asset_names = {"both", "both"};
  options.material_names = {"red"};
  options.frames_a_second = 24.0;
  glm::dmat4 matrix(1.0);
  matrix[3] = {1.0, 2.0, 3.0, 1.0};
  options.world_to_camera = options.world_to_ndc = matrix;
  return options;
}

std::vector<float> channel_of(const std::string& path, const std::string& name) {
  Imf::MultiPartInputFile file(path.c_str());
  for (int i = 0; i < file.parts(); ++i) {
    if (!file.header(i).channels().findChannel(name)) continue;
    Imf::InputPart part(file, i);
    std::vector<float> values(6);
    Imf::FrameBuffer buffer;
    buffer.insert(name, Imf::Slice::Make(Imf::FLOAT, values.data(), Imath::V2i(0, 0), 3, 2));
    part.setFrameBuffer(buffer);
    part.readPixels(0, 1);
    return values;
  }
  return {};
}

std::vector<float> plane_values(const Film& film, Layer layer, std::size_t channel) {
  std::vector<float> values;
  for (std::size_t i = 0; i < 6; ++i)
    values.push_back(find_plane(film.layers, layer)->at(i)[channel]);
  return values;
}

TEST(LayerExr, ChannelsHaveTheNamesOthersRead) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("layers.exr");
  const Film film = film_with_layers();
  ASSERT_TRUE(write_exr(path, film, {{"key", "value"}}, all_layers(ExrCompression::zip)));
  EXPECT_EQ(channel_of(path, "G")[1], 1.75f);
  EXPECT_EQ(channel_of(path, "alpha.A"), plane_values(film, Layer::alpha, 0));
  EXPECT_EQ(channel_of(path, "depth.Z"), plane_values(film, Layer::depth, 0));
  EXPECT_EQ(channel_of(path, "normal.Y"), plane_values(film, Layer::normal, 1));
  EXPECT_EQ(channel_of(path, "geometric_normal.X"), plane_values(film, Layer::geometric_normal, 0));
  EXPECT_EQ(channel_of(path, "albedo.B"), plane_values(film, Layer::albedo, 2));
  EXPECT_EQ(channel_of(path, "uv.V"), plane_values(film, Layer::uv, 1));
  EXPECT_EQ(channel_of(path, "rays.V"), film.rays);
  EXPECT_EQ(channel_of(path, "level.V")[4], 3.0f);
  EXPECT_EQ(channel_of(path, "cause.V")[4], static_cast<float>(SplitCause::outline));
  EXPECT_EQ(channel_of(path, "CryptoObject00.R")[1], cryptomatte_id("right"));
  EXPECT_EQ(channel_of(path, "CryptoObject00.G")[1], 0.75f);
  EXPECT_EQ(channel_of(path, "CryptoMaterial00.R")[1], cryptomatte_id("material 2"));
  for (const std::size_t pixel : {0u, 1u}) {
    EXPECT_EQ(channel_of(path, "CryptoAsset00.R")[pixel], cryptomatte_id("both"));
    EXPECT_EQ(channel_of(path, "CryptoAsset00.G")[pixel], 0.75f);
  }
}

TEST(LayerExr, HeaderTellsColoursCameraAndRate) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("layers.exr");
  ASSERT_TRUE(write_exr(path, film_with_layers(), {}, all_layers(ExrCompression::zip)));
  const Imf::MultiPartInputFile file(path.c_str());
  ASSERT_EQ(file.parts(), 1);
  const Imf::Header& header = file.header(0);
  ASSERT_TRUE(Imf::hasChromaticities(header));
  EXPECT_NEAR(Imf::chromaticities(header).red.x, 0.64f, 1e-6f);
  EXPECT_NEAR(Imf::chromaticities(header).white.y, 0.329f, 1e-6f);
  EXPECT_EQ(Imf::framesPerSecond(header).n, 24);
  const Imath::V3f moved = Imath::V3f(0.5f, 0.0f, 0.0f) * Imf::worldToCamera(header);
  EXPECT_EQ(moved, Imath::V3f(1.5f, 2.0f, 3.0f)) << "rows are vectors";
  const auto* name = header.findTypedAttribute<Imf::StringAttribute>("cryptomatte/3ae39a5/name");
  ASSERT_TRUE(name);
  EXPECT_EQ(name->value(), "CryptoObject");
}

// A part of a picture keeps its place: the data window lies within the display window.
TEST(LayerExr, PartKeepsItsPlaceInThePicture) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("part.exr");
  const Film film = film_with_layers();
  for (const ExrCompression compression : {ExrCompression::zip, ExrCompression::dwaa}) {
    ExrOptions options = all_layers(compression);
    options.window = {40, 30, 21, 12};
    ASSERT_TRUE(write_exr(path, film, {}, options));
    {
      const Imf::MultiPartInputFile file(path.c_str());
      for (int part = 0; part < file.parts(); ++part) {
        EXPECT_EQ(file.header(part).displayWindow(), Imath::Box2i({0, 0}, {39, 29}));
        EXPECT_EQ(file.header(part).dataWindow(), Imath::Box2i({21, 12}, {23, 13}));
      }
    }
    const auto read = read_exr(path);
    ASSERT_TRUE(read) << read.error().message();
    EXPECT_EQ(read->film.width, 3);
    EXPECT_EQ(read->film.height, 2);
    if (compression == ExrCompression::zip) {
      EXPECT_EQ(read->film.radiance, film.radiance);
    }
  }
}

// DWAA, which is lossy, would change ids and depths.
TEST(LayerExr, DwaaLosesOnlyColours) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("lossy.exr");
  const Film film = film_with_layers();
  ASSERT_TRUE(write_exr(path, film, {{"key", "value"}}, all_layers(ExrCompression::dwaa)));
  {
    const Imf::MultiPartInputFile file(path.c_str());
    ASSERT_EQ(file.parts(), 2);
    EXPECT_EQ(file.header(0).compression(), Imf::DWAA_COMPRESSION);
    EXPECT_EQ(file.header(1).compression(), Imf::ZIP_COMPRESSION);
    EXPECT_TRUE(file.header(0).channels().findChannel("albedo.R"));
  }
  EXPECT_EQ(channel_of(path, "normal.Y"), plane_values(film, Layer::normal, 1));
  EXPECT_EQ(channel_of(path, "CryptoObject00.R")[1], cryptomatte_id("right"));
  const auto read = read_exr(path);
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_NEAR(read->film.radiance[5].x, film.radiance[5].x, 0.1f);
  EXPECT_EQ(read->attributes, (ImageText{{"key", "value"}}));
}

// A Cryptomatte manifest is not returned as a text, of any length.
TEST(LayerExr, ReadsBackAsAnyPicture) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("layers.exr");
  const Film film = film_with_layers();
  ASSERT_TRUE(write_exr(path, film, {{"key", "value"}}, all_layers(ExrCompression::zip)));
  const auto read = read_exr(path);
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->film.radiance, film.radiance);
  EXPECT_TRUE(read->film.coverage.empty()) << "the picture has a background";
  EXPECT_EQ(*read_image_text(path), (ImageText{{"key", "value"}}));
}

TEST(LayerExr, BrokenFilesAreErrors) {
  const test::TemporaryFolder folder;
  for (const ExrCompression compression : {ExrCompression::zip, ExrCompression::dwaa}) {
    const std::string whole = folder.file("whole.exr");
    ASSERT_TRUE(write_exr(whole, film_with_layers(), {}, all_layers(compression)));
    const std::string bytes = test::content_of(whole);
    for (std::size_t size = 8; size < bytes.size(); size += bytes.size() / 40) {
      const std::string path = folder.write("cut.exr", bytes.substr(0, size));
      const auto read = read_exr(path);
      if (read) continue;  // OpenEXR reads what comes before the cut
      EXPECT_EQ(read.error().subject, path);
      EXPECT_FALSE(read.error().reason.empty());
    }
    ASSERT_FALSE(read_exr(folder.write("cut.exr", bytes.substr(0, bytes.size() / 4))));
  }
}

}  // namespace
}  // namespace asos
