#pragma once
#include <string>
#include <vector>

#include "core/result.hpp"

namespace weft::evaluate::bearing {

/// Returns the one of that name, or all without a name. invalid: names the option and what there is.
template <class Named>
Result<std::vector<Named>> chosen(const std::vector<Named>& all, const std::string& one, const std::string& option) {
  if (one.empty()) return all;
  std::string names;
  for (const Named& each : all) {
    if (each.name == one) return std::vector{each};
    names += (names.empty() ? "" : ", ") + each.name;
  }
  return fail(ErrorCode::invalid, option + ": there is no '" + one + "'; there are " + names);
}

}  // namespace weft::evaluate::bearing
