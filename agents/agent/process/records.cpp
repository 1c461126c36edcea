#include "agents/agent/process/records.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "agents/agent/process/words.hpp"

namespace weft::agents {

Result<Records> Records::open(const std::filesystem::path& directory, const std::string& robot) {
  Records records(robot);
  for (const auto& [file, name] :
       {std::pair{&records.fixes_, "fixes.jsonl"}, std::pair{&records.acks_, "acks.jsonl"},
        std::pair{&records.drives_, "drives.jsonl"}, std::pair{&records.orders_, "orders.jsonl"},
        std::pair{&records.motion_, "motion.jsonl"}}) {
    const std::filesystem::path path = directory / name;
    *file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
    if (*file < 0) {
      return fail(ErrorCode::unavailable, path.string() + ": " + std::strerror(errno) + "; is --records a folder?");
    }
  }
  return records;
}

Records::Records(Records&& other) noexcept
    : robot_(std::move(other.robot_)),
      fixes_(std::exchange(other.fixes_, -1)),
      acks_(std::exchange(other.acks_, -1)),
      drives_(std::exchange(other.drives_, -1)),
      orders_(std::exchange(other.orders_, -1)),
      motion_(std::exchange(other.motion_, -1)),
      told_(std::move(other.told_)),
      order_(other.order_),
      lost_(other.lost_) {}

/// Appends a line in one write: with O_APPEND, lines of several robots in one file stay whole.
void Records::append(int file, const std::string& line) {
  const std::string whole = line + "\n";
  if (::write(file, whole.data(), whole.size()) != static_cast<ssize_t>(whole.size())) ++lost_;
}

Records::~Records() {
  for (const int file : {fixes_, acks_, drives_, orders_, motion_}) {
    if (file >= 0) close(file);
  }
}

void Records::note(const AgentOutput& output, std::uint64_t frame) {
  for (const FixRecord& record : output.fixes) {
    const Pose2 pose = planar(record.fix.place_from_robot);
    append(fixes_,
           text(R"({"robot":"%s","frame":%llu,"place":"%s","place_from_robot":{"x":%.6f,"y":%.6f,"heading":%.7f}})",
                robot_.c_str(), static_cast<unsigned long long>(record.frame), to_string(record.fix.place).c_str(),
                pose.x, pose.y, pose.heading));
  }
  for (const AckRecord& ack : output.acks) {
    append(acks_, text(R"({"robot":"%s","experience":"%s","sequence":%llu,"first":%u,"places":%u})", robot_.c_str(),
                       to_string(ack.experience).c_str(), static_cast<unsigned long long>(ack.sequence), ack.first,
                       ack.places));
  }
  for (const msg::Message& message : output.send) {
    if (const auto* const progress = std::get_if<msg::RouteProgress>(&message)) note(*progress, frame);
    if (const auto* const state = std::get_if<msg::RobotState>(&message)) note(*state);
  }
}

void Records::note(const std::optional<Route>& route, std::uint64_t frame) {
  const Order order = route ? Order{route->id, route->version, route->released} : Order{};
  if (order == order_) return;
  // Its places are written once a version.
  const bool is_known = order.route == order_.route && order.version == order_.version;
  order_ = order;
  std::string places;
  if (route && !is_known) {
    for (const PlaceId& place : route->places) places += (places.empty() ? "\"" : ",\"") + to_string(place) + "\"";
  }
  std::string line =
      text(R"({"robot":"%s","frame":%llu,"goal":"%s","route":"%s","version":%u,"released":%u)", robot_.c_str(),
           static_cast<unsigned long long>(frame), to_string(route ? route->goal : GoalId{}).c_str(),
           to_string(order.route).c_str(), order.version, order.released);
  if (!places.empty()) line += ",\"places\":[" + places + "]";
  append(orders_, line + "}");
}

void Records::note(const msg::RobotState& state) {
  append(
      motion_,
      text(R"({"robot":"%s","frame":%llu,"mode":"%s","speed_m_s":%.4f,"route":"%s","version":%u,"at":%u})",
           robot_.c_str(), static_cast<unsigned long long>(state.frame), msg::to_string(state.mode), state.speed_m_s,
           to_string(state.route).c_str(), state.route_version, state.route == told_.route ? told_.at : 0U));
}

void Records::note(const msg::RouteProgress& progress, std::uint64_t frame) {
  const bool same =
      progress.route == told_.route && progress.version == told_.version && progress.phase == told_.phase;
  if (same) return;
  told_ = progress;
  append(drives_, text(R"({"robot":"%s","frame":%llu,"goal":"%s","route":"%s","version":%u,"phase":"%s"})",
                       robot_.c_str(), static_cast<unsigned long long>(frame), to_string(progress.goal).c_str(),
                       to_string(progress.route).c_str(), progress.version, msg::to_string(progress.phase)));
}

}  // namespace weft::agents
