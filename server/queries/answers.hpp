#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/protocol/messages.hpp"
#include "server/base/context.hpp"
#include "server/dispatcher/dispatcher.hpp"
#include "server/dispatcher/standstills.hpp"
#include "server/fleet/fleet.hpp"
#include "server/intake/intake.hpp"
#include "server/queries/alarm_watch.hpp"
#include "server/queries/past_maps.hpp"
#include "server/requests/awaited_labels.hpp"
#include "server/site/site_frames.hpp"
#include "server/traffic/traffic.hpp"
#include "server/traffic/unjoined.hpp"
#include "server/windows/window_publisher.hpp"

namespace weft::server {

/// Answers the queries of clients, in parts of bounded size. Changes nothing of what it shows.
class Answers {
 public:
  Answers(Context& context, const Fleet& fleet, const Traffic& traffic, const UnjoinedWatch& unjoined,
          const Standstills& standstills, const Dispatcher& dispatcher, const Intake& intake,
          const SiteFrames& site_frames, const AwaitedLabels& awaited_labels, const WindowPublisher& window_publisher)
      : context_(context),
        fleet_(fleet),
        traffic_(traffic),
        unjoined_(unjoined),
        standstills_(standstills),
        dispatcher_(dispatcher),
        intake_(intake),
        site_frames_(site_frames),
        awaited_labels_(awaited_labels),
        window_publisher_(window_publisher),
        past_maps_(context) {}

  void on_query(const msg::Query& query, Now now);
  void tick(Now now);
  std::optional<SteadyTime> next() const { return past_maps_.next(); }

 private:
  using Parts = std::vector<msg::QueryReply>;

  Result<Parts> answer(const msg::Query& query, Now now);
  Parts robots(SteadyTime now) const;
  /// Returns what changes of a robot and is not about its place on a plan.
  msg::RobotRow standing(const Robot& robot, SteadyTime now) const;
  Parts alarms(Now now);
  Parts goals(const msg::Query& query) const;
  Result<Parts> events(const msg::Query& query) const;
  Result<Parts> log(const msg::Query& query) const;
  Result<Parts> experiences() const;
  void add_awaited_labels(Parts& parts) const;
  Parts rules() const;
  Parts registrations() const;
  Result<Parts> network(const msg::Query& query, SteadyTime now);
  msg::MapInfo info() const;
  std::string occupies(const RobotId& robot) const;

  Context& context_;
  const Fleet& fleet_;
  const Traffic& traffic_;
  const UnjoinedWatch& unjoined_;
  const Standstills& standstills_;
  const Dispatcher& dispatcher_;
  const Intake& intake_;
  const SiteFrames& site_frames_;
  const AwaitedLabels& awaited_labels_;
  const WindowPublisher& window_publisher_;
  PastMaps past_maps_;
  AlarmWatch alarm_watch_;
  std::optional<SteadyTime> alarms_seen_;
};

}  // namespace weft::server
