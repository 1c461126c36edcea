#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "clients/evaluate/surroundings.hpp"
#include "core/result.hpp"

namespace weft::evaluate {

struct OdometryOptions {
  std::filesystem::path site;
  std::filesystem::path along;  ///< empty: as in FloorOptions
  std::string kind;             ///< one kind of floor; empty: all
  Seeds seeds{1, 3};
  double metres = 26.0;
  bool candidates = false;  ///< other ways to see motion too, on the first 8 m
  std::filesystem::path out;
};

namespace odometry {

/// Odometry alone, with its covariances: each drive is driven once and watched by the product with the camera as it
/// was calibrated and as it is given, at the site's frame rate and at reduced ones, and by the candidates. Writes
/// odometry.csv, prints the table. `cpu_s`: time that this thread has computed.
Result<Ended> study_odometry(const OdometryOptions& options, const Surroundings& around,
                             const std::function<double()>& cpu_s);

}  // namespace odometry
}  // namespace weft::evaluate
