#include "agents/bodies/sim/truth.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

namespace weft::agents::sim {

namespace {

/// Writes a text as JSON has it.
std::string json_text(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (static_cast<unsigned char>(c) < 0x20U) {
      char code[16];
      std::snprintf(code, sizeof code, "\\u%04x", static_cast<unsigned>(c));
      out += code;
      continue;
    }
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

}  // namespace

Result<TruthFile> TruthFile::open(const std::string& path) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (file < 0) {
    return fail(ErrorCode::unavailable, "truth file " + path + ": " + std::strerror(errno));
  }
  return TruthFile(file, path);
}

TruthFile::TruthFile(TruthFile&& other) noexcept
    : file_(std::exchange(other.file_, -1)), path_(std::move(other.path_)) {}

TruthFile& TruthFile::operator=(TruthFile&& other) noexcept {
  std::swap(file_, other.file_);
  std::swap(path_, other.path_);
  return *this;
}

TruthFile::~TruthFile() {
  if (file_ >= 0) {
    ::close(file_);
  }
}

Result<void> TruthFile::write(const std::string& robot, std::uint64_t frame, double time_s, const Pose2& pose,
                              const std::optional<std::string>& touch) {
  char numbers[200];
  std::snprintf(numbers, sizeof numbers, "\",\"frame\":%llu,\"t\":%.6f,\"x\":%.6f,\"y\":%.6f,\"heading\":%.7f",
                static_cast<unsigned long long>(frame), time_s, pose.x, pose.y, pose.heading);
  std::string line = "{\"robot\":\"" + robot + numbers;
  if (touch) line += ",\"touch\":" + json_text(*touch);
  line += "}\n";
  // One write call: with O_APPEND lines of several robots in one file stay whole too.
  if (::write(file_, line.data(), line.size()) != static_cast<ssize_t>(line.size())) {
    return fail(ErrorCode::exhausted, "truth file " + path_ + ": " + std::strerror(errno));
  }
  return {};
}

}  // namespace weft::agents::sim
