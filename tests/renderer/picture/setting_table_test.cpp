#include "renderer/settings/setting_table.h"

#include "renderer/picture/settings_json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>

namespace asos {
namespace {

// A value of the range that is not the default.
double another(const SettingRow& row) {
  if (row.option == std::string("fat")) return 4.0;
  return row.usual() == row.lo ? std::min(row.hi, row.lo + 1.0) : row.lo;
}

TEST(SettingTable, NamesAreUniqueAndDefaultsInRange) {
  std::set<std::string> keys, options;
  for (const SettingRow& row : setting_table()) {
    EXPECT_TRUE(keys.insert(row.key).second) << row.key;
    EXPECT_TRUE(options.insert(row.option).second) << row.option;
    EXPECT_GE(row.usual(), row.lo) << row.key;
    EXPECT_LE(row.usual(), row.hi) << row.key;
    EXPECT_EQ(find_setting(row.key), &row);
    EXPECT_EQ(&setting_of_option(row.option), &row);
  }
  EXPECT_EQ(find_setting("no-such"), nullptr);
  EXPECT_THROW((void)setting_of_option("no-such"), std::logic_error);
}

TEST(SettingTable, TextsAreReadBack) {
  for (const SettingRow& row : setting_table()) {
    for (const double value : {row.usual(), row.lo, row.hi, another(row)})
      EXPECT_EQ(row.parse(row.text_of(value)).value(), value) << row.key;
    for (const char* text : {"", "nan", "such", "1e99", "-2"})
      EXPECT_FALSE(row.parse(text)) << row.key << " " << text;
  }
}

TEST(SettingTable, EachRowHasAMemberOfItsOwn) {
  for (const SettingRow& row : setting_table()) {
    RenderSettings settings;
    row.set(settings, another(row));
    for (const SettingRow& other : setting_table())
      EXPECT_EQ(other.get(settings) != other.usual(), &other == &row) << row.key << other.key;
  }
}

TEST(SettingTable, ValuesBeyondTheRangeAreErrors) {
  for (const SettingRow& row : setting_table()) {
    if (row.kind == SettingKind::flag) continue;
    for (const double value : {row.lo - 1.0, row.hi + 1.0, std::nan("")}) {
      if (row.kind != SettingKind::number && !(std::abs(value) <= std::numeric_limits<int>::max()))
        continue;
      RenderSettings settings;
      row.set(settings, value);
      const auto checked = validated(settings);
      ASSERT_FALSE(checked) << row.key << " " << value;
      EXPECT_EQ(checked.error().subject, row.option);
    }
  }
}

TEST(SettingTable, SavedPicturesHoldEachValue) {
  for (const SettingRow& row : setting_table()) {
    RenderSettings settings;
    row.set(settings, another(row));
    const auto read = settings_from_json(settings_json(settings));
    ASSERT_TRUE(read) << row.key << ": " << read.error().message();
    const bool saved = row.saved != Saved::never;
    EXPECT_EQ(row.get(read->settings), saved ? another(row) : row.usual()) << row.key;
  }
}

}  // namespace
}  // namespace asos
