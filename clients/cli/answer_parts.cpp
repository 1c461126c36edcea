#include "clients/cli/answer_parts.hpp"

#include <iterator>
#include <vector>

namespace weft::cli {
namespace {

template <class T>
void append(std::vector<T>& all, const std::vector<T>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

bool AnswerParts::add(const msg::QueryReply& part) {
  if (part.parts == 0 || part.part >= part.parts) return false;
  if (part.parts != count_) {
    parts_.clear();
    count_ = part.parts;
  }
  parts_.insert_or_assign(part.part, part);
  return parts_.size() == count_;
}

msg::QueryReply AnswerParts::joined() const {
  msg::QueryReply all = parts_.begin()->second;
  for (auto part = std::next(parts_.begin()); part != parts_.end(); ++part) {
    append(all.robots, part->second.robots);
    append(all.goals, part->second.goals);
    append(all.routes, part->second.routes);
    append(all.arrivals, part->second.arrivals);
    append(all.events, part->second.events);
    append(all.alarms, part->second.alarms);
    append(all.log, part->second.log);
    append(all.network.places, part->second.network.places);
    append(all.network.edges, part->second.network.edges);
    append(all.network.aparts, part->second.network.aparts);
    append(all.network.rules, part->second.network.rules);
    append(all.network.registrations, part->second.network.registrations);
    append(all.rules, part->second.rules);
    append(all.registrations, part->second.registrations);
    append(all.experiences, part->second.experiences);
    append(all.awaited_labels, part->second.awaited_labels);
    all.network.labels.insert(part->second.network.labels.begin(), part->second.network.labels.end());
  }
  all.parts = 1;
  return all;
}

}  // namespace weft::cli
