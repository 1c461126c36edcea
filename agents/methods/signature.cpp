#include <algorithm>

#include "agents/methods/method.hpp"

namespace weft::agents {

double distance2(const Signature& a, const Signature& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    const double apart = static_cast<double>(a[i]) - static_cast<double>(b[i]);
    sum += apart * apart;
  }
  return sum;
}

}  // namespace weft::agents
