#include "core/protocol/alarms.hpp"

#include <array>
#include <cassert>

namespace weft::msg {
namespace {

constexpr std::array kTexts{
    AlarmText{
        AlarmKind::silent, "silent",
        "the server hears nothing of the robot: its agent or machine is off, or the network between them is down",
        "look whether its agent runs (`weft-agent --health` there) and whether its machine reaches the server; "
        "`weft robot forget ROBOT` if it is gone for good"},
    AlarmText{
        AlarmKind::lost, "lost",
        "the robot does not know where it is any more and stands: it was moved, or the floor looks different",
        "`weft localise ROBOT --at LABEL`, or move it near a place that was taught; teach anew what has changed"},
    AlarmText{
        AlarmKind::faulted, "faulted",
        "the robot's body does not work: a camera is unplugged, its base does not answer, a recording has ended",
        "repair what the detail names, then start its agent anew"},
    AlarmText{AlarmKind::blocked, "blocked", "the robot is asked to drive and does not move: something holds it",
              "look at the robot: clear its way, free a wheel, end what its base's safety sees"},
    AlarmText{AlarmKind::safety_stop, "safety_stop",
              "the robot's base has stopped it: its scanner or bumper, or somebody pressed an emergency stop",
              "clear what its scanner or bumper sees; after an emergency stop unlock the button, then `weft resume "
              "ROBOT`"},
    AlarmText{AlarmKind::standstill, "standstill",
              "robots wait for each other, or for one that will not move, and none of them gets on by itself",
              "do what the detail says: send an idle one elsewhere, resume, localise or clear one, or lead one back"},
    AlarmText{AlarmKind::twins, "twins",
              "two live agents have the same id, mostly since a robot's state directory was copied; both are held",
              "end one of the two agents and give it an empty --state directory, then `weft resume ROBOT`"},
    AlarmText{AlarmKind::spool, "spool",
              "the robot's own disk takes nothing: it is full or broken; the robot cannot be taught, and forgets its "
              "stops when it is started anew",
              "make room on the robot's disk where its --state lies; it goes on by itself within seconds"},
    AlarmText{AlarmKind::clock, "clock",
              "the robot's clock is over 1 s off the server's: times in its logs and records will not line up",
              "run an NTP client on the robot, or repair the one that runs there"},
    AlarmText{
        AlarmKind::store, "store",
        "the server's store has refused the last write: the map, goals and events do not change until it works",
        "make room on the server's disk where its --store lies; it goes on by itself within seconds. If there is "
        "room, read the server's log and `weft map check`"},
    AlarmText{AlarmKind::disk, "disk", "less than 1 GiB is free on the server's disk: soon it will take nothing",
              "make room, `weft map compact`, or move the store to a larger disk"},
    AlarmText{
        AlarmKind::refused, "refused",
        "the server has refused messages in the last 10 minutes: a program of another version, or a stranger in "
        "its DDS domain",
        "compare versions with `weft doctor`; `weft map info` has all reasons, the server's log each message"},
    AlarmText{AlarmKind::unjoined, "unjoined",
              "robots are in parts of the map that nothing joins: they cannot keep clear of each other where these "
              "meet",
              "teach a run that leads from one part into the other, or register both on a floor plan"},
    AlarmText{
        AlarmKind::deaf, "deaf",
        "the server hears the robot, which has heard nothing for 3.5 s: what the server sends does not reach it",
        "look at what lies on the way to the robot alone: its firewall, its access point, a route back"},
};

}  // namespace

std::span<const AlarmText> alarm_texts() {
  return kTexts;
}

const AlarmText& text_of(AlarmKind kind) {
  const auto index = static_cast<std::size_t>(kind) - 1;
  assert(index < kTexts.size() && kTexts[index].kind == kind);
  return kTexts[index];
}

}  // namespace weft::msg
