#include "core/network/no_path.hpp"

namespace weft {

std::string no_path_text(const PlaceId& from, const PlaceId& to, const std::set<std::string>& methods) {
  std::string list;
  for (const std::string& method : methods) list += (list.empty() ? "" : ", ") + method;
  return "no path from " + to_string(from) + " to " + to_string(to) +
         " that can be driven with methods: " + (list.empty() ? "none" : list);
}

}  // namespace weft
