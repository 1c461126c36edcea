#include "clients/evaluate/registration/rooms_study.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "agents/perception/robust.hpp"
#include "clients/evaluate/table.hpp"

namespace weft::evaluate::registration {
namespace {

constexpr double kGrownM = 0.01;
constexpr std::array kKinds = {SceneKind::room, SceneKind::aisle, SceneKind::plain};

/// Bounds row E1: of the median over seeds, and of the worst.
struct EdgeBounds {
  double across;
  double along;
  double grown;
};
constexpr EdgeBounds kMedian{0.8, 1.05, 0.03};
constexpr EdgeBounds kWorst{1.0, 1.1, 0.06};
constexpr double kStitchM = 0.04, kStitchDegrees = 0.5, kWorstStitchM = 0.08, kWorstStitchDegrees = 1.0;

struct MedianWorst {
  double median = std::numeric_limits<double>::quiet_NaN();
  double worst = std::numeric_limits<double>::quiet_NaN();
};
/// Returns median and largest; NaN without values.
MedianWorst median_and_worst(const std::vector<double>& values) {
  if (values.empty()) return {};
  return {agents::median_of(values), *std::max_element(values.begin(), values.end())};
}

double ratio(const std::vector<Trial>& trials, double Off::*of) {
  std::vector<double> before;
  std::vector<double> after;
  for (const Trial& trial : trials) {
    before.push_back(trial.before.*of);
    after.push_back(trial.after.*of);
  }
  return agents::median_of(after) / agents::median_of(before);
}

struct EdgeRow {
  EdgeSummary median;
  EdgeSummary worst;
};

/// Returns median and worst over the seeds' summaries.
EdgeRow over_seeds(const std::vector<EdgeSummary>& seeds) {
  EdgeRow row;
  for (const auto of : {&EdgeSummary::along_ratio, &EdgeSummary::across_ratio, &EdgeSummary::heading_ratio,
                        &EdgeSummary::grown_share, &EdgeSummary::mean_nees}) {
    std::vector<double> values;
    for (const EdgeSummary& summary : seeds) values.push_back(summary.*of);
    const auto both = median_and_worst(values);
    row.median.*of = both.median;
    row.worst.*of = both.worst;
  }
  for (const EdgeSummary& summary : seeds) {
    row.median.edges += summary.edges;
    row.median.refused += summary.refused;
  }
  return row;
}

bool is_within(const EdgeSummary& summary, const EdgeBounds& bounds) {
  return summary.across_ratio <= bounds.across && summary.along_ratio <= bounds.along &&
         summary.grown_share <= bounds.grown;
}

std::string pair_of(double median, double worst, int digits) {
  return cell(median, digits) + " / " + cell(worst, digits);
}

/// Sums up stitches of one kind: errors of those that were not refused, and how many were, by reason.
struct Stitches {
  std::vector<double> metres;
  std::vector<double> degrees;
  std::map<std::string, std::size_t> refused;
  std::size_t all = 0;

  void add(const std::vector<Trial>& trials) {
    for (const Trial& trial : trials) {
      ++all;
      if (!trial.refused.empty()) {
        ++refused[trial.refused];
        continue;
      }
      metres.push_back(trial.after.metres());
      degrees.push_back(kDegrees * trial.after.heading_rad);
    }
  }
  std::vector<std::string> row(std::string_view kind) const {
    std::string reasons;
    for (const auto& [reason, times] : refused) reasons += reason + " " + std::to_string(times) + " ";
    const auto m = median_and_worst(metres);
    const auto deg = median_and_worst(degrees);
    return {std::string(kind),
            std::to_string(all),
            std::to_string(metres.size()),
            pair_of(m.median, m.worst, 3),
            pair_of(deg.median, deg.worst, 2),
            reasons};
  }
  bool is_within() const {
    if (metres.empty()) return true;
    const auto m = median_and_worst(metres);
    const auto deg = median_and_worst(degrees);
    return m.median <= kStitchM && m.worst <= kWorstStitchM && deg.median <= kStitchDegrees &&
           deg.worst <= kWorstStitchDegrees;
  }
};

}  // namespace

EdgeSummary summary_of(const std::vector<Trial>& trials) {
  EdgeSummary summary;
  if (trials.empty()) return summary;
  summary.edges = trials.size();
  summary.along_ratio = ratio(trials, &Off::along_m);
  summary.across_ratio = ratio(trials, &Off::across_m);
  summary.heading_ratio = ratio(trials, &Off::heading_rad);
  double grown = 0.0;
  double nees = 0.0;
  for (const Trial& trial : trials) {
    grown += trial.after.metres() > trial.before.metres() + kGrownM ? 1.0 : 0.0;
    summary.refused += trial.refused.empty() ? 0U : 1U;
    nees += trial.nees;
  }
  summary.grown_share = grown / static_cast<double>(trials.size());
  summary.mean_nees = nees / std::max(1.0, static_cast<double>(trials.size() - summary.refused));
  return summary;
}

Result<Ended> study_rooms(const RegisterRoomsOptions& options, const Surroundings& around) {
  const agents::NdtConfig& config = options.config;
  std::vector<std::vector<std::string>> edges = {
      {"scene", "edges", "refused", "across after / before", "along", "heading", "grew by > 1 cm", "NEES (6)"}};
  std::vector<std::vector<std::string>> stitches = {
      {"scene", "stitches", "joined", "off m", "off degrees", "refused"}};
  bool is_met = true;
  for (const SceneKind kind : kKinds) {
    std::vector<EdgeSummary> seeds;
    Stitches joined;
    for (std::uint64_t seed = options.seeds.first; seed <= options.seeds.last; ++seed) {
      if (around.asked_to_stop()) return Ended::stopped;
      seeds.push_back(summary_of(edge_trials(kind, seed, EdgePrior{}, config)));
      joined.add(stitch_trials(kind, seed, StitchGuess{}, config));
      around.progress << '\r' << name_of(kind) << " seed " << seed << std::flush;
    }
    around.progress << '\n';
    const EdgeRow row = over_seeds(seeds);
    edges.push_back({std::string(name_of(kind)), std::to_string(row.median.edges), std::to_string(row.median.refused),
                     pair_of(row.median.across_ratio, row.worst.across_ratio, 2),
                     pair_of(row.median.along_ratio, row.worst.along_ratio, 2),
                     pair_of(row.median.heading_ratio, row.worst.heading_ratio, 2),
                     pair_of(row.median.grown_share, row.worst.grown_share, 3),
                     pair_of(row.median.mean_nees, row.worst.mean_nees, 1)});
    stitches.push_back(joined.row(name_of(kind)));
    is_met = is_met && is_within(row.median, kMedian) && is_within(row.worst, kWorst) && joined.is_within();
  }
  around.out
      << "Edges with their prior, median / worst seed\n"
      << markdown_table(edges, 1) << "\nStitches from a guess, median / worst of all\n"
      << markdown_table(stitches, 1) << (is_met ? "met" : "NOT MET")
      << ": row E1 (edges: across <= 0.8 / 1, along <= 1.05 / 1.1, grew <= 0.03 / 0.06; stitches: 0.04 / 0.08 m, "
         "0.5 / 1 degree)\n"
      << std::flush;
  return is_met ? Ended::complete : Ended::missed;
}

}  // namespace weft::evaluate::registration
