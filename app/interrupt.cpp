#include "app/interrupt.h"

#include "app/exit_code.h"

#include <atomic>
#include <csignal>
#include <cstring>
#include <unistd.h>

namespace asos {
namespace {

volatile std::sig_atomic_t caught = 0;
struct sigaction old_interrupt;
struct sigaction old_terminate;

volatile std::sig_atomic_t on_terminal = 0;
std::atomic<const char*> words_when_abandoned{nullptr};
static_assert(std::atomic<const char*>::is_always_lock_free, "a signal's handler reads it");

// Called by the signal handler, too: it must not allocate or lock.
void abandon_if_allowed() {
  const char* words = words_when_abandoned;
  if (!words) return;
  const auto say = [](const char* text) {
    const ssize_t written = ::write(STDERR_FILENO, text, std::strlen(text));
    static_cast<void>(written);  // a failure cannot be reported
  };
  if (on_terminal != 0) say("\r\x1b[K");  // erases the progress bar
  say(words);
  ::_exit(exit_interrupted);
}

void remember(int) {
  caught = 1;
  abandon_if_allowed();
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
  caught = 0;
}

bool InterruptGuard::interrupted() const {
  return caught != 0;
}

AbandonableWork::AbandonableWork(const char* last_words) {
  on_terminal = ::isatty(STDERR_FILENO);
  words_when_abandoned = last_words;
  if (caught != 0) abandon_if_allowed();
}

AbandonableWork::~AbandonableWork() {
  words_when_abandoned = nullptr;
}

}  // namespace asos
