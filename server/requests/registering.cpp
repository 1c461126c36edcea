#include "server/requests/registering.hpp"

#include <chrono>
#include <memory>

#include "server/base/outcome.hpp"
#include "server/site/site_frames.hpp"

namespace weft::server {
namespace {
using namespace std::chrono_literals;

constexpr Duration kBetweenRegisteringPieces = 1ms;
constexpr std::size_t kMostRegistering = 16;

msg::OperatorReply not_registered(const Error& error) {
  msg::OperatorReply reply;
  reply.outcome = outcome_of(error);
  reply.message = clipped(error.message);
  return reply;
}

}  // namespace

std::optional<msg::OperatorReply> Registering::begin(const Key& key, const msg::OperatorRequest& request,
                                                     const std::string& who, Now now) {
  if (const Result<Edit> edit = editor_.edit_for(request); !edit) return not_registered(edit.error());
  if (waiting_.size() >= kMostRegistering) {
    return not_registered({ErrorCode::refused, std::to_string(kMostRegistering) +
                                                   " registrations are being worked out already: ask again"});
  }
  if (waiting_.empty()) next_piece_ = now.steady;
  waiting_.push_back({key, request, who, {}});
  return std::nullopt;
}

Registering::Replies Registering::tick(Now now) {
  Replies replies;
  if (waiting_.empty() || now.steady < next_piece_) return replies;
  next_piece_ = now.steady + kBetweenRegisteringPieces;
  Waiting& first = waiting_.front();
  if (!first.solver) {
    first.solver.emplace(view_of(context_.snapshots.shared_current()), first.request.registration);
    return replies;
  }
  if (first.solver->step(kWaysOfSitePiece)) return replies;
  replies.emplace_back(first.key, finish(first, first.solver->take(), now));
  waiting_.pop_front();
  return replies;
}

msg::OperatorReply Registering::finish(const Waiting& asked, const SiteSolution& solution, Now now) {
  if (!solution.problem.empty()) {
    return not_registered({ErrorCode::refused, "plan " + solution.registration.plan + ": " + solution.problem});
  }
  msg::OperatorReply reply = editor_.on_request(asked.request, asked.who, now);
  if (reply.outcome != msg::Outcome::done) return reply;
  const std::size_t all = context_.snapshots.current().place_count();
  const std::size_t on_plan = solution.layout_from_place.size();
  reply.message += "; " + to_text(solution) + "; " + std::to_string(on_plan) + " of " + std::to_string(all) +
                   " places lie on the plan";
  if (on_plan < all) reply.message += ", those of parts without picks do not";
  reply.message = clipped(reply.message);
  return reply;
}

}  // namespace weft::server
