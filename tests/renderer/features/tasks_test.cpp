#include "renderer/tasks.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>

namespace asos {
namespace {

TEST(Tasks, TheFirstExceptionReachesTheCaller) {
  for (int turn = 0; turn < 50; ++turn) {
    std::atomic<int> thrown{0};
    try {
      in_tasks(64, [&](std::size_t i) {
        in_tasks(64, [&](std::size_t j) {
          if ((i + j) % 40 != 39) return;
          ++thrown;
          throw std::runtime_error("stopped");
        });
      });
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(error.what(), std::string("stopped"));
      EXPECT_GT(thrown, 0);
    }
  }
}

// Nothing begins after an exception: the first call throws, and others only wait for it.
TEST(Tasks, NoCallBeginsAfterAnException) {
  std::atomic<bool> thrown{false};
  std::atomic<int> begun{0};
  FirstException exception;
  exception.call([&] {
    thrown = true;
    throw std::runtime_error("stopped");
  });
  for (int i = 0; i < 10; ++i) exception.call([&] { ++begun; });
  EXPECT_TRUE(thrown);
  EXPECT_EQ(begun, 0);
  EXPECT_THROW(exception.rethrow(), std::runtime_error);
}

TEST(Tasks, LoopsGoOnAfterAnotherOneFailed) {
  std::atomic<int> calls{0};
  in_tasks(32, [&](std::size_t) {
    EXPECT_THROW(in_tasks(32, [](std::size_t) { throw 1; }), int);
    in_tasks(32, [&](std::size_t) { ++calls; });
  });
  EXPECT_EQ(calls, 32 * 32);
}

}  // namespace
}  // namespace asos
