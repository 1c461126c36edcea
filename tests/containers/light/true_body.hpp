#pragma once
#include <cstdint>
#include <memory>
#include <string>

#include "agents/bodies/body.hpp"
#include "core/geometry/pose2.hpp"
#include "core/result.hpp"
#include "tests/simulation/marks_body.hpp"

namespace weft::light {

/// Tells where a robot stood when its process ended, however that was.
struct Standing {
  std::uint64_t frame = 0;
  Pose2 site_from_robot;
};

/// Returns what the last whole line of a truth file says; `at_first` where there is none. corrupt: it is no such
/// line.
Result<Standing> last_standing(const std::string& file, const Standing& at_first);

/// Is a marks body that writes its truth (docs/formats/records.md), counts frames on from those of the process
/// before, and adds to each line what judges of a whole fleet need: `at`, seconds of the machine's monotonic clock,
/// `speed_m_s` and `hand`.
class TrueBody final : public agents::Body {
 public:
  /// unavailable: the file cannot be opened.
  static Result<std::unique_ptr<TrueBody>> make(std::unique_ptr<simulation::MarksBody> body, const std::string& file,
                                                const std::string& robot, std::uint64_t first_frame);
  TrueBody(const TrueBody&) = delete;
  TrueBody& operator=(const TrueBody&) = delete;
  ~TrueBody() override;

  Result<agents::Sample> step(const agents::Twist& command) override;
  Result<void> drive_by_hand(const std::vector<agents::SitePoint>& along) override {
    return body_->drive_by_hand(along);
  }
  void stop_hand() override { body_->stop_hand(); }
  agents::Rig rig() const override { return body_->rig(); }
  std::string kind() const override { return body_->kind(); }

 private:
  TrueBody(std::unique_ptr<simulation::MarksBody> body, int file, std::string robot, std::uint64_t first_frame)
      : body_(std::move(body)), file_(file), robot_(std::move(robot)), first_frame_(first_frame) {}

  std::unique_ptr<simulation::MarksBody> body_;
  int file_;
  std::string robot_;
  std::uint64_t first_frame_;
};

}  // namespace weft::light
