#pragma once
#include "idl/bus/link.hpp"
#include "process/metrics/metric.hpp"

namespace weft::process {

/// Returns the metrics of a program's link, as counted so far: messages and bytes by topic, what was refused by its
/// reason, queue, peers, and whether the link is open. For the link's own thread.
Metrics link_metrics(bus::Link& link);

}  // namespace weft::process
