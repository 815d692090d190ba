#pragma once

namespace maquette::sim {

/// The address of a function of the picture module, which is loaded at the first call and stays.
/// Safe to call from several threads. Throws std::runtime_error when it is not there.
void* picture_module_function(const char* name);

}  // namespace maquette::sim
