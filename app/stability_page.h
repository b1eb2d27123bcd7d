#pragma once

#include "renderer/stability/case.h"

#include <string>
#include <vector>

namespace asos {

/// CSV as in RFC 4180: a header, then one line per finding.
[[nodiscard]] std::string stability_csv(const std::vector<stability::Finding>& findings);

/// A self-contained HTML page: a summary first, then the failed cases, then all findings by group.
[[nodiscard]] std::string stability_page(const std::vector<stability::Finding>& findings,
                                         bool quick_only);

}  // namespace asos
