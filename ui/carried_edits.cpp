#include "ui/carried_edits.h"

#include "renderer/files/counted.h"
#include "renderer/files/printable.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace asos::ui {

namespace {

constexpr int not_there = -1;

// A change of World::origin rounds positions.
bool same_place(glm::dvec3 a, glm::dvec3 b) {
  constexpr double rounding = 1e-9;
  return glm::distance(a, b) <= rounding * (1.0 + glm::length(a) + glm::length(b));
}

bool same_light(const Light& a, Light b, glm::dvec3 moved) {
  move_light(b, moved);
  if (!same_place(a.position, b.position) || a.outlines.size() != b.outlines.size()) return false;
  for (std::size_t i = 0; i < a.outlines.size(); ++i) {
    if (!std::equal(a.outlines[i].begin(), a.outlines[i].end(), b.outlines[i].begin(),
                    b.outlines[i].end(), same_place))
      return false;
  }
  b.position = a.position;
  b.outlines = a.outlines;
  b.own_part = a.own_part;
  return a == b;
}

// For each name of `from`, the index of the same name in `to`, in order where names repeat. Indices
// that `found` has already are not searched again.
void match_names(const std::vector<std::string>& from, const std::vector<std::string>& to,
                 std::vector<int>& found) {
  std::vector<bool> taken(to.size(), false);
  for (const int at : found) {
    if (at != not_there) taken[static_cast<std::size_t>(at)] = true;
  }
  std::multimap<std::string, int> free;
  for (std::size_t i = 0; i < to.size(); ++i) {
    if (!taken[i]) free.emplace(to[i], static_cast<int>(i));
  }
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (found[i] != not_there) continue;
    const auto next = free.find(from[i]);
    if (next == free.end()) continue;
    found[i] = next->second;
    free.erase(next);
  }
}

std::vector<std::string> names_of(const std::vector<EditedLight>& lights) {
  std::vector<std::string> names;
  for (const EditedLight& edited : lights) names.push_back(edited.light.name);
  return names;
}

// For each light of `first`, its index in `opened`.
std::vector<int> match_lights(const std::vector<EditedLight>& first,
                              const std::vector<EditedLight>& opened, glm::dvec3 moved) {
  std::vector<int> found(first.size(), not_there);
  std::vector<bool> taken(opened.size(), false);
  for (std::size_t i = 0; i < first.size(); ++i) {
    for (std::size_t j = 0; j < opened.size() && found[i] == not_there; ++j) {
      if (taken[j] || !same_light(opened[j].light, first[i].light, moved)) continue;
      found[i] = static_cast<int>(j);
      taken[j] = true;
    }
  }
  match_names(names_of(first), names_of(opened), found);
  return found;
}

std::string called(const char* kind, const std::string& name) {
  return name.empty() ? fmt::format("unnamed {}", kind)
                      : fmt::format("{} '{}'", kind, printable(name));
}

}  // namespace

std::vector<EditedLight> carried_lights(const std::vector<EditedLight>& before,
                                        const std::vector<EditedLight>& first,
                                        const std::vector<EditedLight>& opened, glm::dvec3 moved,
                                        CarriedEdits& carried) {
  const std::vector<int> found = match_lights(first, opened, moved);
  std::vector<EditedLight> lights;
  std::vector<bool> present(first.size(), false), used(opened.size(), false);
  for (EditedLight edited : before) {
    const bool added = edited.source < 0;
    move_light(edited.light, moved);
    move_light(edited.original, moved);
    if (added) {
      ++carried.lights;
      lights.push_back(std::move(edited));
      continue;
    }
    const auto source = static_cast<std::size_t>(edited.source);
    present[source] = true;
    const bool changed =
        edited.on != first[source].on || !same_light(edited.light, first[source].light, moved);
    if (found[source] == not_there) {
      if (changed) carried.lost.push_back(called("light", first[source].light.name));
      continue;
    }
    EditedLight now = opened[static_cast<std::size_t>(found[source])];
    used[static_cast<std::size_t>(found[source])] = true;
    if (changed) {
      ++carried.lights;
      edited.light.own_part = now.light.own_part;
      now.light = std::move(edited.light);
      now.on = edited.on;
    }
    lights.push_back(std::move(now));
  }
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (present[i] || found[i] == not_there) continue;
    ++carried.lights;  // removed by the user
    used[static_cast<std::size_t>(found[i])] = true;
  }
  for (std::size_t j = 0; j < opened.size(); ++j) {
    if (!used[j]) lights.push_back(opened[j]);
  }
  return lights;
}

MaterialDfrs carried_dfrs(const NamedDfrs& before, const MaterialDfrs& first, NamedDfrs opened,
                          CarriedEdits& carried) {
  std::vector<int> found(before.names.size(), not_there);
  match_names(before.names, opened.names, found);
  const std::size_t count = std::min({before.dfrs.size(), first.size(), found.size()});
  for (std::size_t i = 0; i < count; ++i) {
    if (before.dfrs[i] == first[i]) continue;
    if (found[i] == not_there) {
      carried.lost.push_back(called("material", before.names[i]));
      continue;
    }
    ++carried.dfrs;
    opened.dfrs[static_cast<std::size_t>(found[i])] = before.dfrs[i];
  }
  return std::move(opened.dfrs);
}

std::string carried_words(const CarriedEdits& carried) {
  std::string kept;
  if (carried.lights > 0) kept = counted(carried.lights, "light edit");
  if (carried.dfrs > 0) kept += (kept.empty() ? "" : ", ") + counted(carried.dfrs, "DFR edit");
  if (!kept.empty()) kept = "Kept " + kept;
  if (carried.lost.empty()) return kept;
  return kept + (kept.empty() ? "" : ". ") +
         fmt::format("Lost, no longer in the scene: {}", fmt::join(carried.lost, ", "));
}

}  // namespace asos::ui
