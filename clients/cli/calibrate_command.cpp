#include <unistd.h>

#include <filesystem>

#include "clients/cli/commands.hpp"

namespace weft::cli {

Exit run_calibrate(const Invocation& invocation, const Output& output) {
  std::vector<std::string> words = {"weft-agent", "calibrate"};
  words.insert(words.end(), invocation.passed.begin(), invocation.passed.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  output.out.flush();
  std::error_code problem;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", problem);
  if (!problem) execv((self.parent_path() / words.front()).c_str(), argv.data());
  execvp(words.front().c_str(), argv.data());
  return report({ErrorCode::internal,
                 "weft-agent, which calibrates, is neither beside weft nor on the PATH; run this on a robot"},
                false, output);
}

}  // namespace weft::cli
