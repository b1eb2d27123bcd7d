#include "renderer/picture/picture_description.h"

#include "renderer/gltf/load.h"
#include "renderer/picture/settings_json.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <limits>
#include <utility>

namespace asos {
namespace {

using nlohmann::ordered_json;

/// Settings in which every member differs from its default.
RenderSettings odd_settings() {
  RenderSettings s;
  // A new member breaks the compilation of this line: write it, read it, and set it below.
  const auto& [width, height, crop, method, filter_width, line_width, judged_tone, asos, sampling,
               texture, shadow, mirror, shutter, sky, background, ground, layers, cull, seed,
               threads] = s;
  const auto& [kind, top, bottom, coverage] = background;
  const auto& [max_level, eps, leaf, rule, detect, fat, refine_shading, jitter] = asos;
  const auto& [spp, contrast, depth, spheres, contrast_scale] = sampling;
  const auto& [filter, resolution] = texture;
  const auto& [cast, sky_shadows, light_bounces, quality, divisions, light_rule] = shadow;
  const auto& [bounces, roughest, dfr, curved, widest_angle_deg] = mirror;
  const auto& [seconds, followed] = shutter;
  (void)threads, (void)seconds, (void)followed, (void)jitter, (void)contrast_scale,
      (void)resolution, (void)light_rule;
  (void)widest_angle_deg, (void)kind, (void)top, (void)bottom;
  (void)coverage, (void)layers;  // exists only while a picture is rendered
  s.width = 321;
  s.height = 123;
  s.crop = {3, 5, 100, 50};
  s.method = Method::asos_published;
  s.asos.max_level = 5;
  s.asos.eps = 0.1 + 1e-17 + 1.0 / 3.0;
  s.asos.leaf = LeafKind::point;
  s.asos.rule = StoppingRule::published;
  s.asos.detect = Detection::cone;
  s.asos.fat = 4;
  s.asos.refine_shading = false;
  s.filter_width = 1.0 + 1.0 / 3.0;
  s.line_width = 2.5;
  s.judged_tone = ToneCurve::agx;
  s.layers = {Layer::depth, Layer::object};
  s.asos.jitter = true;
  s.sampling.spp = 25;
  s.sampling.contrast = 1.0 / 7.0;
  s.sampling.depth = 2;
  s.sampling.spheres = true;
  s.sampling.contrast_scale = 0.3;
  s.texture.filter = TextureFilter::point;
  s.texture.resolution = 4;
  s.shadow.cast = false;
  s.shadow.sky = true;
  s.shadow.bounces = 1;
  s.shadow.quality = ShadowQuality::extended_divided;
  s.shadow.divisions = 7;
  s.shadow.light_rule = LightRule::published;
  s.mirror.bounces = 9;
  s.mirror.roughest = 0.7;
  s.mirror.dfr =
      Dfr{{DfrCurve{0.1, 0.9, 31.5}, DfrCurve{0.2, 0.8, 3}, DfrCurve{0.3, 0.7, 2}}, 0.25};
  s.mirror.curved = CurvedMirror::adaptive;
  s.mirror.widest_angle_deg = 11.25;
  s.shutter = {1.0 / 3.0, 2};
  s.background = {BackgroundKind::colours, {0.1f, 0.2f, 1.0f / 3.0f}, {3.0f, 0.0f, 0.7f}};
  s.ground = Ground::mirror;
  s.cull = false;
  s.seed = 77;
  return s;
}

std::vector<Light> odd_lights() {
  std::vector<Light> lights(2);
  lights[0].name = "lämp \"1\"";
  lights[0].type = Light::Type::polygon;
  lights[0].color = {0.1f, 0.2f, 0.3f};
  lights[0].intensity = 12.7f;
  lights[0].position = {0.1, 1e-9, -1e6};
  lights[0].direction = {0, -1, 0};
  lights[0].outlines = {{{0, 0, 0}, {1.0 / 3.0, 0, 0}, {0, 0, 1}}, {{0.1, 0, 0.1}}};
  lights[0].two_sided = true;
  lights[1].type = Light::Type::spot;
  lights[1].range = 12.5;
  lights[1].inner_cone_rad = 0.1;
  lights[1].outer_cone_rad = 0.2;
  lights[1].radius = 0.3;
  lights[1].angular_diameter_rad = 0.4;
  lights[1].half_u = {1, 2, 3};
  lights[1].half_v = {4, 5, 6};
  lights[1].casts_shadows = false;
  lights[1].own_part = 3;
  return lights;
}

PictureDescription odd_description() {
  PictureDescription d;
  d.scene = "/some where/ä.glb";
  d.variant = "Dusk \"\u2744\"";
  d.scene_number = 3;
  d.origin = {1e7, 0.1, -3};
  d.camera.name = "c";
  const double a = 0.7;
  d.camera.world_from_camera = {{std::cos(a), 0, -std::sin(a), 0},
                                {0, 1, 0, 0},
                                {std::sin(a), 0, std::cos(a), 0},
                                {0.1, 0.2, 1.0 / 3.0, 1}};
  d.camera.fov_y_rad = 0.61;
  d.camera.near_depth = 0.3;
  d.camera.far_depth = 1e3;
  d.camera.lens = {0.1 + 1.0 / 3.0, 1.0 / 7.0, 5, -0.3};
  d.settings = odd_settings();
  d.sky.file = "/skies/one.hdr";
  d.sky.turn_deg = 45.1;
  d.sky.brightness = 1.0 / 3.0;
  d.render_features = FeatureChoice::all;
  d.lights = odd_lights();
  d.dfrs = MaterialDfrs{std::nullopt, Dfr{{DfrCurve{0.1, 0.9, 31.5}, {}, {}}, 1.0 / 3.0}};
  d.time = ClipTime{3, 1.0 / 3.0};
  d.display = {-1.3f, true, SplitMapColours::cause, 0.4f};
  return d;
}

TEST(PictureDescription, ComesBackBitForBit) {
  const PictureDescription d = odd_description();
  const std::string text = description_text(d);
  EXPECT_EQ(text.find('\n'), std::string::npos);
  const auto read = parse_description(text, "a.png");
  ASSERT_TRUE(read.has_value()) << read.error().message();
  EXPECT_EQ(read->scene, d.scene);
  EXPECT_EQ(read->time, d.time);
  EXPECT_EQ(read->variant, d.variant);
  EXPECT_EQ(read->scene_number, 3);
  EXPECT_EQ(read->origin, d.origin);
  EXPECT_EQ(read->settings, d.settings);
  EXPECT_EQ(read->sky, d.sky);
  EXPECT_EQ(read->render_features, d.render_features);
  EXPECT_EQ(read->display, d.display);
  EXPECT_EQ(read->camera.world_from_camera, d.camera.world_from_camera);
  EXPECT_EQ(read->camera.near_depth, d.camera.near_depth);
  EXPECT_EQ(read->camera.far_depth, d.camera.far_depth);
  EXPECT_EQ(read->camera.lens, d.camera.lens);
  ASSERT_TRUE(read->lights.has_value());
  ASSERT_EQ(read->lights->size(), 2u);
  EXPECT_EQ((*read->lights)[0].outlines, (*d.lights)[0].outlines);
  EXPECT_EQ((*read->lights)[0].range, std::numeric_limits<double>::infinity());
  EXPECT_EQ((*read->lights)[1].own_part, 3);
  EXPECT_EQ(read->dfrs, d.dfrs);
  EXPECT_EQ(description_text(*read), text) << "nothing else was lost either";
}

TEST(PictureDescription, NoSettingIsAsByDefaultInTheTestAbove) {
  const ordered_json odd = settings_json(odd_settings()), plain = settings_json({});
  for (const auto& [key, value] : plain.items()) {
    if (key == "sky") continue;  // tested below
    EXPECT_NE(odd.at(key), value) << key;
  }
}

TEST(PictureDescription, SkiesAreNeutralColoursFilesOrEnvironments) {
  SkyChoice dusk, turned, bright{{}, "/a b.exr", 1.5, 1000.0};
  dusk.environment = Environment::dusk;
  turned.environment = Environment::softboxes;
  turned.turn_deg = -30.5;
  turned.brightness = 0.25;
  for (const SkyChoice& sky :
       {SkyChoice{}, SkyChoice{SkyChoice::Colours{{0.1f, 2, 3}, {0, 0, 0}}, "", 0.0},
        SkyChoice{{}, "/a b.exr", -12.5}, dusk, turned, bright}) {
    const auto read = settings_from_json(settings_json({}, sky));
    ASSERT_TRUE(read.has_value()) << read.error().message();
    EXPECT_EQ(read->sky, sky);
  }
}

TEST(PictureDescription, MovesWithTheOrigin) {
  const PictureDescription d = odd_description();
  EXPECT_EQ(d.camera_from(d.origin).world_from_camera, d.camera.world_from_camera);
  EXPECT_EQ(glm::dvec3(d.camera_from({0, 0, 0}).world_from_camera[3]),
            glm::dvec3(d.camera.world_from_camera[3]) + d.origin);
  EXPECT_EQ(d.lights_from({0, 0, 0})[0].outlines[1][0], glm::dvec3(0.1, 0, 0.1) + d.origin);
}

struct Damage {
  const char* pointer;
  ordered_json value;  // discarded: the value is removed
  const char* reason;
};

TEST(PictureDescription, WhatIsMalformedIsRefusedByFileAndReason) {
  const ordered_json whole = ordered_json::parse(description_text(odd_description()));
  const ordered_json gone(ordered_json::value_t::discarded);
  for (const Damage& damage : {
           Damage{"/format", 2, "newer version"},
           Damage{"/format", 0, "no format 0"},
           Damage{"/format", gone, "no \"format\""},
           Damage{"/more", 1, "knows no \"more\""},
           Damage{"/scene", 7, "\"scene\" is no text"},
           Damage{"/needs", "some", "\"needs\""},
           Damage{"/settings/eps", gone, "no \"eps\""},
           Damage{"/settings/eps", "small", "\"eps\" is no finite number"},
           Damage{"/settings/eps", 2.0, "eps: 2 is not from 0 to 1"},
           Damage{"/settings/eps", nullptr, "\"eps\""},
           Damage{"/settings/width", 1e12, "\"width\""},
           Damage{"/settings/width", 0, "width: 0"},
           Damage{"/settings/max_level", 2.5, "\"max_level\" is no whole number"},
           Damage{"/settings/method", "magic", "\"method\""},
           Damage{"/settings/jitter", 1, "\"jitter\" is neither"},
           Damage{"/settings/crop", {0, 0, 4000, 10}, "crop"},
           Damage{"/settings/crop", {0, 0}, "\"crop\""},
           Damage{"/settings/dfr/green/max", 3, "dfr"},
           Damage{"/settings/dfr/green", gone, "no \"green\""},
           Damage{"/settings/sky", {{"file", 3}}, "\"file\""},
           Damage{"/settings/sky", "blue", "sky"},
           Damage{"/settings/filter", 2, "knows no \"filter\""},
           Damage{"/settings/shutter_seconds", -1, "shutter: -1 is not from 0 to 3600"},
           Damage{"/settings/shutter_seconds", "long", "\"shutter_seconds\""},
           Damage{"/settings/shutter_camera", -2, "shutter camera: -2"},
           Damage{"/camera/eye", {0, 1}, "\"eye\" is no list of 3 numbers"},
           Damage{"/camera/right", {0, 0, 0}, "orthonormal"},
           Damage{"/camera/fov_y_rad", 4, "between 0 and pi"},
           Damage{"/camera/near_depth", -1, "below 0"},
           Damage{"/camera/far_depth", 0.2, "not beyond"},
           Damage{"/camera/lens/radius", -1, "radius"},
           Damage{"/camera/lens/focus", 0, "focus"},
           Damage{"/camera/lens/blades", 2, "blades"},
           Damage{"/camera/lens/turn_rad", 9, "turn_rad"},
           Damage{"/camera/lens", 3, "lens is no object"},
           Damage{"/camera/type", "orthographic", "perspective"},
           Damage{"/lights", 3, "lights are no list"},
           Damage{"/lights/1/range", "far", "light 2: \"range\""},
           Damage{"/lights/0/outlines/0/1", {1, 2}, "outlines"},
           Damage{"/dfrs", "rough", "dfrs are no list"},
           Damage{"/dfrs", gone, "no \"dfrs\""},
           Damage{"/dfrs/1/blue", gone, "material 2: dfr has no \"blue\""},
           Damage{"/dfrs/1/red/max", "wide", "material 2"},
           Damage{"/display/exposure_ev", 1e300, "\"exposure_ev\""},
           Damage{"/display", gone, "no \"display\""},
       }) {
    ordered_json damaged = whole;
    const ordered_json::json_pointer at(damage.pointer);
    if (damage.value.is_discarded()) {
      damaged[at.parent_pointer()].erase(at.back());
    } else {
      damaged[at] = damage.value;
    }
    const auto read = parse_description(damaged.dump(), "shot.png");
    ASSERT_FALSE(read.has_value()) << damage.pointer;
    EXPECT_EQ(read.error().subject, "shot.png");
    EXPECT_NE(read.error().reason.find(damage.reason), std::string::npos)
        << damage.pointer << ": " << read.error().reason;
  }
}

TEST(PictureDescription, IsNeverReadInPart) {
  const std::string text = description_text(odd_description());
  for (std::size_t length = 0; length < text.size(); length += 13)
    EXPECT_FALSE(parse_description(text.substr(0, length), "a").has_value()) << length;
  EXPECT_FALSE(parse_description("[]", "a").has_value());
  EXPECT_FALSE(parse_description(std::string(100000, '['), "a").has_value());
}

// Pictures contain the edits made in the window.
TEST(PictureDescription, EditedBlurComesBackWithItsScene) {
  const Scene scene = load_scene("builtin:solids").value();
  const auto original = prepare(scene).value();
  EXPECT_FALSE(describe(*original, {}, {}, {}).dfrs.has_value()) << "nothing was edited";
  MaterialDfrs dfrs = dfrs_of(original->world());
  dfrs.back() =
      Dfr{{DfrCurve{0.2, 0.7, 9.0}, DfrCurve{0.2, 0.7, 9.0}, DfrCurve{0.2, 0.7, 9.0}}, 0.0};
  const auto edited = with_dfrs(original, dfrs).value();
  const auto read =
      parse_description(description_text(describe(*edited, {}, {}, {})), "a.png").value();
  EXPECT_EQ(read.dfrs, dfrs);
  EXPECT_EQ((*prepare(scene, read))->dfrs(), dfrs);

  // A scene that differs from the picture's is reported, not partly edited.
  const auto other = prepare(load_scene("builtin:boxes").value(), read);
  ASSERT_FALSE(other.has_value());
  EXPECT_NE(other.error().reason.find("is not the scene that the picture was made of"),
            std::string::npos);
}

TEST(PictureDescription, FilesThatSayNothingAreNamed) {
  const test::TemporaryFolder folder;
  const std::string plain = folder.file("plain.png"), exr = folder.file("plain.exr");
  const RgbImage image{1, 1, {1, 2, 3}, {{"Comment", "x"}}};
  ASSERT_TRUE(write_png(plain, image));
  ASSERT_TRUE(write_exr(exr, Film(2, 2), {}));
  for (const std::string& file : {plain, exr}) {
    const auto read = read_description(file);
    ASSERT_FALSE(read.has_value());
    EXPECT_EQ(read.error().subject, file);
    EXPECT_NE(read.error().reason.find("holds no settings"), std::string::npos);
  }
  for (const std::string& file :
       {folder.file("missing.png"), folder.write("text.png", "no picture at all")}) {
    const auto read = read_description(file);
    ASSERT_FALSE(read.has_value());
    EXPECT_EQ(read.error().subject, file);
  }
}

TEST(PictureDescription, ATimeIsToldOnlyOfWhatMoves) {
  PictureDescription d = odd_description();
  d.time.reset();
  EXPECT_EQ(description_text(d).find("animation"), std::string::npos);
  EXPECT_FALSE(parse_description(description_text(d), "a.png")->time.has_value());
  d.time = ClipTime{0, 2.0};
  for (const auto& [key, value] : {std::pair<std::string, ordered_json>{"number", -1},
                                   {"number", 1.5},
                                   {"seconds", -0.5},
                                   {"seconds", "soon"},
                                   {"other", 1}}) {
    ordered_json json = ordered_json::parse(description_text(d));
    json["animation"][key] = value;
    const auto read = parse_description(json.dump(), "a.png");
    ASSERT_FALSE(read) << key;
    EXPECT_NE(read.error().message().find("animation"), std::string::npos);
  }
}

}  // namespace
}  // namespace asos
