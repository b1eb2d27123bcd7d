#include "app/interrupt.h"

#include <csignal>

namespace asos {
namespace {

volatile std::sig_atomic_t caught = 0;
struct sigaction old_interrupt;
struct sigaction old_terminate;

void remember(int) {
  caught = 1;
}

}  // namespace

InterruptGuard::InterruptGuard() {
  caught = 0;
  struct sigaction action {};
  action.sa_handler = remember;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, &old_interrupt);
  sigaction(SIGTERM, &action, &old_terminate);
}

InterruptGuard::~InterruptGuard() {
  sigaction(SIGINT, &old_interrupt, nullptr);
  sigaction(SIGTERM, &old_terminate, nullptr);
}

bool InterruptGuard::interrupted() const {
  return caught != 0;
}

}  // namespace asos
