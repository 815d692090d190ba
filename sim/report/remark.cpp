#include "sim/report/remark.hpp"

#include <cstdio>

namespace maquette::sim {

void remark(const std::string& text) {
  static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr));
}

}  // namespace maquette::sim
