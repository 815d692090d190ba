#pragma once

#include "models/display/picture.hpp"

namespace maquette::sim {

/// Where two pictures of one size differ: black where they do not, and per channel from a quarter
/// of full brightness at the least difference to full at the largest of all.
[[nodiscard]] models::Picture difference_picture(const models::Picture& first,
                                                 const models::Picture& second);

}  // namespace maquette::sim
