#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "clients/evaluate/odometry/observer.hpp"

namespace weft::evaluate::odometry {

/// Names the drive as taught at the site's frame rate; below, the product as an observer of it.
inline constexpr const char* kMappingDrive = "mapping";
inline constexpr const char* kCalibrated = "weft, calibrated";
inline constexpr const char* kAsGiven = "weft, as given";

/// Holds what one observer made of one drive.
struct Row {
  std::string kind;
  std::uint64_t seed = 0;
  std::string drive;
  std::string observer;
  double speed_percent = 0.0;   ///< over five frames, as in the study of floors
  double drift_mm = 0.0;        ///< RMS over stretches of 1 m
  double drift_deg = 0.0;       ///< likewise
  double blind_percent = 0.0;   ///< of the samples after the first
  double ms_a_view = 0.0;       ///< of a core
  std::vector<double> over_1m;  ///< squared Mahalanobis distances of stretches
  std::vector<double> over_10m;
};
Row row_of(const std::string& kind, std::uint64_t seed, const std::string& drive, const Observer& observer);

/// Returns the rows as CSV, a line each.
std::string csv_of(const std::vector<Row>& rows);
/// Returns a line for each drive and observer, over all kinds and seeds; then the same with its kinds apart.
std::string table_of(const std::vector<Row>& rows);

}  // namespace weft::evaluate::odometry
