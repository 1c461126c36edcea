#include "server/eta/passing.hpp"

#include <chrono>
#include <utility>

namespace weft::server {
namespace {
using namespace std::chrono_literals;

/// Bounds how long nothing may be heard of a robot: it repeats itself every two seconds.
constexpr Duration kLongestSilence = 10s;

bool gets_on(msg::RoutePhase phase) {
  return phase == msg::RoutePhase::driving || phase == msg::RoutePhase::waiting || phase == msg::RoutePhase::arrived;
}

/// Returns where the place is in the route, the occurrence that is nearest to `about`; none: it is not.
std::optional<std::size_t> index_of(const Route& route, const PlaceId& place, std::size_t about) {
  const std::size_t count = route.places.size();
  for (std::size_t apart = 0; apart < count; ++apart) {
    if (apart <= about && about - apart < count && route.places[about - apart] == place) return about - apart;
    if (about + apart < count && route.places[about + apart] == place) return about + apart;
  }
  return std::nullopt;
}

}  // namespace

void Passing::on_report(const Route& route, std::uint32_t at, msg::RoutePhase phase, SteadyTime now, Speeds& speeds) {
  // A robot that takes the next version of its route says so before it knows where it is on it.
  if (phase == msg::RoutePhase::accepted || at >= route.places.size()) return;
  std::optional<std::size_t> from;
  if (last_ && now - last_->at <= kLongestSilence) from = index_of(route, last_->place, at);
  if (from && *from > at) return;
  if (!gets_on(phase) || !from) {
    end(speeds);
  } else if (*from == at && last_->waits) {
    if (!piece_ && at + 1U < route.places.size()) enter(piece_of(route.places[at], route.places[at + 1U]), speeds);
    pass_.wait_s += seconds(now - last_->at);
  } else {
    drive(route, *from, at, seconds(now - last_->at), speeds);
  }
  if (phase == msg::RoutePhase::arrived) return end(speeds);
  if (gets_on(phase)) last_ = {route.places[at], at, phase == msg::RoutePhase::waiting, now};
}

void Passing::drive(const Route& route, std::size_t from, std::size_t to, double drive_s, Speeds& speeds) {
  double length_m = 0.0;
  for (std::size_t hop = from; hop < to; ++hop) length_m += distance_m(route.relations[hop]);
  for (std::size_t hop = from; hop < to; ++hop) {
    enter(piece_of(route.places[hop], route.places[hop + 1]), speeds);
    const double hop_m = distance_m(route.relations[hop]);
    pass_.length_m += hop_m;
    pass_.drive_s += drive_s * (length_m > 0.0 ? hop_m / length_m : 1.0 / static_cast<double>(to - from));
  }
  if (from < to) return;
  if (!piece_ && to + 1 < route.places.size()) enter(piece_of(route.places[to], route.places[to + 1]), speeds);
  pass_.drive_s += drive_s;
}

void Passing::enter(const RunPiece& piece, Speeds& speeds) {
  if (piece_ == piece) return;
  if (piece_) speeds.add(*piece_, pass_);
  piece_ = piece;
  pass_ = {};
}

void Passing::end(Speeds& speeds) {
  if (piece_) speeds.add(*piece_, pass_);
  piece_.reset();
  pass_ = {};
  last_.reset();
}

std::size_t Passing::at(const Route& route) const {
  return last_ ? index_of(route, last_->place, last_->index).value_or(0) : 0;
}

}  // namespace weft::server
