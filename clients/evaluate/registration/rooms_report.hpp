#pragma once
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "clients/evaluate/registration/trials.hpp"

namespace weft::evaluate::registration {

/// Sums up the trials of one kind of scene.
struct EdgeSummary {
  std::size_t edges = 0;
  std::size_t refused = 0;
  double along_ratio = 0.0;  ///< median error after by median before
  double across_ratio = 0.0;
  double heading_ratio = 0.0;
  double grown_share = 0.0;  ///< whose error grew by more than 1 cm
  double mean_nees = 0.0;    ///< 6 where covariances are right
};
EdgeSummary summary_of(const std::vector<Trial>& trials);

/// Holds the median and the worst over the seeds' summaries, number by number; counts are sums, in the median.
struct EdgeRow {
  EdgeSummary median;
  EdgeSummary worst;
};
EdgeRow over_seeds(const std::vector<EdgeSummary>& seeds);

/// Sums up stitches of one kind: errors of those that were not refused, and how many were, by reason.
struct Stitches {
  std::vector<double> metres;
  std::vector<double> degrees;
  std::map<std::string, std::size_t> refused;
  std::size_t all = 0;

  void add(const std::vector<Trial>& trials);
};

/// Holds what came of all trials, a row a kind of scene.
struct RoomsReport {
  struct Row {
    std::string_view scene;
    EdgeRow edges;
    Stitches stitches;
  };
  std::vector<Row> rows;

  /// Returns whether the bounds of row E1 hold: those of edges, and of all stitches.
  bool is_met() const;
};

std::string tables_of(const RoomsReport& report);
/// Returns one line of JSON: edges, stitches, asked, is_met; null for what is not finite.
std::string json_of(const RoomsReport& report);

}  // namespace weft::evaluate::registration
