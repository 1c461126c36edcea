#include "clients/evaluate/odometry/rehearsal.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <system_error>

#include "agents/bodies/sim/sim_body.hpp"
#include "clients/evaluate/truth.hpp"

namespace weft::evaluate::odometry {
namespace {

using namespace agents;

Result<void> add_truth(const std::filesystem::path& file, std::vector<Observer>& observers) {
  const auto truth = read_truth(file);
  if (!truth) return fail(truth.error());
  for (Observer& observer : observers) {
    for (floor::Moment& moment : observer.trace().moments) {
      const auto found = truth->find(moment.frame);
      if (found == truth->end()) {
        return fail(ErrorCode::internal, file.string() + ": has no frame " + std::to_string(moment.frame) +
                                             "; is somebody else using it?");
      }
      moment.true_s = found->second.true_s;
      moment.site_from_robot = found->second.site_from_robot;
    }
  }
  return {};
}

Result<bool> lead_past(Body& body, const floor::Drive& drive, std::vector<Observer>& observers) {
  for (bool done = false; !done;) {
    if (drive.asked_to_stop()) return false;
    const Result<Sample> sample = body.step({});
    if (!sample) return fail(sample.error());
    for (Observer& observer : observers) observer.take(*sample);
    done = sample->hand_done;
  }
  return true;
}

}  // namespace

Result<bool> rehearse(const floor::Drive& drive, const std::vector<SitePoint>& line,
                      std::vector<Observer>& observers) {
  const std::filesystem::path truth = drive.body.truth_path.value_or("");
  std::error_code ignored;  // a file that cannot be removed cannot be appended to either, which is told
  std::filesystem::remove(truth, ignored);
  const Result<std::unique_ptr<Body>> body = sim::make_sim_body(drive.body);
  if (!body) return fail(body.error());
  if (const Result<void> led = (*body)->drive_by_hand(line); !led) return fail(led.error());
  const Result<bool> done = lead_past(**body, drive, observers);
  const Result<void> joined = done && *done ? add_truth(truth, observers) : Result<void>();
  std::filesystem::remove(truth, ignored);
  if (!joined) return fail(joined.error());
  return done;
}

}  // namespace weft::evaluate::odometry
