#pragma once

#include <vector>

#include "firmware/database.hpp"

namespace maquette::sim {

/// The database as the host writes it into a board's RAM: big-endian, by fields, every number a
/// word or an IEEE single; exactly firmware::database_bytes long.
std::vector<unsigned char> database_image(const firmware::Database<float>& database);

}  // namespace maquette::sim
