#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/own_domain.hpp"

namespace {

using testing::EndsWith;
using testing::HasSubstr;
using namespace std::chrono_literals;

/// Runs the real program, its standard error in a file.
class Process {
 public:
  Process(const std::vector<std::string>& arguments, const std::filesystem::path& log) : log_(log) {
    std::vector<const char*> words = {WEFT_SERVER};
    for (const std::string& argument : arguments) words.push_back(argument.c_str());
    words.push_back(nullptr);
    std::filesystem::remove(log);
    pid_ = fork();
    if (pid_ != 0) return;
    const int out = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(out, STDERR_FILENO);
    dup2(out, STDOUT_FILENO);
    execv(WEFT_SERVER, const_cast<char* const*>(words.data()));
    _exit(127);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process() {
    if (pid_ <= 0) return;
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }

  std::string text() const {
    std::ifstream in(log_);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  bool says(const std::string& what) const {
    for (int i = 0; i < 1000; ++i) {
      if (text().find(what) != std::string::npos) return true;
      std::this_thread::sleep_for(20ms);
    }
    return false;
  }
  void signal(int number) const { kill(pid_, number); }
  /// Waits for its end; the signal's negative number when one ended it.
  int exit_code() {
    int status = 0;
    waitpid(pid_, &status, 0);
    pid_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

 private:
  std::filesystem::path log_;
  pid_t pid_ = -1;
};

struct ServerProcess : testing::Test {
  ServerProcess() {
    std::string name = (std::filesystem::temp_directory_path() / "weft-server-XXXXXX").string();
    directory = mkdtemp(name.data());
  }
  ~ServerProcess() override { std::filesystem::remove_all(directory); }
  /// Runs the program to its end; returns its exit code.
  int run(const std::vector<std::string>& arguments) {
    Process process(arguments, directory / "once.log");
    const int code = process.exit_code();
    said = process.text();
    return code;
  }
  std::vector<std::string> serve(const std::string& store, const std::string& vendor = "cyclonedds") const {
    return {"--store", (directory / store).string(), "--domain", std::to_string(domain.number()), "--dds", vendor};
  }
  /// Expects one line, so that people see what is wrong at once.
  void expect_one_line() const {
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
    EXPECT_THAT(said, EndsWith("\n"));
  }

  weft::test::OwnDomain domain;
  std::filesystem::path directory;
  std::string said;
};

TEST_F(ServerProcess, TellsItsVersion) {
  EXPECT_EQ(run({"--version"}), 0);
  EXPECT_THAT(said, HasSubstr("weft-server"));
}

TEST_F(ServerProcess, WrongUsageIsExitTwo) {
  EXPECT_EQ(run({"--sotre", "x"}), 2);
  EXPECT_THAT(said, HasSubstr("--sotre"));
  expect_one_line();
  EXPECT_EQ(run({}), 2);
  EXPECT_THAT(said, HasSubstr("--store"));
  EXPECT_EQ(run({"--store", directory.string(), "--domain", "999"}), 2);
  EXPECT_THAT(said, HasSubstr("[0, 200]"));
  expect_one_line();
  EXPECT_EQ(run({"--store", directory.string(), "--unjoined", "ignore"}), 2);
  EXPECT_THAT(said, HasSubstr("one_drives"));
  EXPECT_EQ(run({"--store", directory.string(), "--silent-goal", "forget"}), 2);
  EXPECT_THAT(said, HasSubstr("hand_over"));
  EXPECT_EQ(run({"--store", directory.string(), "--silent-goal-after-s", "0"}), 2);
  EXPECT_THAT(said, HasSubstr("[1, 86400]"));
  expect_one_line();
}

TEST_F(ServerProcess, WrongConfigurationNamesTheKey) {
  const std::string file = (directory / "server.toml").string();
  std::ofstream(file) << "domian = 3\n";
  EXPECT_EQ(run({"--config", file, "--store", directory.string()}), 2);
  EXPECT_THAT(said, HasSubstr(file + ":1: domian: unknown key; there are charge_critical_percent, "));
  expect_one_line();
  EXPECT_EQ(run({"--config", file + ".gone", "--store", directory.string()}), 2);
  EXPECT_THAT(said, HasSubstr(file + ".gone: cannot be read"));
  expect_one_line();
  for (const auto& [wrong, words] : std::map<std::string, std::string>{
           {"domain = 999\n", ":1: domain = 999: must be in [0, 200]"},
           {"domain = \n", ":1: no TOML"},
           {"\ncharge_low_percent = 5\n", ": charge_low_percent is 5; it must be from charge_critical_percent"}}) {
    std::ofstream(file) << wrong;
    EXPECT_EQ(run({"--config", file, "--store", directory.string()}), 2);
    EXPECT_THAT(said, HasSubstr(file + words));
    expect_one_line();
  }
}

TEST_F(ServerProcess, StoreThatCannotBeMadeIsNamed) {
  std::ofstream(directory / "file") << "not a directory";
  EXPECT_EQ(run(serve("file/store")), 1);
  EXPECT_THAT(said, HasSubstr("file/store"));
  expect_one_line();
}

TEST_F(ServerProcess, ServesUntilTermAndKeepsItsIdentity) {
  std::string identity;
  for (const char* const vendor : {"cyclonedds", "fastdds"}) {
    Process server(serve("store", vendor), directory / "server.log");
    ASSERT_TRUE(server.says("ready")) << server.text();
    EXPECT_THAT(server.text(), HasSubstr("* domain = " + std::to_string(domain.number())));
    server.signal(identity.empty() ? SIGTERM : SIGINT);
    EXPECT_EQ(server.exit_code(), 0) << server.text();
    std::ifstream in(directory / "store" / "identity");
    std::string now;
    in >> now;
    EXPECT_EQ(now.size(), 32U);
    EXPECT_EQ(now, identity.empty() ? now : identity);
    identity = now;
  }
}

TEST_F(ServerProcess, SecondServerOnAStoreOrAPortIsRefused) {
  const Process server(serve("store"), directory / "server.log");
  ASSERT_TRUE(server.says("ready")) << server.text();
  EXPECT_EQ(run(serve("store")), 1);
  EXPECT_THAT(said, HasSubstr("in use"));
  expect_one_line();
  for (const char* const vendor : {"cyclonedds", "fastdds"}) {
    EXPECT_EQ(run(serve("other", vendor)), 1);
    EXPECT_THAT(said, HasSubstr("port"));
    expect_one_line();
  }
}

TEST_F(ServerProcess, HealthIsThatOfTheServerInTheStore) {
  EXPECT_EQ(run({"--health"}), 2);
  EXPECT_THAT(said, HasSubstr("--store"));
  const std::vector<std::string> ask = {"--health", "--store", (directory / "store").string()};
  EXPECT_EQ(run(ask), 1);
  EXPECT_THAT(said, HasSubstr("not running"));
  Process server(serve("store"), directory / "server.log");
  ASSERT_TRUE(server.says("ready")) << server.text();
  EXPECT_EQ(run(ask), 0) << said;
  EXPECT_THAT(said, HasSubstr("healthy: weft-server, process"));
  server.signal(SIGTERM);
  EXPECT_EQ(server.exit_code(), 0);
  EXPECT_EQ(run(ask), 1);
  EXPECT_THAT(said, HasSubstr("not running"));
  expect_one_line();
}

TEST_F(ServerProcess, LogsJsonWhenAsked) {
  std::vector<std::string> arguments = serve("store");
  arguments.insert(arguments.end(), {"--log-format", "json"});
  const Process server(arguments, directory / "server.log");
  ASSERT_TRUE(server.says("ready")) << server.text();
  std::istringstream lines(server.text());
  for (std::string line; std::getline(lines, line);) {
    EXPECT_THAT(line, testing::StartsWith("{\"time\":\"20"));
    EXPECT_THAT(line, EndsWith("}"));
  }
}

TEST_F(ServerProcess, SurvivesKillNine) {
  for (int i = 0; i < 3; ++i) {
    Process server(serve("store"), directory / "server.log");
    ASSERT_TRUE(server.says("epoch " + std::to_string(i + 1))) << server.text();
    server.signal(SIGKILL);
    EXPECT_EQ(server.exit_code(), -SIGKILL);
  }
}

}  // namespace
