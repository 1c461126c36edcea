#include "idl/convert/common.hpp"
#include "idl/convert/limits.hpp"
#include "idl/convert/messages.hpp"

namespace weft::convert {

static idl::MapWork work_to_idl(const msg::MapWork& work) {
  idl::MapWork wire;
  wire.revision(work.revision.value);
  wire.places(list_to_idl<idl::Stretch>(work.what.places));
  wire.stitches(list_to_idl<idl::EdgeId>(work.what.stitches));
  wire.only_say(work.only_say);
  wire.within_m(work.within_m);
  wire.within_rad(work.within_rad);
  wire.file(work.file);
  return wire;
}

static msg::MapWork from_idl(const idl::MapWork& wire, Reading reading) {
  msg::MapWork value;
  value.revision = Revision{wire.revision()};
  value.what.places = list_from_idl<Stretch>(wire.places(), reading, "places", kRemoved);
  value.what.stitches = list_from_idl<EdgeId>(wire.stitches(), reading, "stitches", kRemoved);
  value.only_say = wire.only_say();
  value.within_m = reading.not_negative("within_m", wire.within_m());
  reading.require(value.within_m <= kWithin_m, "within_m", "must be at most 10");
  value.within_rad = reading.not_negative("within_rad", wire.within_rad());
  reading.require(value.within_rad <= kWithin_rad, "within_rad", "must be at most pi");
  value.file = reading.text("file", wire.file(), kFileLength);
  return value;
}

idl::OperatorRequest to_idl(const msg::OperatorRequest& message) {
  idl::OperatorRequest wire;
  wire.header(to_idl(message.header));
  wire.request(message.request);
  wire.kind(static_cast<std::uint8_t>(message.kind));
  wire.who(message.who);
  wire.robot(message.robot);
  wire.label(message.label);
  wire.new_label(message.new_label);
  wire.place(to_idl(message.place));
  wire.goal(message.goal.bytes);
  wire.along(to_idl(message.along));
  wire.work(work_to_idl(message.work));
  wire.is_sure(message.is_sure);
  return wire;
}

Result<msg::OperatorRequest> from_idl(const idl::OperatorRequest& wire) {
  using Kind = msg::OperatorRequest::Kind;
  Reading reading("OperatorRequest");
  msg::OperatorRequest value;
  value.header = from_idl(wire.header(), reading.in("header"));
  value.request = wire.request();
  value.kind = reading.choice("kind", wire.kind(), Kind::goal_send, Kind::label_rename);
  value.who = reading.text("who", wire.who(), kNameLength);
  value.robot = reading.text("robot", wire.robot(), kNameLength);
  value.label = reading.text("label", wire.label(), kNameLength);
  value.new_label = reading.text("new_label", wire.new_label(), kNameLength);
  value.place = from_idl(wire.place());
  value.goal = id_from<GoalId>(wire.goal());
  const bool needs_goal = value.kind == Kind::goal_send || value.kind == Kind::goal_cancel;
  reading.require(!needs_goal || value.goal, "goal", "must not be none");
  value.along = from_idl(wire.along(), reading.in("along"));
  value.work = from_idl(wire.work(), reading.in("work"));
  value.is_sure = wire.is_sure();
  return reading.finish(std::move(value));
}

idl::OperatorReply to_idl(const msg::OperatorReply& message) {
  idl::OperatorReply wire;
  wire.header(to_idl(message.header));
  wire.to(message.to.bytes);
  wire.request(message.request);
  wire.outcome(static_cast<std::uint8_t>(message.outcome));
  wire.message(message.message);
  wire.goal(message.goal.bytes);
  wire.place(to_idl(message.place));
  wire.experience(message.experience.value);
  wire.revision(message.revision.value);
  wire.done(message.done);
  wire.total(message.total);
  wire.unit(message.unit);
  wire.findings(message.findings);
  wire.counts(counts_to_idl(message.counts));
  wire.report(list_to_idl<idl::TaughtStretch>(message.report));
  return wire;
}

Result<msg::OperatorReply> from_idl(const idl::OperatorReply& wire) {
  Reading reading("OperatorReply");
  msg::OperatorReply value;
  value.header = from_idl(wire.header(), reading.in("header"));
  value.to = reading.some("to", id_from<PeerId>(wire.to()));
  value.request = wire.request();
  value.outcome = reading.choice("outcome", wire.outcome(), msg::Outcome::done, msg::Outcome::under_way);
  value.message = reading.text("message", wire.message(), kTextLength);
  value.goal = id_from<GoalId>(wire.goal());
  value.place = from_idl(wire.place());
  value.experience = ExperienceId{wire.experience()};
  value.revision = Revision{wire.revision()};
  value.done = wire.done();
  value.total = wire.total();
  value.unit = reading.text("unit", wire.unit(), kNameLength);
  for (const std::string& finding : reading.list("findings", wire.findings(), kFindings)) {
    value.findings.push_back(reading.text("findings", finding, kTextLength));
  }
  value.counts = counts_from_idl(wire.counts(), reading, "counts");
  value.report = list_from_idl<msg::TaughtStretch>(wire.report(), reading, "report", msg::kReportRows);
  return reading.finish(std::move(value));
}

idl::Query to_idl(const msg::Query& message) {
  idl::Query wire;
  wire.header(to_idl(message.header));
  wire.request(message.request);
  wire.kind(static_cast<std::uint8_t>(message.kind));
  wire.goal(message.goal.bytes);
  wire.robot(message.robot);
  wire.newest(message.newest.value);
  wire.most(message.most);
  wire.at_revision(message.at.value);
  wire.apart_from(message.apart_from.value);
  wire.after(to_idl(message.after));
  return wire;
}

Result<msg::Query> from_idl(const idl::Query& wire) {
  using Kind = msg::Query::Kind;
  Reading reading("Query");
  msg::Query value;
  value.header = from_idl(wire.header(), reading.in("header"));
  value.request = wire.request();
  value.kind = reading.choice("kind", wire.kind(), Kind::robots, Kind::experiences);
  value.goal = id_from<GoalId>(wire.goal());
  value.robot = reading.text("robot", wire.robot(), kNameLength);
  value.newest = Revision{wire.newest()};
  value.most = wire.most();
  value.at = Revision{wire.at_revision()};
  value.apart_from = Revision{wire.apart_from()};
  value.after = from_idl(wire.after());
  return reading.finish(std::move(value));
}

}  // namespace weft::convert
