#include "clients/evaluate/floor/foretold.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <system_error>
#include <utility>

#include "agents/methods/floor/floor.hpp"
#include "agents/navigation/agreement.hpp"
#include "agents/navigation/belief.hpp"
#include "clients/evaluate/truth.hpp"
#include "core/random.hpp"

namespace weft::evaluate::floor {
namespace {

using namespace agents;

/// Holds a view of the other robot.
struct Glance {
  OrRefusal<FloorContent> content;
  Pose2 site_from_robot;
};

struct Glances {
  std::optional<Floor> method;
  std::map<std::uint64_t, Glance> by_frame;
};

/// Keeps every sixth view, about as far apart as a robot looks where it is. Returns false when it was stopped.
Result<bool> look_around(const Drive& drive, const std::vector<SitePoint>& line, Glances& glances) {
  constexpr std::uint64_t every = 6;
  const std::filesystem::path truth_file = drive.body.truth_path.value_or("");
  std::error_code ignored;
  std::filesystem::remove(truth_file, ignored);
  const Result<std::unique_ptr<Body>> body = sim::make_sim_body(drive.body);
  if (!body) return fail(body.error());
  Result<Floor> method = Floor::make(FloorConfig{}, (*body)->rig().camera());
  if (!method) return fail(method.error());
  glances.method = std::move(*method);
  if (const Result<void> led = (*body)->drive_by_hand(line); !led) return fail(led.error());
  Floor::Odometry odometry;
  for (bool done = false; !done;) {
    if (drive.asked_to_stop()) return false;
    const Result<Sample> sample = (*body)->step({});
    if (!sample) return fail(sample.error());
    const View* const view = sample->of({});
    glances.method->observe(odometry, view, sample->motion);
    if (view != nullptr && sample->frame % every == 0)
      glances.by_frame.emplace(sample->frame, Glance{glances.method->extract(odometry, *view), {}});
    done = sample->hand_done;
  }
  const auto truth = read_truth(truth_file);
  if (!truth) return fail(truth.error());
  for (auto& [frame, glance] : glances.by_frame) {
    const auto found = truth->find(frame);
    if (found == truth->end())
      return fail(ErrorCode::internal, truth_file.string() + ": has no frame " + std::to_string(frame));
    glance.site_from_robot = found->second.site_from_robot;
  }
  std::filesystem::remove(truth_file, ignored);
  return true;
}

/// Returns the view nearest to the place, turns counted. Null: none within half a metre.
const Glance* nearest(const Glances& glances, const Pose2& site_from_place) {
  constexpr double metre_a_radian = 0.5;
  const Glance* best = nullptr;
  double least = 0.5;
  for (const auto& [frame, glance] : glances.by_frame) {
    const Pose2 apart = site_from_place.inverse() * glance.site_from_robot;
    const double distance = apart.translation().norm() + metre_a_radian * std::abs(apart.heading);
    if (distance >= least) continue;
    least = distance;
    best = &glance;
  }
  return best;
}

bool is_found(const Floor& method, const FloorContent& place, const Glance& glance, const Pose2& place_from_robot,
              const StitchConfig& config, Random random) {
  constexpr double off_m = 0.03;
  constexpr double off_rad = 0.02;
  if (!glance.content) return false;
  const Pose2 off{random.normal(0.0, off_m), random.normal(0.0, off_m), random.normal(0.0, off_rad)};
  const Relation guess = with_noise(Metric2{place_from_robot * off}, off_m, off_rad);
  const OrRefusal<Related> related = method.relate(place, *glance.content, guess);
  return related && !agreement(Metric2{place_from_robot}, related->a_from_b, config.agree_m, config.agree_rad);
}

}  // namespace

const std::string& light_of(Floor::Condition condition) {
  static const std::array<std::string, Floor::conditions.size()> names = {"same", "halved", "dirt"};
  return names[condition];
}

Result<std::optional<std::vector<Compared>>> compare(const Scenario& scenario, Floor::Condition condition,
                                                     const Taught& taught, const StitchConfig& config) {
  const Result<Drive> drive = scenario.second(light_of(condition));
  if (!drive) return fail(drive.error());
  Glances glances;
  const Result<bool> looked = look_around(*drive, scenario.line(), glances);
  if (!looked) return fail(looked.error());
  if (!*looked) return std::optional<std::vector<Compared>>();
  std::vector<Compared> all;
  for (const TaughtPlace& place : taught.way.places) {
    const Pose2& site_from_place = taught.places.site_from_place.at(place.id);
    const Glance* const glance = nearest(glances, site_from_place);
    if (!place.trials || glance == nullptr) continue;
    const Place* const stored = taught.map.view().window.place(place.id);
    const auto bytes = taught.map.find(stored->content.hash);
    const Result<FloorContent> content = glances.method->decode(*bytes);
    if (!content) return fail(content.error());
    const Pose2 place_from_robot = site_from_place.inverse() * glance->site_from_robot;
    const bool found = is_found(*glances.method, *content, *glance, place_from_robot, config, Random(place.id.index));
    all.push_back({place.at_m, (*place.trials)[condition].found, found});
  }
  return std::optional(std::move(all));
}

Agreement agreement_of(const std::vector<Compared>& compared) {
  struct Counts {
    double places = 0.0, foretold = 0.0, found = 0.0;
  };
  std::map<std::int64_t, Counts> metres;
  Counts all;
  for (const Compared& place : compared) {
    for (Counts* const counts : {&all, &metres[static_cast<std::int64_t>(std::floor(place.at_m))]}) {
      counts->places += 1.0;
      counts->foretold += place.foretold ? 1.0 : 0.0;
      counts->found += place.found ? 1.0 : 0.0;
    }
  }
  Agreement agreement;
  if (compared.empty()) return agreement;
  agreement.places = compared.size();
  agreement.foretold = all.foretold / all.places;
  agreement.found = all.found / all.places;
  for (const auto& [metre, counts] : metres)
    agreement.metre_apart += std::abs(counts.foretold - counts.found) / counts.places;
  agreement.metre_apart /= static_cast<double>(metres.size());
  return agreement;
}

}  // namespace weft::evaluate::floor
