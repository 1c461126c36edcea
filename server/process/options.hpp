#pragma once
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "core/config/config.hpp"
#include "core/result.hpp"
#include "idl/bus/bus.hpp"
#include "process/log_line.hpp"
#include "server/base/config.hpp"

namespace weft::server {

/// Holds all settings of the process. A flag wins over the file, the file over the default.
struct Options {
  std::string store;
  std::string name;
  bus::Vendor vendor{};
  unsigned domain = 0;
  std::string listen;
  unsigned index = 0;
  double handling_s = 0.0;
  double robot_silent_after_s = 0.0;
  Unjoined unjoined = Unjoined::warn;
  SilentGoal silent_goal = SilentGoal::hand_over;
  double silent_goal_after_s = 0.0;
  ChargeLevels charge;
  process::LogFormat log_format = process::LogFormat::text;
  std::uint16_t metrics = 0;               ///< port of this machine at which metrics are served; 0: they are not
  bool asks_health = false;                ///< of the server that works in the store; nothing else is done
  std::vector<config::Setting> effective;  ///< for the log
};

/// Tells that the command line asked for something to be printed, or was wrong: what to print, and the exit code.
struct Leave {
  int exit_code = 0;
  std::string text;
};

std::variant<Options, Leave> parse_options(int argc, const char* const* argv);

}  // namespace weft::server
