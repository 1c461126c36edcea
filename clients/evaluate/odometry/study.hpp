#pragma once
#include <functional>

#include "clients/evaluate/floor/subject.hpp"
#include "clients/evaluate/surroundings.hpp"
#include "core/result.hpp"

namespace weft::evaluate {

struct OdometryOptions : FloorOptions {
  bool candidates = false;  ///< other ways to see motion too, on the first 8 m
  bool regions = false;     ///< only what the 95 % regions are judged by: mapping at the site's frame rate
};

namespace odometry {

/// Studies odometry alone, with its covariances: each drive is driven once and watched by the product with the camera
/// as calibrated and as given, at the site's frame rate and at reduced ones, and by the candidates. Writes
/// odometry.json and odometry.csv after each floor and seed, goes on where these end, prints the table and how often
/// regions hold. The options' light is not looked at: each drive has its own. `cpu_s`: time that this thread has
/// computed. not_found, invalid: site, line or floor; unavailable: the folder cannot be written.
Result<Ended> study_odometry(const OdometryOptions& options, const Surroundings& around,
                             const std::function<double()>& cpu_s);

}  // namespace odometry
}  // namespace weft::evaluate
