#include "clients/evaluate/registration/pair_study.hpp"

#include <optional>

#include "agents/perception/clouds/ndt.hpp"
#include "agents/perception/clouds/pcl_check.hpp"
#include "clients/evaluate/files.hpp"
#include "clients/evaluate/registration/cloud_file.hpp"
#include "clients/evaluate/registration/pair_report.hpp"

namespace weft::evaluate::registration {
namespace {

constexpr int kRepeats = 3;  // the least processor time of them is reported

using Points = std::vector<Eigen::Vector3f>;

struct Pair {
  Points a;
  Points b;
  Pose3 guess;
  std::optional<Pose3> truth;
};

Result<Pair> read_pair(const RegisterOptions& options) {
  Pair pair;
  auto a = read_points(options.a);
  if (!a) return fail(a.error());
  auto b = read_points(options.b);
  if (!b) return fail(b.error());
  pair.a = std::move(*a);
  pair.b = std::move(*b);
  if (!options.guess.empty()) {
    const Result<Pose3> guess = parse_guess(options.guess);
    if (!guess) return fail(guess.error());
    pair.guess = *guess;
  }
  if (options.truth.empty()) return pair;
  const Result<std::string> text = read_text(options.truth, "pose");
  if (!text) return fail(text.error());
  const Result<Pose3> truth = parse_matrix(*text, options.truth.string());
  if (!truth) return fail(truth.error());
  pair.truth = *truth;
  return pair;
}

template <class Act>
Answer timed_answer(const std::string& name, int repeats, const std::function<double()>& processor_s, Act&& act) {
  Answer best;
  for (int at = 0; at < repeats; ++at) {
    const double began_s = processor_s();
    Answer answer = act();
    answer.name = name;
    answer.ms = 1e3 * (processor_s() - began_s);
    if (at == 0 || answer.ms < best.ms) best = answer;
  }
  return best;
}

Answer by_ndt(const Pair& pair) {
  const agents::NdtConfig config;
  const agents::NdtMap a = agents::ndt_map({pair.a}, config.cells);
  const agents::NdtMap b = agents::ndt_map({pair.b}, config.cells);
  const auto registered = register_from_guess(a, b, pair.guess, config);
  if (!registered) return {{}, std::nullopt, std::string(registered.error().reason), 0.0};
  return {{}, registered->a_from_b.a_from_b, {}, 0.0};
}

Answer by_pcl(const agents::pcl_check::Opinion& opinion) {
  return {{}, opinion.a_from_b, opinion.has_converged ? "" : "not converged", 0.0};
}

/// Returns the edge of the voxels that rivals' clouds are thinned with, as their manuals ask for: half of our finest
/// cells', or whole ones where a cloud is so sparse that ours begin with larger ones.
double rival_voxel_m(const Pair& pair) {
  const agents::NdtCellConfig config;
  const double ours_m = agents::ndt_map({pair.a}, config).levels.front().cell_m;
  return 0.5 * ours_m;
}

std::vector<Answer> all_answers(const Pair& pair, const std::function<double()>& processor_s) {
  const double voxel_m = rival_voxel_m(pair);
  const auto thinned = [&](const Points& points) {
    const auto means = agents::pcl_check::voxel_grid(points, voxel_m);
    return means ? *means : points;
  };
  std::vector<Answer> answers;
  answers.push_back(timed_answer("ours: D2D-NDT", kRepeats, processor_s, [&] { return by_ndt(pair); }));
  answers.push_back(timed_answer("PCL GICP", 1, processor_s, [&] {
    return by_pcl(agents::pcl_check::register_gicp(thinned(pair.a), thinned(pair.b), pair.guess, 10.0 * voxel_m));
  }));
  answers.push_back(timed_answer("PCL NDT", 1, processor_s, [&] {
    return by_pcl(agents::pcl_check::register_p2d_ndt(pair.a, thinned(pair.b), pair.guess, 10.0 * voxel_m));
  }));
  return answers;
}

}  // namespace

Result<Ended> study_pair(const RegisterOptions& options, const Surroundings& around,
                         const std::function<double()>& processor_s) {
  const Result<Pair> pair = read_pair(options);
  if (!pair) return fail(pair.error());
  const std::vector<Answer> answers = all_answers(*pair, processor_s);
  const PairReport report = compared(answers, pair->truth, {pair->a.size(), pair->b.size()});
  around.out << (options.json ? json_of(report) : table_of(report)) << std::flush;
  return report.is_met ? Ended::complete : Ended::missed;
}

}  // namespace weft::evaluate::registration
