#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <hwy/highway.h>
#include <hwy/targets.h>

namespace asos::test {

/// Runs `check` with the kernels of each instruction set that was built and that this processor
/// supports.
template <typename Check>
void for_every_target(Check check) {
  const auto targets = hwy::SupportedAndGeneratedTargets();
  ASSERT_FALSE(targets.empty());
  for (const std::int64_t target : targets) {
    SCOPED_TRACE(hwy::TargetName(target));
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    check();
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace asos::test
