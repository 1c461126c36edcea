#include "tests/contract/bus/lab.hpp"

#include <sched.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace weft::contract {
namespace {

/// Starts a child in a network of its own that does nothing; returns its pid, 0 when the system refuses.
pid_t hold_namespace() {
  int told[2];
  if (pipe(told) != 0) return 0;
  const pid_t child = fork();
  if (child == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const char made = unshare(CLONE_NEWNET) == 0 ? 1 : 0;
    if (write(told[1], &made, 1) != 1 || made == 0) _exit(1);
    close(told[0]);
    close(told[1]);
    for (;;) pause();
  }
  close(told[1]);
  char made = 0;
  const bool is_made = child > 0 && read(told[0], &made, 1) == 1 && made == 1;
  close(told[0]);
  if (is_made) return child;
  if (child > 0) waitpid(child, nullptr, 0);
  return 0;
}

std::string process_file(pid_t process, const char* name) {
  std::ifstream in("/proc/" + std::to_string(process) + "/net/" + name);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Returns the number in the given column after a line's heading.
std::uint64_t number_after(const std::string& text, const std::string& heading, int column) {
  const std::size_t at = text.rfind(heading);
  if (at == std::string::npos) return 0;
  std::istringstream numbers(text.substr(at + heading.size()));
  std::uint64_t number = 0;
  for (int i = 0; i <= column; ++i) numbers >> number;
  return number;
}

}  // namespace

Result<std::unique_ptr<Lab>> Lab::make() {
  if (geteuid() != 0) return fail(ErrorCode::unavailable, "network namespaces need root");
  std::unique_ptr<Lab> lab(new Lab);
  for (pid_t& holder : lab->holders_) {
    holder = hold_namespace();
    if (holder == 0) return fail(ErrorCode::unavailable, "the system gives no network namespace");
  }
  if (const Result<void> laid = lab->lay_cable(); !laid) return fail(laid.error());
  return lab;
}

Lab::~Lab() {
  for (const pid_t holder : holders_) {
    if (holder <= 0) continue;
    kill(holder, SIGKILL);
    waitpid(holder, nullptr, 0);
  }
}

Result<void> Lab::lay_cable() const {
  const std::string robot = std::to_string(holder(At::robot));
  Result<void> done = run(At::server, "ip link add eth0 type veth peer name eth0 netns " + robot +
                                          " && ip addr add " + kServer + "/24 dev eth0 && ip link set eth0 up");
  if (done) done = run(At::robot, std::string("ip addr add ") + kRobot + "/24 dev eth0 && ip link set eth0 up");
  for (const At machine : {At::server, At::robot}) {
    if (done) done = run(machine, "ip link set lo up");
  }
  return done;
}

Result<void> Lab::run(At machine, const std::string& line) const {
  const std::string command =
      "nsenter --net=/proc/" + std::to_string(holder(machine)) + "/ns/net sh -c '" + line + "' >/dev/null 2>&1";
  if (std::system(command.c_str()) == 0) return {};
  return fail(ErrorCode::unavailable, "cannot run `" + line + "` in a network namespace");
}

Result<void> Lab::lose(unsigned percent) const {
  // At a device's ingress, where IP fragments are not put together yet: that is what a radio loses.
  const std::string line =
      "nft add table netdev lab && "
      "nft add chain netdev lab ingress \"{ type filter hook ingress device eth0 priority 0; }\" && "
      "nft add rule netdev lab ingress numgen random mod 100 \\< " +
      std::to_string(percent) + " drop";
  Result<void> done = run(At::server, line);
  if (done) done = run(At::robot, line);
  return done;
}

std::uint64_t Lab::sent_bytes(At machine) const {
  constexpr int kSent = 8;
  return number_after(process_file(holder(machine), "dev"), "eth0:", kSent);
}

std::uint64_t Lab::fragments(At machine) const {
  constexpr int kCreated = 18;
  return number_after(process_file(holder(machine), "snmp"), "Ip:", kCreated);
}

}  // namespace weft::contract
