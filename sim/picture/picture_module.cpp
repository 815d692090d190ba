#include "sim/picture/picture_module.hpp"

#include <dlfcn.h>

#include <stdexcept>
#include <string>

#include "sim/picture/program_tree.hpp"

namespace maquette::sim {

namespace {

constexpr const char* k_picture_module = "lib/maquette/picture_module.so";

}  // namespace

void* picture_module_function(const char* name) {
  static void* const module =
      dlopen((program_tree() / k_picture_module).c_str(), RTLD_LAZY | RTLD_LOCAL);
  void* const function = module == nullptr ? nullptr : dlsym(module, name);
  if (function == nullptr) {
    throw std::runtime_error(std::string("no pictures without the picture module: ") + dlerror());
  }
  return function;
}

}  // namespace maquette::sim
