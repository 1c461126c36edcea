#include "tests/containers/light/true_body.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

#include "process/clocks.hpp"

namespace weft::light {
namespace {

constexpr std::streamoff kTail = 4096;  // holds some lines

}  // namespace

Result<Standing> last_standing(const std::string& file, const Standing& at_first) {
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  if (!in || in.tellg() <= 0) return at_first;
  const std::streamoff size = in.tellg();
  in.seekg(size > kTail ? size - kTail : 0);
  const std::string tail{std::istreambuf_iterator<char>(in), {}};
  const std::size_t end = tail.find_last_of('\n');
  if (end == std::string::npos) return at_first;
  const std::size_t before = end == 0 ? std::string::npos : tail.find_last_of('\n', end - 1);
  const std::size_t begin = before == std::string::npos ? 0 : before + 1;
  const auto row = nlohmann::json::parse(tail.substr(begin, end - begin), nullptr, false);
  if (!row.is_object() || !row.contains("frame") || !row.contains("heading"))
    return fail(ErrorCode::corrupt, file + ": its last line tells no pose; remove the file");
  return Standing{row.value("frame", std::uint64_t{0}),
                  {row.value("x", 0.0), row.value("y", 0.0), row.value("heading", 0.0)}};
}

Result<std::unique_ptr<TrueBody>> TrueBody::make(std::unique_ptr<simulation::MarksBody> body, const std::string& file,
                                                 const std::string& robot, std::uint64_t first_frame) {
  const int opened = ::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (opened < 0) return fail(ErrorCode::unavailable, file + ": " + std::strerror(errno));
  return std::unique_ptr<TrueBody>(new TrueBody(std::move(body), opened, robot, first_frame));
}

TrueBody::~TrueBody() {
  ::close(file_);
}

Result<agents::Sample> TrueBody::step(const agents::Twist& command) {
  Result<agents::Sample> sample = body_->step(command);
  if (!sample) return sample;
  sample->frame += first_frame_;
  for (agents::View& view : sample->views) view.frame += first_frame_;
  const Pose2& pose = body_->site_from_robot();
  std::array<char, 400> line{};
  const int length = std::snprintf(
      line.data(), line.size(),
      R"({"robot":"%s","frame":%llu,"t":%.6f,"x":%.6f,"y":%.6f,"heading":%.7f,"at":%.4f,"speed_m_s":%.4f,"hand":%s})"
      "\n",
      robot_.c_str(), static_cast<unsigned long long>(sample->frame), seconds(sample->time.time_since_epoch()),
      pose.x, pose.y, pose.heading, seconds(process::steady_now().time_since_epoch()), body_->true_speed_m_s(),
      body_->by_hand() ? "true" : "false");
  if (::write(file_, line.data(), static_cast<std::size_t>(length)) != length)
    return fail(ErrorCode::exhausted, "truth of " + robot_ + ": " + std::strerror(errno));
  return sample;
}

}  // namespace weft::light
