#pragma once

namespace asos {

/// During its lifetime, the first SIGINT or SIGTERM only sets a flag, so that work can stop
/// cleanly; a second one ends the program at once. Only one instance at a time.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  [[nodiscard]] bool interrupted() const;
};

/// During its lifetime, the first signal ends the program at once even with an InterruptGuard, with
/// the exit code of an interrupt and `last_words` on stderr. For work that leaves no files and
/// cannot be interrupted, such as library calls that read a file. Only one instance at a time.
class AbandonableWork {
 public:
  /// `last_words` must stay valid until the program ends.
  explicit AbandonableWork(const char* last_words);
  ~AbandonableWork();
  AbandonableWork(const AbandonableWork&) = delete;
  AbandonableWork& operator=(const AbandonableWork&) = delete;
};

}  // namespace asos
