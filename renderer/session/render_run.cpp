#include "renderer/session/render_run.h"

#include "renderer/comparison/method.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace asos {
namespace {

// Rounds that come before blocks in any case: 1, 2 and 4 samples a pixel, or one where blocks take
// no more themselves.
std::size_t least_rounds(const RenderSettings& settings) {
  return in_object_space(settings.method) && settings.asos.max_level == 0 ? 1 : 3;
}
// And those that are likely to, until it is decided: up to 16 samples a pixel.
constexpr std::size_t usual_rounds = 5;
// More are taken while all rounds together take no more than this share of what the blocks take.
// While less is done, samples are the quickest way to a better picture; and whoever waits for the
// end waits little longer.
constexpr double most_share_of_rounds = 0.3;
// Blocks are tried for about this share of the time of the rounds before: as few as tell whether
// all of them take many times as long.
constexpr double share_of_trial = 0.1;
// Work of all blocks of ASOS over that of one sample a pixel, about: the median over all scenes.
constexpr double blocks_over_sample = 64.0;
// The share of this of their first stage.
constexpr double start_of_blocks = 0.6;

// How the work grows from round to round of samples, and from the last to the blocks.
std::vector<double> growth_of(const SampleRounds& samples) {
  std::vector<double> growth;
  const std::vector<int>& rounds = samples.rounds();
  for (std::size_t i = 1; i < rounds.size(); ++i) {
    const int before = i > 1 ? rounds[i - 2] : 0;
    growth.push_back(static_cast<double>(rounds[i] - rounds[i - 1]) / (rounds[i - 1] - before));
  }
  if (samples.make_the_picture()) return growth;
  double all = 1.0;
  for (const double one : growth) all *= one;
  growth.push_back(start_of_blocks * blocks_over_sample / all);
  growth.push_back((1.0 - start_of_blocks) / start_of_blocks);
  return growth;
}

}  // namespace

RenderRun::RenderRun(Snapshot snapshot, std::function<void()> on_tiles)
    : render_(std::move(snapshot)),
      tiles_(render_.plan, std::move(on_tiles)),
      samples_(render_),
      blocks_(render_, samples_.rounds().size()),
      clock_(render_.plan.blocks.size(), growth_of(samples_)) {
  const std::size_t rounds = samples_.rounds().size();
  if (samples_.make_the_picture()) {
    if (render_.snapshot.progressive) return;
    for (std::size_t round = 0; round + 1 < rounds; ++round) clock_.leave_out(round);
    return;
  }
  const std::size_t first = render_.snapshot.progressive ? usual_rounds : 0;
  for (std::size_t round = first; round < rounds; ++round) clock_.leave_out(round);
}

void RenderRun::work(const std::stop_token& stop) {
  if (render_.snapshot.progressive) coarse_.work(render_, tiles_, stop);
  clock_.begin_forecast();
  if (samples_.make_the_picture()) {
    work_samples(stop);
  } else {
    work_blocks(stop);
  }
}

// The picture is complete once its last tile is published, and its user is told so.
void RenderRun::count(bool finished_picture) {
  if (!finished_picture) return;
  clock_.complete();
  tiles_.notify();
}

void RenderRun::work_samples(const std::stop_token& stop) {
  const std::size_t rounds = samples_.rounds().size();
  const std::size_t first = render_.snapshot.progressive ? 0 : rounds - 1;
  for (std::size_t round = first; round < rounds && !stop.stop_requested(); ++round)
    count(samples_.work(render_, round, round, tiles_, clock_, stop));
}

void RenderRun::work_blocks(const std::stop_token& stop) {
  if (render_.snapshot.progressive) sample_first(stop);
  if (stop.stop_requested() || !wait_for_boundaries(stop)) return;
  count(blocks_.work(render_, tiles_, clock_, stop));
}

void RenderRun::sample_first(const std::stop_token& stop) {
  std::size_t round = 0;
  while (round < samples_.rounds().size() && takes_round(round, stop)) {
    count(samples_.work(render_, round, round, tiles_, clock_, stop));
    if (!samples_.wait_for(round, stop)) return;
    ++round;
    samples_.put_what_moves_first(round);
  }
  if (stop.stop_requested()) return;
  // All threads have left the rounds, and only the first one reads their samples.
  const std::lock_guard lock(mutex_);
  if (std::exchange(sampled_, true)) return;
  const std::vector<double> gain = samples_.moved(render_.plan);
  blocks_.set_gains(gain);
  clock_.set_likeness(gain);
  samples_.release();
}

// Whether a round of samples comes before blocks. The first thread that knows decides for all.
bool RenderRun::takes_round(std::size_t round, const std::stop_token& stop) {
  const std::size_t least = least_rounds(render_.snapshot.settings);
  if (round < least) return true;
  {
    const std::lock_guard lock(mutex_);
    taken_.resize(std::max(taken_.size(), least), true);
    if (round < taken_.size()) return taken_[round];
    const Boundaries boundaries = look_for_boundaries();
    if (boundaries != Boundaries::known) {
      taken_.push_back(boundaries == Boundaries::sought);
      return taken_[round];
    }
  }
  const double before = samples_.seconds_up_to(round - 1);
  count(blocks_.work_trial(render_, share_of_trial * before, tiles_, clock_, stop));
  if (!blocks_.wait_for_trial(stop)) return false;
  const double after = before * samples_.rounds()[round] / samples_.rounds()[round - 1];
  const bool takes = after <= most_share_of_rounds * blocks_.expected_seconds();
  const std::lock_guard lock(mutex_);
  if (round < taken_.size()) return taken_[round];
  taken_.push_back(takes);
  for (std::size_t left = round; !takes && left < samples_.rounds().size(); ++left)
    clock_.leave_out(left);
  return takes;
}

RenderRun::Boundaries RenderRun::look_for_boundaries() const {
  if (!needs_boundaries(render_.snapshot.settings.method)) return Boundaries::known;
  const BoundaryFeatures& boundaries = render_.snapshot.scene->geometry->boundaries;
  if (boundaries.known()) return Boundaries::known;
  return boundaries.failed() ? Boundaries::failed : Boundaries::sought;
}

bool RenderRun::wait_for_boundaries(const std::stop_token& stop) {
  if (!needs_boundaries(render_.snapshot.settings.method)) return true;
  const BoundaryFeatures& boundaries = render_.snapshot.scene->geometry->boundaries;
  const bool known = boundaries.wait(stop);
  if (boundaries.failed()) clock_.fail();
  return known;
}

}  // namespace asos
