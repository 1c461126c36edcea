#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>

#include "agents/agent/agent.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// Appends what the judge reads (docs/formats/records.md): fixes.jsonl, acks.jsonl, drives.jsonl. Several agents may
/// append to the same files.
class Records {
 public:
  /// Opens the files. unavailable: the directory is not there or cannot be written.
  static Result<Records> open(const std::filesystem::path& directory, const std::string& robot);
  Records(Records&& other) noexcept;
  Records& operator=(Records&&) = delete;
  ~Records();

  void note(const AgentOutput& output, std::uint64_t frame);
  /// Returns how many lines could not be written whole, as on a full disk: then these files do not show all.
  std::uint64_t lost() const { return lost_; }

 private:
  explicit Records(std::string robot) : robot_(std::move(robot)) {}
  void note(const msg::RouteProgress& progress, std::uint64_t frame);
  void append(int file, const std::string& line);

  std::string robot_;
  int fixes_ = -1;
  int acks_ = -1;
  int drives_ = -1;
  msg::RouteProgress told_;  ///< the last one written
  std::uint64_t lost_ = 0;
};

}  // namespace weft::agents
