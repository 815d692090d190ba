#include "sim/report/function_statistics.hpp"

#include "sim/primitives/primitive_table.hpp"

namespace maquette::sim {

namespace {

std::array<std::string, k_told_function_count> list_names() {
  std::array<std::string, k_told_function_count> names;
  std::size_t place = 0;
  for (const char* name : firmware::k_function_names) {
    names[place++] = name;
  }
  for (const PrimitiveDescription* primitive : primitive_table()) {
    names[place++] = "intersection_" + std::string{primitive->name};
  }
  return names;
}

}  // namespace

const std::string& function_name(int function) {
  static const std::array<std::string, k_told_function_count> names = list_names();
  return names.at(static_cast<std::size_t>(function));
}

}  // namespace maquette::sim
