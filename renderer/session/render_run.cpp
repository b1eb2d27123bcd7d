#include "renderer/session/render_run.h"

#include "renderer/comparison/method.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace asos {
namespace {

// Rounds that always come before blocks: 1, 2 and 4 samples per pixel, or only 1 if blocks take no
// more themselves.
std::size_t least_rounds(const RenderSettings& settings) {
  return in_object_space(settings.method) && settings.asos.max_level == 0 ? 1 : 3;
}
// Rounds assumed by the forecast until their number is decided: up to 16 samples per pixel.
constexpr std::size_t usual_rounds = 5;
// More rounds follow while all rounds together take at most this fraction of the time of the
// blocks. Up to there, samples improve the picture fastest, and they delay its end only a little.
constexpr double most_share_of_rounds = 0.3;
// Time of the trial as a fraction of the rounds before: enough to find out if the blocks take many
// times as long as the rounds.
constexpr double share_of_trial = 0.1;
// Work of all blocks of ASOS relative to one sample per pixel: about the median over all test
// scenes.
constexpr double blocks_over_sample = 64.0;
// The fraction of that work in the blocks' first stage.
constexpr double start_of_blocks = 0.6;

// Returns the growth of the work from round to round, and from the last round to the blocks.
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
  // Both stages of the blocks; their growth depends on the scene, EPS and MAX.
  clock_.guess(rounds);
  clock_.guess(rounds + 1);
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

Reached RenderRun::reached() const {
  Reached reached = tiles_.reached();
  if (!render_.snapshot.progressive || reached.pass != Reached::Pass::samples) return reached;
  const std::vector<int>& rounds = samples_.rounds();
  const auto done = std::count_if(rounds.begin(), rounds.end(),
                                  [&](int samples) { return samples <= reached.samples; });
  const auto running = static_cast<int>(done) + 1;
  if (samples_.make_the_picture()) {
    reached.rounds = static_cast<int>(rounds.size());
    reached.round = std::min(running, reached.rounds);
    return reached;
  }
  const std::lock_guard lock(mutex_);
  const auto end = std::find(taken_.begin(), taken_.end(), false);
  if (end != taken_.end()) reached.rounds = static_cast<int>(end - taken_.begin());
  if (!sampled_ && (reached.rounds == 0 || running <= reached.rounds)) reached.round = running;
  return reached;
}

// Once the last tile is published, the picture is complete, and its user is notified.
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
  // All threads have left the rounds; only the first thread here reads the samples.
  const std::lock_guard lock(mutex_);
  if (std::exchange(sampled_, true)) return;
  const std::vector<double> gain = samples_.moved(render_.plan);
  blocks_.set_gains(gain);
  clock_.set_likeness(gain);
  samples_.release();
}

// Returns whether a round of samples comes before the blocks. The first thread to find out decides
// for all.
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
