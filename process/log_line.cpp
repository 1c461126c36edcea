#include "process/log_line.hpp"

#include <nlohmann/json.hpp>

#include "core/text.hpp"

namespace weft::process {

std::string to_text(const LogLine& line) {
  std::string text = iso_time(line.at) + " ";
  text.append(line.level).append(" ").append(line.program).append(": ");
  if (!line.event.empty()) text.append(line.event).append(": ");
  text.append(line.message);
  std::string about;
  for (const LogField& field : line.fields) {
    if (field.value.empty()) continue;
    about.append(about.empty() ? " (" : ", ").append(field.name).append(" ").append(field.value);
  }
  if (!about.empty()) text += about + ")";
  return one_line(text);
}

std::string to_json(const LogLine& line) {
  nlohmann::ordered_json object;
  object["time"] = iso_time(line.at);
  object["level"] = line.level;
  object["program"] = line.program;
  if (!line.event.empty()) object["event"] = line.event;
  object["message"] = line.message;
  for (const LogField& field : line.fields) {
    if (!field.value.empty()) object[std::string(field.name)] = field.value;
  }
  return object.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace weft::process
