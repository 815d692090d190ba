#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace maquette::sim {

/// Number of letters to insert, delete, replace or swap with a neighbour to turn one text into the
/// other (optimal string alignment distance).
[[nodiscard]] int edit_distance(std::string_view left, std::string_view right);

/// The end of a message about an unknown name: what is allowed, and the nearest name if one is near
/// enough to be meant, as in "allowed: clock, ram; did you mean `clock`?".
[[nodiscard]] std::string allowed_names(std::string_view name,
                                        const std::vector<std::string_view>& allowed);

}  // namespace maquette::sim
