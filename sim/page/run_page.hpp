#pragma once

#include <string>

#include "sim/page/run_files.hpp"

namespace maquette::sim {

/// What a page is called among the results that it shows.
inline constexpr const char* k_page_name = "report.html";

/// The page of one run. Throws DescriptionError for results that are missing or damaged.
[[nodiscard]] std::string run_page(const RunFiles& files, const std::string& data_directory);

}  // namespace maquette::sim
