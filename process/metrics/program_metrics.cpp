#include "process/metrics/program_metrics.hpp"

#include <utility>

namespace weft::process {

Metrics program_metrics(const ProgramFigures& figures) {
  Metric build = gauge("weft_build_info", "1, with which program, version and DDS vendor this is", 1.0);
  build.series.front().labels = {
      {"program", figures.program}, {"version", figures.version}, {"vendor", figures.vendor}};
  return {std::move(build),
          gauge("weft_healthy", "1 while the program does its work, 0 while it cannot; as its --health says",
                figures.is_well ? 1.0 : 0.0),
          counter("weft_away_seconds_total",
                  "Time in which the program was away from its inbox for more than a second at once", figures.away_s),
          histogram("weft_handle_seconds", "How long messages took to handle", figures.handled),
          histogram("weft_tick_seconds", "How long turns took of what is due by the clock", figures.ticked)};
}

}  // namespace weft::process
