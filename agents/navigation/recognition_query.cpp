#include "agents/navigation/recognition_query.hpp"

#include <cmath>
#include <utility>

namespace weft::agents {

namespace {

constexpr double moved_m = 0.25;
constexpr double moved_rad = 0.5;        // a camera that does not look straight down sees another floor
constexpr std::uint32_t patience = 300;  // samples
/// So long an open question waits for its answer while the robot moves on, in samples: who asks anew at each step is
/// never answered, and what looked like the place where it was says where to look now. Not so one for the places
/// behind those that were tried in vain.
constexpr std::uint32_t patience_moving = 90;

}  // namespace

void RecognitionQuery::advance(const Step& step) {
  asked_from_robot_ = asked_from_robot_ * planar(step.previous_from_current);
  ++samples_;
}

void RecognitionQuery::forget() {
  asked_.reset();
  is_open_ = false;
}

bool RecognitionQuery::is_due(bool has_places_to_try) const {
  if (!asked_) return true;
  const bool has_moved =
      asked_from_robot_.translation().norm() > moved_m || std::abs(asked_from_robot_.heading) > moved_rad;
  if (is_open_) return has_moved && (asked_->after > 0 || samples_ > patience_moving);
  return has_moved || (!has_places_to_try && samples_ > patience);
}

void RecognitionQuery::ask(Signature seen, std::string_view method, std::uint32_t content_format) {
  asked_ = Question{
      .number = ++number_, .seen = std::move(seen), .method = method, .content_format = content_format, .after = 0};
  is_open_ = true;
  asked_from_robot_ = {};
  samples_ = 0;
}

void RecognitionQuery::ask_on() {
  asked_->number = ++number_;
  asked_->after += static_cast<std::uint32_t>(last_answer_);
  is_open_ = true;
  samples_ = 0;
}

bool RecognitionQuery::answered(std::uint64_t number, std::size_t places) {
  if (!asked_ || !is_open_ || asked_->number != number) return false;
  is_open_ = false;
  last_answer_ = places;
  samples_ = 0;
  return true;
}

bool RecognitionQuery::is_stale() const {
  return asked_ && !is_open_ && samples_ > patience;
}

}  // namespace weft::agents
