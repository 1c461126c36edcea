#include "clients/cli/findings.hpp"

#include <algorithm>
#include <utility>

#include "clients/cli/table.hpp"

namespace weft::cli {

Exit show(const std::vector<Finding>& findings, nlohmann::json more, bool json, const Output& output) {
  const bool good = std::ranges::all_of(findings, &Finding::good);
  Table table;
  nlohmann::json listed = nlohmann::json::array();
  for (const Finding& finding : findings) {
    table.add({finding.good ? "ok" : "PROBLEM", finding.what, finding.detail});
    listed.push_back({{"what", finding.what}, {"good", finding.good}, {"detail", finding.detail}});
  }
  if (json) {
    more["good"] = good;
    more["findings"] = std::move(listed);
    output.out << printed(more) << '\n';
  } else {
    table.print(output.out);
  }
  return good ? Exit::done : Exit::failed;
}

}  // namespace weft::cli
