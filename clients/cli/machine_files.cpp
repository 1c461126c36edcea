#include "clients/cli/machine_files.hpp"

#include <sys/utsname.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>

#include "clients/cli/files.hpp"

namespace weft::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostOfLog = 4ULL << 20U;  ///< bytes from its end
constexpr const char* kJournal =
    "timeout 20 journalctl --no-pager --quiet --utc --output=short-iso-precise --lines=5000 --unit='weft-*' 2>&1";

/// Returns a name for the archive: the path without what leads out of it.
std::string archived(const std::string& folder, const std::string& path) {
  std::string name = fs::absolute(path).lexically_normal().relative_path().generic_string();
  constexpr std::size_t longest = 60;
  if (name.size() > longest) name = name.substr(name.size() - longest);
  return folder + "/" + name;
}

/// Returns the end of the file, from the beginning of a line.
Result<std::string> tail_of(const std::string& file) {
  std::error_code failed;
  if (!fs::is_regular_file(file, failed)) return fail(ErrorCode::not_found, file + ": is no file that can be read");
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  if (!in) return fail(ErrorCode::unavailable, file + ": cannot be opened: may this user read it?");
  const auto size = static_cast<std::size_t>(in.tellg());
  const std::size_t from = size > kMostOfLog ? size - kMostOfLog : 0;
  in.seekg(static_cast<std::streamoff>(from));
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (from > 0) text.erase(0, text.find('\n') + 1);
  return text;
}

struct EndOfPipe {
  void operator()(std::FILE* pipe) const { std::ignore = pclose(pipe); }
};

Result<std::string> journal() {
  std::unique_ptr<std::FILE, EndOfPipe> pipe(popen(kJournal, "r"));
  if (pipe == nullptr) return fail(ErrorCode::unavailable, "journalctl cannot be started");
  std::string text;
  std::array<char, 1U << 16U> piece{};
  for (std::size_t got = 1; got > 0;) {
    got = std::fread(piece.data(), 1, piece.size(), pipe.get());
    if (text.size() < 4 * kMostOfLog) text.append(piece.data(), got);
  }
  const int ended = pclose(pipe.release());
  if (ended != 0) return fail(ErrorCode::unavailable, "the journal cannot be read here: " + text.substr(0, 200));
  if (text.empty()) {
    return fail(ErrorCode::not_found,
                "the journal has nothing of weft-* that this user may read; if its services run "
                "on this machine, ask as root");
  }
  return text;
}

}  // namespace

std::vector<MachineFile> read_settings(const std::string& folder, const std::vector<std::string>& more) {
  std::vector<std::string> paths;
  std::error_code failed;
  std::vector<MachineFile> files;
  for (fs::recursive_directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed)) {
    const std::string ending = at->path().extension().string();
    if (ending == ".toml" || ending == ".conf") paths.push_back(at->path().string());
  }
  if (failed) {
    files.push_back({"settings", fail(ErrorCode::unavailable,
                                      folder + ": " + failed.message() + "; name configurations with --settings")});
  }
  std::ranges::sort(paths);
  paths.insert(paths.end(), more.begin(), more.end());
  for (const std::string& path : paths) files.push_back({archived("settings", path), tail_of(path)});
  return files;
}

std::vector<MachineFile> read_logs(const std::vector<std::string>& paths) {
  std::vector<MachineFile> files;
  files.push_back({"logs/journal.log", journal()});
  for (const std::string& path : paths) files.push_back({archived("logs", path), tail_of(path)});
  return files;
}

std::string describe_machine() {
  struct utsname names {};
  std::string text;
  if (::uname(&names) == 0) {
    text = std::string("host ") + names.nodename + "\nkernel " + names.sysname + " " + names.release + " " +
           names.machine + "\n";
  }
  const Result<std::string> distribution = read_text("/etc/os-release");
  return distribution ? text + *distribution : text;
}

}  // namespace weft::cli
