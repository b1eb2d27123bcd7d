#include "renderer/study/timed_out_settings.h"

namespace asos {
namespace {

std::string setting_of(const Job& job) {
  return job.rung.method + " " + job.rung.setting;
}

}  // namespace

void TimedOutSettings::add(const Job& job) {
  if (job.kind != JobKind::point) return;
  settings_.insert(setting_of(job));
  // In later repetitions, the earlier ones have shown that the curve continues.
  if (job.repetition == 1) curves_.insert(job.rung.curve);
}

bool TimedOutSettings::holds(const Job& job) const {
  if (job.kind != JobKind::point) return false;
  return settings_.contains(setting_of(job)) ||
         (job.repetition == 1 && curves_.contains(job.rung.curve));
}

}  // namespace asos
