#pragma once

// The tests are written for Catch2 3, which Debian 13 has; with Debian 12's Catch2 2 this header adds
// the names that it spells otherwise.
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
#else
#include <catch2/catch.hpp>
namespace Catch {
using Detail::Approx;
namespace Matchers {
inline auto ContainsSubstring(const std::string& text) { return Contains(text); }
}  // namespace Matchers
}  // namespace Catch
#endif
#include <string>

using Catch::Approx;
