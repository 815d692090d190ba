#pragma once

namespace maquette::sim {

/// The version of the release, as in "1.0.0".
[[nodiscard]] const char* version();

/// The commit that the program was built from, as git describes it; "unknown" outside a repository.
[[nodiscard]] const char* revision();

}  // namespace maquette::sim
