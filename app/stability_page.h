#pragma once

#include "renderer/stability/case.h"

#include <string>
#include <vector>

namespace asos {

/// One line of headings, then one line a finding, as RFC 4180 has it.
[[nodiscard]] std::string stability_csv(const std::vector<stability::Finding>& findings);

/// A page that opens from disk and needs no other file: a summary first, then what is broken, then
/// all findings by group.
[[nodiscard]] std::string stability_page(const std::vector<stability::Finding>& findings,
                                         bool quick_only);

}  // namespace asos
