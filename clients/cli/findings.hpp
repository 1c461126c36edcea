#pragma once
#include <string>
#include <vector>

#include "clients/cli/commands.hpp"
#include "clients/cli/echo_probe.hpp"
#include "core/protocol/messages.hpp"

namespace weft::cli {

inline constexpr double kSilent_s = 5.0;  ///< a robot that was not heard for longer
inline constexpr double kLossy = 0.02;    ///< share of messages: the network loses too many

/// Describes one thing that was looked at.
struct Finding {
  std::string what;
  bool good = true;
  std::string detail;  ///< and, when it is not good, what to do
};

/// Returns what is to be said of a measured network.
std::vector<Finding> findings_of(const EchoReport& report);

/// Prints the findings as a table or, with --json, as a document together with `more`. failed: one is not good.
Exit show(const std::vector<Finding>& findings, nlohmann::json more, bool json, const Output& output);

}  // namespace weft::cli
