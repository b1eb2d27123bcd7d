#include "renderer/pyray/observer.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace asos::test::observer_test {
namespace {

// The words are in files that `asos trace --json` has written.
TEST(CellFate, HasTheWordOfTheTrace) {
  for (const auto& [fate, word] :
       {std::pair{CellFate::uniform, "uniform"}, std::pair{CellFate::cut, "cut"},
        std::pair{CellFate::uneven, "uneven"}, std::pair{CellFate::split, "split"},
        std::pair{CellFate::stopped, "stopped"}, std::pair{CellFate::finest, "finest"},
        std::pair{CellFate::sampled, "sampled"}, std::pair{CellFate::saturated, "saturated"},
        std::pair{CellFate::by_samples, "by samples"}})
    EXPECT_EQ(std::string(name_of(fate)), word);
}

}  // namespace
}  // namespace asos::test::observer_test
