#include "clients/cli/redact.hpp"

#include <gtest/gtest.h>

namespace weft::cli::test {
namespace {

TEST(Redact, LeavesOutWhatIsSecretAndNothingElse) {
  const std::string settings =
      "name = \"r1\"\n"
      "listen = '10.0.0.7'\n"
      "mqtt_password = \"hunter2\"\n"
      "API-KEY: hunter2\n"
      "\"auth.token\" = 'hunter2' # hunter2\n"
      "[keys]\n"
      "broker = \"mqtts://weft:hunter2@broker:8883/\"\n"
      "secrets = [\n"
      "  \"hunter2\",\n"
      "]\n"
      "passphrase = \"\"\"\nhunter2\nhunter2\"\"\"\n"
      "window_hops = 40\n";
  const std::string kept = without_secrets(settings);
  EXPECT_EQ(kept.find("hunter2"), std::string::npos) << kept;
  for (const char* const line :
       {"name = \"r1\"\n", "listen = '10.0.0.7'\n", "mqtt_password = (left out)\n", "[keys]\n", "window_hops = 40\n",
        "broker = \"mqtts://(left out)@broker:8883/\"\n"}) {
    EXPECT_NE(kept.find(line), std::string::npos) << line << kept;
  }
}

TEST(Redact, LeavesOutPrivateKeysAndSettingsInLogs) {
  const std::string log =
      "2026-03-01T09:30:05.250Z info weft-server: setting domain = 0\n"
      "2026-03-01T09:30:05.250Z info weft-server: setting signing_key = \"hunter2\"\n"
      "-----BEGIN EC PRIVATE KEY-----\nhunter2\n-----END EC PRIVATE KEY-----\n"
      "2026-03-01T09:30:06.250Z info weft-server: ready: store map\n";
  const std::string kept = without_secrets(log);
  EXPECT_EQ(kept.find("hunter2"), std::string::npos) << kept;
  EXPECT_NE(kept.find("setting domain = 0\n"), std::string::npos);
  EXPECT_NE(kept.find("ready: store map\n"), std::string::npos);
}

}  // namespace
}  // namespace weft::cli::test
