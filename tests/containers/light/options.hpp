#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "idl/bus/bus.hpp"

namespace weft::light {

/// Holds the settings of a process of light robots, which are called r1, r2, ...
struct Options {
  std::size_t first = 1;   ///< number of its first robot
  std::size_t robots = 1;  ///< of this process
  std::size_t fleet = 1;   ///< robots of all processes together: they stand evenly on the site
  double pace = 1.0;       ///< body seconds a second
  std::string site = "ring";
  std::uint64_t seed = 101;
  std::string state;    ///< directory; each robot has one of its own in it
  std::string records;  ///< directory
  std::string lines;  ///< directory: their teach lines are written there, and nothing else is done; empty: they live
  bus::Vendor vendor = bus::Vendor::fastdds;
  unsigned protocol = 0;  ///< 0: it lives; else it only greets as an agent that speaks that version alone
  unsigned domain = 0;
  std::string listen = "127.0.0.1";
  std::vector<std::string> servers = {"127.0.0.1"};
};

/// Says what to print, and the exit code: the command line asked for something to be printed, or was wrong.
struct Leave {
  int exit_code = 0;
  std::string text;
};

std::variant<Options, Leave> parse_options(int argc, const char* const* argv);

inline std::string name_of(std::size_t number) {
  return "r" + std::to_string(number);
}

}  // namespace weft::light
