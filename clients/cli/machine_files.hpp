#pragma once
#include <string>
#include <vector>

#include "core/result.hpp"

namespace weft::cli {

/// Holds a text of this machine for a bug report, or why it cannot be had.
struct MachineFile {
  std::string name;  ///< in the archive
  Result<std::string> text;
};

/// Reads the configurations below a folder (*.toml and *.conf), in the order of their names, and the files named
/// besides.
std::vector<MachineFile> read_settings(const std::string& folder, const std::vector<std::string>& more);
/// Reads the end of the journal of Weft's services on this machine, and the ends of the log files named.
std::vector<MachineFile> read_logs(const std::vector<std::string>& files);
/// Says what machine this is: its name, kernel and distribution.
std::string describe_machine();

}  // namespace weft::cli
