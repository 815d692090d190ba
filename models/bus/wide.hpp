#pragma once

namespace maquette::models {

/// For products of two 64-bit numbers and sums of many.
__extension__ typedef __int128 Wide;  // NOLINT(modernize-use-using): `using` takes no __extension__

}  // namespace maquette::models
