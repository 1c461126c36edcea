#include <utility>

#include "agents/agent/robot_agent.hpp"
#include "core/network/codec.hpp"

namespace weft::agents {
namespace {
/// A drive's lessons are one revision, which can be undone as one; a long drive makes several.
constexpr std::size_t kLessonsAtOnce = 500;
}  // namespace

/// What was learned upon a content that the window does not have any more is void.
void RobotAgent::note_lessons(std::vector<Lesson> lessons, SensorTime seen_at) {
  for (Lesson& lesson : lessons) {
    const Place* const known = replica_.window().place(lesson.place);
    if (known == nullptr || known->content.hash != lesson.made_of) continue;
    Place anew = *known;
    ++anew.entity_version;
    anew.content_format = lesson.content_format;
    anew.content = {hash_bytes(lesson.content), lesson.content.size()};
    anew.robot = config_.self;
    anew.frame = frame_;
    anew.seen_at = seen_at;
    lessons_.insert_or_assign(lesson.place, Learned{std::move(anew), std::move(lesson.content)});
    ++seen_["navigation: places known better"];
  }
}

void RobotAgent::hand_in_lessons(SteadyTime now) {
  const bool drives = task_.route().has_value() && !task_.arrived();
  if (lessons_.empty() || (drives && lessons_.size() < kLessonsAtOnce)) return;
  std::vector<Place> places;
  std::vector<Bytes> contents;
  for (auto& [id, learned] : std::exchange(lessons_, {})) {
    places.push_back(std::move(learned.place));
    contents.push_back(std::move(learned.content));
  }
  const std::string count = std::to_string(places.size());
  const Result<void> handed_in = spooler_.learned(std::move(places), std::move(contents), new_experience(), now);
  output_.notes.push_back(handed_in
                              ? "knows " + count + " places better: handed in"
                              : "what it has learned of " + count + " places is lost: " + handed_in.error().message);
}

}  // namespace weft::agents
