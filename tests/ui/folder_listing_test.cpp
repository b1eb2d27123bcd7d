#include "ui/folder_listing.h"

#include "tests/support/temporary_folder.h"
#include "ui/panels/file_browser.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace asos {
using namespace ui;
namespace {

namespace fs = std::filesystem;

class FolderListingTest : public testing::Test {
 protected:
  FolderListingTest() {
    for (const char* name : {"wheel10.glb", "wheel2.GLTF", "Box.glb", "notes.txt", ".hidden.glb"})
      folder.write(name, "0123456789");
    fs::create_directories(folder.path() / "models" / "Fox");
    fs::create_directories(folder.path() / "models" / "Hat");
    folder.write("models/Fox/Fox.glb", "x");
    folder.write("models/Hat/Hat.gltf", "x");
  }
  [[nodiscard]] std::vector<std::string> names(const std::string& filter = "") const {
    const FolderListing listing = FolderListing::of(folder.path());
    std::vector<std::string> names;
    for (const std::size_t i : listing.matching(filter)) names.push_back(listing.entries[i].name);
    return names;
  }
  using Names = std::vector<std::string>;
  test::TemporaryFolder folder;
};

TEST_F(FolderListingTest, ShowsWhatCanBeOpened) {
  EXPECT_EQ(names(), (Names{"models", "Box.glb", "wheel2.GLTF", "wheel10.glb"}));
  const FolderListing listing = FolderListing::of(folder.path());
  EXPECT_TRUE(listing.entries[0].is_folder);
  EXPECT_EQ(listing.entries[1].bytes, 10u);
  EXPECT_EQ(listing.error, "");
  EXPECT_NE(FolderListing::of(folder.path() / "none").error, "");
}

TEST_F(FolderListingTest, FiltersByAnyPartWhateverTheCase) {
  EXPECT_EQ(names("EL"), (Names{"models", "wheel2.GLTF", "wheel10.glb"}));
  EXPECT_EQ(names("bo"), (Names{"Box.glb"}));
  EXPECT_EQ(names("10"), (Names{"wheel10.glb"}));
  EXPECT_TRUE(names("nothing").empty());
}

TEST_F(FolderListingTest, PagesThroughTheModelsOfTheFolder) {
  const auto after = [&](const char* name, int step) {
    const auto next = next_model(folder.file(name), step);
    return next ? fs::path(next->path).filename().string() + " " + std::to_string(next->number) +
                      "/" + std::to_string(next->count)
                : std::string("none");
  };
  EXPECT_EQ(after("Box.glb", 1), "wheel2.GLTF 2/3");
  EXPECT_EQ(after("wheel10.glb", 1), "Box.glb 1/3");
  EXPECT_EQ(after("Box.glb", -1), "wheel10.glb 3/3");
  EXPECT_EQ(after("models/Fox/Fox.glb", 1), "Hat.gltf 2/2") << "alone in its folder";
  EXPECT_EQ(after("gone.glb", 1), "none");
  EXPECT_FALSE(next_model("builtin:office", 1).has_value());
}

TEST(FileBrowser, SaysThatEnterOpensABuiltInScene) {
  FileBrowser browser;
  browser.typed = "builtin:office";
  EXPECT_EQ(browser.no_match_words(), "Enter opens the built-in scene");
  browser.typed = "no such file";
  EXPECT_EQ(browser.no_match_words(), "No match");
}

TEST_F(FolderListingTest, TabCompletes) {
  FileBrowser browser;
  browser.begin(folder.path());
  browser.typed = "W";
  browser.complete();
  EXPECT_EQ(browser.typed, "wheel") << "as far as the names agree";
  browser.typed = "mo";
  browser.complete();
  EXPECT_EQ(browser.typed, "models/");
  browser.typed += "f";
  browser.complete();
  EXPECT_EQ(browser.typed, "models/Fox/");
  browser.typed = "xyz";
  browser.complete();
  EXPECT_EQ(browser.typed, "xyz") << "nothing to complete";
}

TEST_F(FolderListingTest, EnterOpensWhatIsChosenOrTyped) {
  FileBrowser browser;
  browser.begin(folder.path());
  browser.typed = "wheel";
  browser.move_choice(1);
  EXPECT_EQ(browser.take_entered(), folder.file("wheel10.glb"));
  browser.move_choice(7);
  EXPECT_EQ(browser.take_entered(), folder.file("wheel10.glb")) << "the last one";
  browser.typed = folder.file("models/Fox/Fox.glb");
  EXPECT_EQ(browser.take_entered(), browser.typed);
  browser.typed = "builtin:boxes";
  EXPECT_EQ(browser.take_entered(), "builtin:boxes");
  browser.typed = "/no/such.glb";
  EXPECT_EQ(browser.take_entered(), "/no/such.glb") << "the loader tells what is wrong";
  browser.typed = "models";
  browser.chosen = 0;
  EXPECT_EQ(browser.take_entered(), "");
  EXPECT_EQ(browser.folder, folder.path() / "models");
  EXPECT_EQ(browser.typed, "") << "nothing is left to be appended to";
  browser.begin("/");
  EXPECT_EQ(browser.folder, folder.path() / "models") << "it goes on where it was";
}

}  // namespace
}  // namespace asos
