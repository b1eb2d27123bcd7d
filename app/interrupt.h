#pragma once

namespace asos {

/// While it lives, the first SIGINT or SIGTERM only sets a flag, so that work can stop cleanly; a
/// second one ends the program at once. One at a time.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  [[nodiscard]] bool interrupted() const;
};

/// While it lives, an InterruptGuard's first signal ends the program at once, too, with the exit
/// code of an interrupt and `last_words` on stderr: for work that leaves nothing behind and cannot
/// be asked to stop, such as what libraries do with a file. One at a time.
class AbandonableWork {
 public:
  /// `last_words`: a text that lives as long as the program.
  explicit AbandonableWork(const char* last_words);
  ~AbandonableWork();
  AbandonableWork(const AbandonableWork&) = delete;
  AbandonableWork& operator=(const AbandonableWork&) = delete;
};

}  // namespace asos
