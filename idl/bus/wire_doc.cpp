#include <iostream>

#include "idl/bus/topics.hpp"

/// Prints docs/wire.md.
int main() {
  std::cout << weft::bus::wire_document();
  return std::cout.good() ? 0 : 1;
}
