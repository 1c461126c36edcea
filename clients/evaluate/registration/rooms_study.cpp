#include "clients/evaluate/registration/rooms_study.hpp"

#include <array>

#include "clients/evaluate/registration/rooms_report.hpp"

namespace weft::evaluate::registration {
namespace {

constexpr std::array kKinds = {SceneKind::room, SceneKind::aisle, SceneKind::plain};

}  // namespace

Result<Ended> study_rooms(const RegisterRoomsOptions& options, const Surroundings& around) {
  const agents::NdtConfig& config = options.config;
  RoomsReport report;
  for (const SceneKind kind : kKinds) {
    std::vector<EdgeSummary> seeds;
    RoomsReport::Row row{name_of(kind), {}, {}};
    for (std::uint64_t seed = options.seeds.first; seed <= options.seeds.last; ++seed) {
      if (around.asked_to_stop()) return Ended::stopped;
      seeds.push_back(summary_of(edge_trials(kind, seed, EdgePrior{}, config)));
      row.stitches.add(stitch_trials(kind, seed, StitchGuess{}, config));
      around.progress << '\r' << name_of(kind) << " seed " << seed << std::flush;
    }
    around.progress << '\n';
    row.edges = over_seeds(seeds);
    report.rows.push_back(row);
  }
  around.out << (options.json ? json_of(report) : tables_of(report)) << std::flush;
  return report.is_met() ? Ended::complete : Ended::missed;
}

}  // namespace weft::evaluate::registration
