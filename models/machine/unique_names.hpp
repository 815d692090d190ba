#pragma once

namespace maquette::models {

/// From now on a module whose name another one has is an error; else the kernel renames it, with a
/// warning. For the whole process: whoever begins a run calls it, before making a machine.
void require_unique_names();

}  // namespace maquette::models
