#include "app/stability_command.h"

#include "app/stability_page.h"
#include "tests/app/run_asos.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace asos {
namespace {

using stability::Case;
using stability::Finding;
using test::contains;
using test::content_of;
using test::TemporaryFolder;

Case made_up(const std::string& name, double error) {
  return {name, "made up", true, [error]() -> Result<stability::Outcome> {
            stability::Outcome outcome;
            outcome.quantity = "length, \"m\"";
            outcome.expected = 2.0;
            outcome.got = 2.0 + error;
            outcome.error = error;
            outcome.bound = 0.25;
            outcome.reason = "a < b & c";
            return outcome;
          }};
}

struct Told {
  int exit_code;
  std::string out, err, page, table;
};

Told run(const std::vector<Case>& cases) {
  const TemporaryFolder folder;
  std::ostringstream out, err;
  const int exit_code = run_stability({folder.file("a/b"), true}, cases, {out, err, false});
  return {exit_code, out.str(), err.str(), content_of(folder.file("a/b/stability.html")),
          content_of(folder.file("a/b/stability.csv"))};
}

TEST(StabilityCommand, CasesThatHoldExitWithZero) {
  const Told told = run({made_up("one", 0.125), made_up("other", 0.25)});
  EXPECT_EQ(told.exit_code, 0);
  EXPECT_TRUE(contains(told.out, "2 cases, 0 broken"));
  EXPECT_TRUE(contains(told.out, "stability.html"));
  EXPECT_EQ(told.err, "");
  EXPECT_TRUE(contains(told.page, "2 cases (the quick part): 2 hold, 0 broken."));
  EXPECT_FALSE(contains(told.page, "<h2>Broken</h2>"));
}

TEST(StabilityCommand, ABrokenCaseExitsWithOneAndComesFirst) {
  const Told told = run({made_up("sound", 0.125), made_up("wrong", 0.5)});
  EXPECT_EQ(told.exit_code, 1);
  EXPECT_TRUE(contains(told.out, "Broken: made up: wrong\n"));
  EXPECT_TRUE(contains(told.out, "2 cases, 1 broken"));
  EXPECT_TRUE(contains(told.page, "1 hold, 1 broken."));
  EXPECT_LT(told.page.find("<h2>Broken</h2>"), told.page.find("sound"));
  EXPECT_LT(told.page.find("BROKEN"), told.page.find("sound"));
}

TEST(StabilityCommand, TheTableHasOneLineACaseAndQuotesText) {
  const Told told = run({made_up("sound", 0.125), made_up("wrong", 0.5)});
  EXPECT_EQ(std::count(told.table.begin(), told.table.end(), '\n'), 3);
  EXPECT_TRUE(contains(told.table,
                       "group,case,result,quantity,expected,got,error,bound,rejected_samples,"
                       "pixels_not_finite,seconds,reason\n\"made up\",\"sound\",holds,"
                       "\"length, \"\"m\"\"\",2,2.125,0.125,0.25,0,0,"));
  EXPECT_TRUE(contains(told.table, "\"wrong\",broken,"));
  EXPECT_TRUE(contains(told.page, "a &lt; b &amp; c"));
}

TEST(StabilityCommand, ACaseWithoutAFigureIsBrokenAndSaysWhy) {
  const Told told = run({{"none", "made up", true, []() -> Result<stability::Outcome> {
                            return unexpected(Error{"scene", "has no camera"});
                          }}});
  EXPECT_EQ(told.exit_code, 1);
  EXPECT_TRUE(contains(told.page, "scene: has no camera"));
  EXPECT_TRUE(contains(told.table, "broken,\"\",,,,,0,0,"));
}

TEST(StabilityCommand, NeedsAFolderThatCanBeMade) {
  EXPECT_EQ(test::run_asos({"stability"}).exit_code, 2);
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "");
  const test::AsosRun refused = test::run_asos({"stability", "-o", file + "/inside"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_TRUE(contains(refused.err, "inside"));
}

TEST(StabilityPage, IsCompleteInItself) {
  const std::string page = stability_page({}, false);
  EXPECT_TRUE(contains(page, "0 cases: 0 hold, 0 broken."));
  EXPECT_TRUE(contains(page, "Left out, since the program does not have them"));
  for (const char* other : {"http", "src=", "<script", "<link"})
    EXPECT_FALSE(contains(page, other)) << other;
}

}  // namespace
}  // namespace asos
