#pragma once
#include <string>

namespace weft::cli {

/// Returns the text of a configuration or a log without what is secret: the values of what is called a password,
/// secret, token, credential, passphrase or key, private keys, and the passwords of addresses. "(left out)" stands in
/// their place; lines stay lines.
std::string without_secrets(const std::string& text);

}  // namespace weft::cli
