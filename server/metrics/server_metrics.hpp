#pragma once
#include "process/metrics/metric.hpp"
#include "server/base/figures.hpp"

namespace weft::server {

/// Returns the metrics of a server and its fleet. A robot's series bear its name and its id, as two robots may have
/// one name.
process::Metrics server_metrics(const Figures& figures);

}  // namespace weft::server
