#include "renderer/files/read_file.h"

#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <sys/stat.h>

namespace asos::read_file_test {
namespace {

std::string refusal(const std::filesystem::path& path, const FileRules& rules) {
  const auto read = read_file(path, rules);
  return read ? "" : read.error();
}

TEST(ReadFile, GivesAllOfARegularFile) {
  const test::TemporaryFolder folder;
  for (const std::size_t size : {0, 1, 63, 64, 65, 1'000'000}) {
    std::string bytes(size, 'x');
    if (size > 0) bytes.back() = 'y';
    const auto read = read_file(folder.write("file", bytes), {1'000'000});
    ASSERT_TRUE(read) << read.error();
    EXPECT_EQ(std::string(read->begin(), read->end()), bytes);
  }
}

TEST(ReadFile, RefusesWhatIsNoRegularFileAtOnce) {
  const test::TemporaryFolder folder;
  const std::string pipe = folder.file("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::filesystem::create_symlink("/dev/zero", folder.file("zero"));
  std::filesystem::create_symlink(pipe, folder.file("link"));
  constexpr std::uint64_t any = ~std::uint64_t{0};
  for (const char* name : {"pipe", "zero", "link"})
    EXPECT_EQ(refusal(folder.file(name), {any}), "is not a regular file") << name;
  EXPECT_EQ(refusal(folder.path(), {any}), "is a directory");
  EXPECT_NE(refusal(folder.file("none"), {any}).find("cannot be opened"), std::string::npos);
}

TEST(ReadFile, JudgesSizeAndHeadBeforeTheRest) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("large", "magic");
  // A sparse file of a terabyte: reading it would be noticed.
  std::filesystem::resize_file(path, std::uintmax_t{1} << 40);
  EXPECT_EQ(refusal(path, {1000}), "has 1099511627776 bytes; the limit is 1000");
  FileRules rules{std::uint64_t{1} << 41};
  rules.fault = [](const FileHead& head) {
    EXPECT_EQ(head.bytes.size(), FileHead::length);
    EXPECT_EQ(head.file_size, std::uint64_t{1} << 40);
    return begins_with(head.bytes, "magic") ? "has magic" : "has none";
  };
  EXPECT_EQ(refusal(path, rules), "has magic");
}

TEST(ReadFile, TheHeadOfAShortFileIsAllOfIt) {
  const test::TemporaryFolder folder;
  FileRules rules{10};
  rules.fault = [](const FileHead& head) {
    return std::string(head.bytes.begin(), head.bytes.end()) + "!";
  };
  EXPECT_EQ(refusal(folder.write("short", "abc"), rules), "abc!");
  EXPECT_EQ(refusal(folder.write("empty", ""), rules), "!");
  EXPECT_FALSE(begins_with({}, "a"));
}

}  // namespace
}  // namespace asos::read_file_test
