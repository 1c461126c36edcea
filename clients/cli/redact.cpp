#include "clients/cli/redact.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <sstream>
#include <string_view>

namespace weft::cli {
namespace {

constexpr std::string_view kLeftOut = "(left out)";
constexpr std::array<std::string_view, 7> kSecretWords = {"password", "passwd",     "passphrase", "secret",
                                                          "token",    "credential", "private"};

std::string lower(std::string_view text) {
  std::string small(text);
  std::ranges::transform(small, small.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return small;
}

bool is_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '.';
}

bool is_secret(std::string_view name) {
  const std::string small = lower(name);
  const auto has = [&small](std::string_view word) { return small.find(word) != std::string::npos; };
  return std::ranges::any_of(kSecretWords, has) || small.ends_with("key");
}

/// Returns where the value of the first secret of the line begins: behind NAME = or NAME: with quotes or without.
std::optional<std::size_t> secret_value(std::string_view line) {
  for (std::size_t sign = line.find_first_of("=:"); sign != std::string_view::npos;
       sign = line.find_first_of("=:", sign + 1)) {
    std::size_t end = sign;
    while (end > 0 &&
           (line[end - 1] == ' ' || line[end - 1] == '\t' || line[end - 1] == '"' || line[end - 1] == '\''))
      --end;
    std::size_t begin = end;
    while (begin > 0 && is_name(line[begin - 1])) --begin;
    if (is_secret(line.substr(begin, end - begin))) return sign + 1;
  }
  return std::nullopt;
}

/// Leaves the password of an address out: scheme://user:password@host.
std::string without_password(std::string line) {
  for (std::size_t at = line.find("://"); at != std::string::npos; at = line.find("://", at + 3)) {
    const std::size_t begin = at + 3;
    const std::size_t end = std::min(line.find_first_of("/ \t\"'", begin), line.size());
    const std::size_t host = line.substr(0, end).rfind('@');
    if (host == std::string::npos || host < begin) continue;
    line.replace(begin, host - begin, kLeftOut);
  }
  return line;
}

/// Returns what ends a value that goes on behind its own line: quotes of several lines, a list; empty: it does not.
std::string_view end_of_value(std::string_view value) {
  for (const std::string_view quotes : {std::string_view("\"\"\""), std::string_view("'''")}) {
    const std::size_t begin = value.find(quotes);
    if (begin != std::string_view::npos && value.find(quotes, begin + 3) == std::string_view::npos) return quotes;
  }
  if (value.find('[') != std::string_view::npos && value.find(']') == std::string_view::npos) return "]";
  return {};
}

}  // namespace

std::string without_secrets(const std::string& text) {
  std::istringstream in(text);
  std::string kept;
  std::string until;  // ends what is left out; empty: nothing is
  for (std::string line; std::getline(in, line);) {
    if (!until.empty()) {
      if (line.find(until) != std::string::npos) until.clear();
      kept += std::string(kLeftOut) + "\n";
      continue;
    }
    if (line.find("-----BEGIN") != std::string::npos && line.find("PRIVATE KEY") != std::string::npos) {
      until = "-----END";
      kept += std::string(kLeftOut) + "\n";
      continue;
    }
    if (const std::optional<std::size_t> value = secret_value(line)) {
      until = end_of_value(std::string_view(line).substr(*value));
      line = line.substr(0, *value) + " " + std::string(kLeftOut);
    }
    kept += without_password(std::move(line)) + "\n";
  }
  return kept;
}

}  // namespace weft::cli
