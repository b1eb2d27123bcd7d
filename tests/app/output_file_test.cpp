#include "app/output_file.h"

#include "renderer/film/part_file.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <sys/wait.h>
#include <unistd.h>

namespace asos {
namespace {

namespace fs = std::filesystem;
using test::content_of;

Result<void> write(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
  return {};
}

TEST(OutputFile, PlanningLeavesNothingBehind) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(OutputFile::plan((folder.path() / "new.png").string()));
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(OutputFile, CommitReplacesWhatWasThere) {
  const test::TemporaryFolder folder;
  const std::string path = (folder.path() / "old and ö.png").string();
  ASSERT_TRUE(write(path, "old"));
  const auto file = OutputFile::plan(path);
  ASSERT_TRUE(file);
  EXPECT_EQ(content_of(path), "old");
  ASSERT_TRUE(file->commit([](const std::string& to) {
    EXPECT_TRUE(to.ends_with(".png")) << to;
    return write(to, "new");
  }));
  EXPECT_EQ(content_of(path), "new");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

TEST(OutputFile, AFailedWriteKeepsTheOldFile) {
  const test::TemporaryFolder folder;
  const std::string path = (folder.path() / "a.png").string();
  ASSERT_TRUE(write(path, "old"));
  const auto file = OutputFile::plan(path);
  ASSERT_TRUE(file);
  const auto failed = file->commit([](const std::string& to) -> Result<void> {
    EXPECT_TRUE(write(to, "half"));
    return tl::unexpected(Error{to, "the disk is full"});
  });
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().message(), path + ": the disk is full");
  EXPECT_EQ(content_of(path), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

TEST(OutputFile, ALinkStaysALink) {
  const test::TemporaryFolder folder;
  const fs::path target = folder.path() / "target.png";
  const fs::path link = folder.path() / "link.png";
  ASSERT_TRUE(write(target.string(), "old"));
  fs::create_symlink(target, link);
  ASSERT_TRUE(OutputFile::plan(link.string()).and_then([](const OutputFile& file) {
    return file.commit([](const std::string& to) { return write(to, "new"); });
  }));
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(content_of(target), "new");
}

TEST(OutputFile, ALinkToAFileThatDoesNotExistIsFollowed) {
  const test::TemporaryFolder folder;
  fs::create_directory(folder.path() / "there");
  const fs::path target = folder.path() / "there" / "target.png";
  fs::create_symlink("there/second.png", folder.path() / "link.png");
  fs::create_symlink("target.png", folder.path() / "there" / "second.png");
  const std::string link = folder.file("link.png");
  EXPECT_TRUE(same_file(link, target.string()));
  ASSERT_TRUE(OutputFile::plan(link).and_then([](const OutputFile& file) {
    return file.commit([](const std::string& to) { return write(to, "new"); });
  }));
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_TRUE(fs::is_symlink(folder.path() / "there" / "second.png"));
  EXPECT_EQ(content_of(target), "new");
  fs::create_symlink("circle.png", folder.path() / "circle.png");
  EXPECT_FALSE(OutputFile::plan(folder.file("circle.png")).and_then([](const OutputFile& file) {
    return file.commit([](const std::string& to) { return write(to, "new"); });
  }));
}

TEST(OutputFile, DevicesAreWrittenToAndNotReplaced) {
  const auto file = OutputFile::plan("/dev/null");
  ASSERT_TRUE(file);
  ASSERT_TRUE(file->commit([](const std::string& to) {
    EXPECT_EQ(to, "/dev/null");
    return Result<void>{};
  }));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(OutputFile, WhatAKilledRunLeftGoesWithTheNextOfTheSameOutput) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("picture.png");
  const auto names = [&] {
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(folder.path()))
      count += entry.path().filename().string().find("asos-part") != std::string::npos ? 1 : 0;
    return count;
  };
  const pid_t child = ::fork();
  if (child == 0) {
    const auto file = OutputFile::plan(path);
    const auto never = file->commit([](const std::string& to) -> Result<void> {
      // Write as picture writers do: through a temporary file in the same folder.
      const auto part = PartFile::create(to);
      ::kill(::getpid(), SIGKILL);
      return part ? Result<void>{} : unexpected(part.error());
    });
    ::_exit(never ? 1 : 2);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  ASSERT_EQ(names(), 1u);
  ASSERT_TRUE(OutputFile::plan(folder.file("other.png")));
  EXPECT_EQ(names(), 1u) << "that of another output";
  // The temporary file of a run in progress stays.
  const auto running = PartFile::create(path);
  ASSERT_TRUE(running);
  ASSERT_TRUE(OutputFile::plan(path));
  EXPECT_EQ(names(), 1u);
}

TEST(OutputFile, ImpossiblePathsAreRefusedBeforeTheWork) {
  const test::TemporaryFolder folder;
  for (const std::string& path :
       {std::string(), folder.path().string(), (folder.path() / "no" / "such" / "a.png").string(),
        folder.path().string() + "/", std::string("/proc/a.png")}) {
    const auto file = OutputFile::plan(path);
    ASSERT_FALSE(file) << path;
    EXPECT_NE(file.error().message().find("cannot be written: "), std::string::npos);
  }
}

TEST(OutputFile, Extensions) {
  EXPECT_TRUE(has_extension("a.PNG", ".png"));
  EXPECT_FALSE(has_extension("png", ".png"));
  EXPECT_FALSE(has_extension("a.png.exr", ".png"));
}

}  // namespace
}  // namespace asos
