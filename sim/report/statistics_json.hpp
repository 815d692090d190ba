#pragma once

#include <string>

#include "sim/report/flat_json.hpp"
#include "sim/report/statistics.hpp"

namespace maquette::sim {

/// The text of stats.json: keys in the order of their declaration, times as exact decimal seconds
/// (seconds.hpp), other reals with the fewest digits that read back as the same number. Throws
/// std::invalid_argument for a real that is not finite, which JSON cannot hold.
std::string statistics_json(const Statistics& statistics);

/// Reads what statistics_json has written. `name` is that of the file, for error messages. Throws
/// DescriptionError for what is not JSON, and for a key that is missing, unknown or has a wrong
/// value.
Statistics parse_statistics(const std::string& json, const std::string& name);

/// The same for statistics within another JSON text, of which `values` are the flat values.
Statistics read_statistics(const FlatValues& values, const std::string& name);

}  // namespace maquette::sim
