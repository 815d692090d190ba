#pragma once

#include <string>
#include <string_view>

namespace maquette::sim {

/// The bytes as an address that holds them itself, so that nothing is fetched: "data:image/png;..".
[[nodiscard]] std::string data_url(std::string_view media_type, std::string_view bytes);

}  // namespace maquette::sim
