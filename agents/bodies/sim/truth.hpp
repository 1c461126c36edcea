#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/geometry/pose2.hpp"
#include "core/result.hpp"

namespace weft::agents::sim {

/// Writes a file of where the robot really was, for a judge: one JSON line a frame. Each line goes to the system
/// whole and at once, so that a killed process leaves whole lines.
class TruthFile {
 public:
  /// Opens a file to append to. unavailable: cannot be opened.
  static Result<TruthFile> open(const std::string& path);
  TruthFile(TruthFile&& other) noexcept;
  TruthFile& operator=(TruthFile&& other) noexcept;
  TruthFile(const TruthFile&) = delete;
  TruthFile& operator=(const TruthFile&) = delete;
  ~TruthFile();

  /// Appends a line; s, and metres and radians, site frame; `touch`: the name of what it has touched since the line
  /// before. exhausted: cannot be written (the disk is full).
  Result<void> write(const std::string& robot, std::uint64_t frame, double time_s, const Pose2& site_from_robot,
                     const std::optional<std::string>& touch);

 private:
  TruthFile(int file, std::string path) : file_(file), path_(std::move(path)) {}
  int file_ = -1;
  std::string path_;
};

}  // namespace weft::agents::sim
