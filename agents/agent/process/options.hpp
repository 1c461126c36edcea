#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "agents/agent/process/method_settings.hpp"
#include "agents/agent/process/program.hpp"
#include "core/config/config.hpp"
#include "core/result.hpp"
#include "idl/bus/bus.hpp"
#include "process/log_line.hpp"

namespace weft::agents {

/// Holds all settings of the process. A flag wins over the file, the file over the default.
struct Options {
  std::string name;
  std::string state;                 ///< directory
  std::vector<std::string> methods;  ///< one or more, each with sensors of its own; the first is taught first
  std::string body;

  std::vector<std::string> servers;
  bus::Vendor vendor{};
  unsigned domain = 0;
  std::string listen;

  std::string site;  ///< file
  std::uint64_t seed = 1;
  std::uint64_t day = 0;
  std::optional<std::string> floors;
  std::optional<std::string> hall;
  std::optional<std::string> truth;
  std::string recording;
  std::string camera;                      ///< of the recording, and of a camera file that has several
  std::optional<std::string> calibration;  ///< camera file that replaces what the body says of its camera
  std::optional<Pose3> mount;              ///< what is believed of it while it is being calibrated; no flag

  process::LogFormat log_format = process::LogFormat::text;
  std::uint16_t metrics = 0;  ///< port of this machine at which metrics are served; 0: they are not
  bool asks_health = false;   ///< of the agent that works in the state directory; nothing else is done

  std::optional<std::string> records;
  double pace = 1.0;  ///< simulated seconds a second at most; 0: no bound
  double footprint_radius_m = 0.4;
  std::uint32_t window_hops = 25;
  std::uint32_t window_cap = 2000;
  std::uint64_t content_cache_mb = 256;
  std::uint64_t bytes_per_second = 0;
  MethodSettings settings;                 ///< of every method, used or not
  NavigationConfig navigation;             ///< of all methods together: the file's table [navigation]
  std::vector<config::Setting> effective;  ///< for the log
};

/// Says what to print, and the exit code: the command line asked for something to be printed, or was wrong.
struct Leave {
  int exit_code = 0;
  std::string text;
};

/// Reads flags and file. Those of a body that the program has not are refused, and the program is named that has it.
std::variant<Options, Leave> parse_options(const Program& program, int argc, const char* const* argv);

}  // namespace weft::agents
