#include "process/systemd.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "tests/process/folder.hpp"
#include "tests/process/manager_socket.hpp"

namespace weft::process::test {
namespace {

using namespace std::chrono_literals;

TEST(Watchdog, IsTheProcessesOwnAndANumber) {
  EXPECT_EQ(watchdog_of("30000000", nullptr, 7), 30s);
  EXPECT_EQ(watchdog_of("30000000", "7", 7), 30s);
  EXPECT_EQ(watchdog_of("30000000", "8", 7), 0s);
  for (const char* const wrong : {"", "x", "30s", "-5", "0", "99999999999999999999"}) {
    EXPECT_EQ(watchdog_of(wrong, nullptr, 7), 0s) << wrong;
  }
  EXPECT_EQ(watchdog_of(nullptr, nullptr, 7), 0s);
  EXPECT_LE(watchdog_of("9223372036854775807", nullptr, 7), 24h);
}

TEST(ServiceManager, HearsOfAPathAndOfAnAbstractName) {
  const Folder folder;
  for (const std::string& name : {folder.file("notify"), "@weft-test" + folder.file("notify")}) {
    const ManagerSocket socket(name);
    const ServiceManager manager(name, 30s);
    manager.tell("READY=1");
    EXPECT_EQ(socket.take(), "READY=1");
    EXPECT_EQ(manager.watchdog(), 30s);
  }
}

TEST(ServiceManager, IsNotMissedWhereThereIsNone) {
  ServiceManager("", 30s).tell("READY=1");
  ServiceManager("/nowhere/notify", 30s).tell("READY=1");
  ServiceManager("vsock:2:1", 30s).tell("READY=1");
  ServiceManager(std::string(500, '/'), 30s).tell("READY=1");
  EXPECT_EQ(ServiceManager("", 30s).watchdog(), 0s);
}

}  // namespace
}  // namespace weft::process::test
