#pragma once
#include <string>
#include <variant>
#include <vector>

#include "agents/agent/process/calibrate/jobs.hpp"

namespace weft::agents::test {

/// Returns what is understood of the words after `weft-agent calibrate`.
inline std::variant<CameraJob, MountJob, Leave> parsed(const std::vector<std::string>& words) {
  std::vector<const char*> argv = {"calibrate"};
  for (const std::string& word : words) argv.push_back(word.c_str());
  return parse_calibrate(static_cast<int>(argv.size()), argv.data());
}

}  // namespace weft::agents::test
