#include "server/traffic/watches.hpp"

#include <utility>

namespace weft::server {

void Watches::watch(const RobotId& waiter, const Touched& needs, const std::set<RobotId>& holders) {
  forget(waiter);
  waits_[waiter] = {needs, holders};
  for (const RobotId& holder : holders) waiters_[holder].insert(waiter);
}

void Watches::watch_everybody(const RobotId& waiter) {
  watch(waiter, {}, {});
  for_everybody_.insert(waiter);
}

void Watches::watch_map(const RobotId& waiter) {
  watch(waiter, {}, {});
}

void Watches::forget(const RobotId& waiter) {
  for_everybody_.erase(waiter);
  woken_.erase(waiter);
  const auto known = waits_.find(waiter);
  if (known == waits_.end()) return;
  for (const RobotId& holder : known->second.holders) {
    const auto of_holder = waiters_.find(holder);
    of_holder->second.erase(waiter);
    if (of_holder->second.empty()) waiters_.erase(of_holder);
  }
  waits_.erase(known);
}

std::vector<Watches::Watch> Watches::on(const RobotId& holder) const {
  std::vector<Watch> watches;
  const auto known = waiters_.find(holder);
  if (known == waiters_.end()) return watches;
  for (const RobotId& waiter : known->second) watches.push_back({waiter, waits_.at(waiter).needs});
  return watches;
}

void Watches::wake(const RobotId& waiter) {
  if (!waits_.contains(waiter)) return;
  forget(waiter);
  woken_.insert(waiter);
}

void Watches::wake_those_for_everybody() {
  const std::set<RobotId> waiters = for_everybody_;
  for (const RobotId& waiter : waiters) wake(waiter);
}

void Watches::wake_all() {
  for (const auto& [waiter, waits] : waits_) woken_.insert(waiter);
  waits_.clear();
  waiters_.clear();
  for_everybody_.clear();
}

std::set<RobotId> Watches::take_woken() {
  return std::exchange(woken_, {});
}

}  // namespace weft::server
