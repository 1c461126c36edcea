#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "agents/agent/agent.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// Appends what judges read (docs/formats/records.md): fixes.jsonl, acks.jsonl, drives.jsonl, orders.jsonl,
/// motion.jsonl. Several agents may append to the same files.
class Records {
 public:
  /// Opens the files. unavailable: the directory is not there or cannot be written.
  static Result<Records> open(const std::filesystem::path& directory, const std::string& robot);
  Records(Records&& other) noexcept;
  Records& operator=(Records&&) = delete;
  ~Records();

  void note(const AgentOutput& output, std::uint64_t frame);
  /// Notes the order that is now in force, when it is another one than before; `frame`: the last one before it.
  void note(const std::optional<Route>& route, std::uint64_t frame);
  /// Returns how many lines could not be written whole, as on a full disk: then these files do not show all.
  std::uint64_t lost() const { return lost_; }

 private:
  explicit Records(std::string robot) : robot_(std::move(robot)) {}
  void note(const msg::RouteProgress& progress, std::uint64_t frame);
  void note(const msg::RobotState& state);
  void append(int file, const std::string& line);

  /// Tells one order from the next.
  struct Order {
    RouteId route;
    std::uint32_t version = 0;
    std::uint32_t released = 0;
    bool operator==(const Order&) const = default;
  };

  std::string robot_;
  int fixes_ = -1;
  int acks_ = -1;
  int drives_ = -1;
  int orders_ = -1;
  int motion_ = -1;
  msg::RouteProgress told_;  ///< the last one written
  Order order_;              ///< likewise
  std::uint64_t lost_ = 0;
};

}  // namespace weft::agents
