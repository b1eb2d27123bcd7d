#include "renderer/session/render_run.h"

#include "renderer/comparison/method.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace asos {
namespace {

// Work of all blocks of ASOS relative to one sample per pixel: about the median over all test
// scenes.
constexpr double blocks_over_sample = 64.0;

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
  growth.push_back(blocks_over_sample / all);
  return growth;
}

}  // namespace

RenderRun::RenderRun(Snapshot snapshot, std::function<void()> on_tiles)
    : render_(std::move(snapshot)),
      tiles_(render_.plan, std::move(on_tiles)),
      samples_(render_),
      steps_(render_, samples_),
      clock_(render_.plan.blocks.size(), growth_of(samples_)) {
  const std::size_t rounds = samples_.rounds().size();
  // The growth from samples to blocks depends on the scene, EPS and MAX.
  if (!samples_.make_the_picture()) clock_.guess(rounds);
  if (render_.snapshot.progressive) return;
  const std::size_t left_out = samples_.make_the_picture() ? rounds - 1 : rounds;
  for (std::size_t round = 0; round < left_out; ++round) clock_.leave_out(round);
}

void RenderRun::work(const std::stop_token& stop) {
  if (render_.snapshot.progressive) coarse_.work(render_, tiles_, stop);
  (void)steps_.blocks_can_start(render_);  // begins the search after the first picture
  clock_.begin_forecast();
  const bool own = samples_.make_the_picture();
  if (render_.snapshot.progressive) {
    work_rounds(0, stop);
  } else if (own) {
    work_rounds(samples_.rounds().size() - 1, stop);
  }
  if (own || stop.stop_requested()) return;
  if (render_.snapshot.progressive) {
    if (!samples_.wait_for_rounds(samples_.rounds().size(), stop)) return;
    steps_.begin();
  }
  count(steps_.work(render_, tiles_, clock_, stop));
}

Reached RenderRun::reached() const {
  Reached reached = tiles_.reached();
  if (!render_.snapshot.progressive || reached.pass != Reached::Pass::samples) return reached;
  const std::vector<int>& rounds = samples_.rounds();
  const auto done = std::count_if(rounds.begin(), rounds.end(),
                                  [&](int samples) { return samples <= reached.samples; });
  reached.rounds = static_cast<int>(rounds.size());
  const auto running = static_cast<int>(done) + 1;
  if (running <= reached.rounds)
    reached.round = running;
  else if (samples_.make_the_picture())
    reached.round = reached.rounds;
  return reached;
}

// Once the last tile is published, the picture is complete, and its user is notified.
void RenderRun::count(bool finished_picture) {
  if (!finished_picture) return;
  clock_.complete();
  tiles_.notify();
}

// Steps continue the samples of the rounds, so a worker finds the right order only after the
// others. A picture of samples alone ends soonest without waiting.
void RenderRun::work_rounds(std::size_t first, const std::stop_token& stop) {
  const bool ordered = !samples_.make_the_picture();
  for (std::size_t round = first; round < samples_.rounds().size(); ++round) {
    if (ordered && !samples_.put_what_moves_first(round, stop)) return;
    count(samples_.work(render_, round, round, tiles_, clock_, stop));
    if (stop.stop_requested()) return;
  }
}

}  // namespace asos
