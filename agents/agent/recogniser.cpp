#include "agents/agent/recogniser.hpp"

#include <algorithm>
#include <chrono>

namespace weft::agents {
namespace {
using namespace std::chrono_literals;

constexpr std::uint32_t kProposals = 64;  ///< contents of the floor method: 1.5 MB, a third of a second
constexpr Duration kBetweenQuestions = 1s;
constexpr Duration kLongestWait = 8s;
}  // namespace

void Recogniser::want(const Question* open, SteadyTime now) {
  if (open == nullptr) return open_.reset();
  if (open_.has_value() && open_->number == open->number) return;
  open_ = *open;
  ++request_;
  wait_ = kBetweenQuestions;
  ask_at_ = std::max(now, last_asked_ + kBetweenQuestions);
}

std::optional<msg::Recognise> Recogniser::due(SteadyTime now) {
  if (!open_.has_value() || now < ask_at_) return std::nullopt;
  last_asked_ = now;
  ask_at_ = now + wait_;
  wait_ = std::min(2 * wait_, Duration(kLongestWait));
  msg::Recognise question;
  question.request = request_;
  question.method = open_->method;
  question.content_format = open_->content_format;
  question.seen = open_->seen;
  question.most = kProposals;
  question.after = std::min(open_->after, static_cast<std::uint32_t>(msg::kRecognisedRank));
  return question;
}

std::optional<SteadyTime> Recogniser::next() const {
  return open_.has_value() ? std::optional(ask_at_) : std::nullopt;
}

void Recogniser::server_restarted(SteadyTime now) {
  wait_ = kBetweenQuestions;
  ask_at_ = now;
}

std::optional<Recogniser::Heard> Recogniser::on_answer(const msg::Recognised& answer) {
  if (!open_.has_value() || answer.request != request_) return std::nullopt;
  Heard heard{.question = open_->number, .places = answer.places, .note = {}};
  open_.reset();
  if (answer.outcome != msg::Outcome::done) {
    among_.clear();
    heard.places.clear();
    heard.note = "the server proposes no places: " + answer.message;
    return heard;
  }
  among_ = "of " + std::to_string(answer.signed_places);
  if (answer.unsigned_places > 0) {
    among_ += " (" + std::to_string(answer.unsigned_places) + " more are not signed yet)";
  }
  heard.note = std::to_string(heard.places.size()) + " places look like what it sees, " + among_;
  return heard;
}

}  // namespace weft::agents
