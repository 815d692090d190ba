#pragma once

#include <string>

#include "sim/primitives/primitive.hpp"

namespace maquette::benchmark {

/// A vector of POV-Ray's language.
[[nodiscard]] std::string povray_vector(const sim::Vector3& v);

/// A primitive in POV-Ray's language in its own frame, followed by `modifiers`: placement and
/// texture. Throws std::invalid_argument for one that POV-Ray is not compared by.
[[nodiscard]] std::string povray_solid(const sim::Primitive& primitive,
                                       const std::string& modifiers);

}  // namespace maquette::benchmark
