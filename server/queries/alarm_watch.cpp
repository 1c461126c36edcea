#include "server/queries/alarm_watch.hpp"

#include "server/queries/alarms.hpp"

namespace weft::server {

std::vector<msg::Alarm> AlarmWatch::seen(std::vector<msg::Alarm> alarms, const Counters& counters, Now now) {
  count(counters, now);
  if (std::optional<msg::Alarm> more = refused(now)) alarms.push_back(*std::move(more));
  std::map<Key, WallTime> since;
  for (msg::Alarm& alarm : alarms) {
    const Key key{alarm.kind, alarm.robot};
    const auto known = since_.find(key);
    if (alarm.since == WallTime{}) alarm.since = known != since_.end() ? known->second : now.wall;
    since.try_emplace(key, alarm.since);
  }
  since_ = std::move(since);
  return alarms;
}

void AlarmWatch::count(const Counters& counters, Now now) {
  if (refused_ && now.steady - refused_->last >= msg::kRefusedLately) refused_.reset();
  for (const auto& [name, times] : counters) {
    if (!counts_refused(name)) continue;
    std::uint64_t& known = counted_[name];
    if (times <= known) continue;
    if (!refused_) refused_ = Refused{.since = now.wall, .last = {}, .reason = {}, .times = 0};
    refused_->last = now.steady;
    refused_->reason = name;
    refused_->times += times - known;
    known = times;
  }
}

std::optional<msg::Alarm> AlarmWatch::refused(Now now) const {
  if (!refused_) return std::nullopt;
  const auto ago = std::chrono::duration_cast<std::chrono::seconds>(now.steady - refused_->last).count();
  return msg::Alarm{.kind = msg::AlarmKind::refused,
                    .robot = {},
                    .about = "server",
                    .place = {},
                    .since = refused_->since,
                    .detail = std::to_string(refused_->times) + " refused, the last " + std::to_string(ago) +
                              " s ago: " + refused_->reason};
}

}  // namespace weft::server
