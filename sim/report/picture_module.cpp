#include "sim/report/picture_module.hpp"

#include <dlfcn.h>

#include <stdexcept>
#include <string>

namespace maquette::sim {

void* picture_module_function(const char* name) {
  static void* const module = dlopen(MAQUETTE_PICTURE_MODULE, RTLD_LAZY | RTLD_LOCAL);
  void* const function = module == nullptr ? nullptr : dlsym(module, name);
  if (function == nullptr) {
    throw std::runtime_error(std::string("no pictures without the picture module: ") + dlerror());
  }
  return function;
}

}  // namespace maquette::sim
