#pragma once

#include <string>
#include <vector>

namespace maquette::sim {

/// The cells of comma-separated values (RFC 4180), the line of headings first. `name` is that of
/// the file, for error messages. Throws DescriptionError, with the place, for a quotation without
/// end, and for lines of other lengths than the first.
[[nodiscard]] std::vector<std::vector<std::string>> parse_csv(const std::string& text,
                                                              const std::string& name);

}  // namespace maquette::sim
