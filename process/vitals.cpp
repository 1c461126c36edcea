#include "process/vitals.hpp"

#include <unistd.h>

#include <algorithm>
#include <utility>

#include "core/text.hpp"

namespace weft::process {

Vitals::Vitals(std::string program, std::filesystem::path directory, std::function<void(const std::string&)> warn,
               ServiceManager manager, SteadyTime now)
    : directory_(std::move(directory)),
      warn_(std::move(warn)),
      manager_(std::move(manager)),
      between_(kBetweenBeats),
      due_(now) {
  if (manager_.watchdog() > Duration{}) between_ = std::min(between_, manager_.watchdog() / 2);
  health_ = {.program = std::move(program), .process = ::getpid(), .beat = now, .is_starting = true, .trouble = {}};
}

void Vitals::starting(const std::string& what, SteadyTime now) {
  if (health_.trouble != what) health_.beat = now;
  health_.trouble = what;
  write(now);
  // A process that waits for its link turns all the same: the service manager waits with it.
  manager_.tell("EXTEND_TIMEOUT_USEC=60000000\nSTATUS=" + one_line(what));
}

void Vitals::ready(SteadyTime now) {
  health_.is_starting = false;
  manager_.tell("READY=1");
  beat(now, {});
}

void Vitals::beat(SteadyTime now, const std::string& trouble) {
  health_.beat = now;
  health_.trouble = trouble;
  write(now);
  std::string state = "WATCHDOG=1";
  const std::string status = trouble.empty() ? "works" : one_line(trouble);
  if (status != told_status_) state += "\nSTATUS=" + status;
  told_status_ = status;
  manager_.tell(state);
}

void Vitals::write(SteadyTime now) {
  due_ = now + between_;
  const Result<void> written = try_to_write();
  if (written) has_warned_ = false;
  // A start that fails says so in one line: nothing is said before it has ended.
  if (written || health_.is_starting || std::exchange(has_warned_, true)) return;
  warn_(written.error().message + "; --health cannot tell how this process is");
}

Result<void> Vitals::try_to_write() {
  if (!file_) {
    Result<HealthFile> opened = HealthFile::open(directory_);
    if (!opened) return fail(opened.error());
    file_.emplace(*std::move(opened));
  }
  Result<void> written = file_->write(health_);
  if (!written && written.error().code == ErrorCode::unavailable) file_.reset();
  return written;
}

}  // namespace weft::process
