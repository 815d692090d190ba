#include <random>
#include <string>

#include "tests/catch.hpp"
#include "tests/sim/description_files.hpp"

namespace maquette::sim {
namespace {

std::size_t below(std::mt19937_64& random, std::size_t bound) { return random() % bound; }

/// Bytes that mean something to YAML, or that a text should not hold.
constexpr std::string_view k_sharp_bytes{"{}[]:,-#&*!|>'\"%@`?\n\t \\~<=.e0\0\x80\xff\xc3", 31};

std::string mutated(std::string text, std::mt19937_64& random) {
  const std::size_t changes = 1 + below(random, 4);
  for (std::size_t i = 0; i < changes && !text.empty(); ++i) {
    const std::size_t at = below(random, text.size());
    const std::size_t length = 1 + below(random, 8);
    switch (below(random, 6)) {
      case 0:
        text[at] = static_cast<char>(random() & 0xFF);
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, 1, k_sharp_bytes[below(random, k_sharp_bytes.size())]);
        break;
      case 3:
        text.insert(at, text.substr(below(random, text.size()), length * 4));
        break;
      case 4:
        text.resize(at);
        break;
      default:
        text[at] = k_sharp_bytes[below(random, k_sharp_bytes.size())];
    }
  }
  return text;
}

}  // namespace

TEST_CASE("a damaged description loads or is refused with its position") {
  const Description whole = load_text(k_rich_scene);
  const std::string complete = effective_configuration(whole.scene, whole.machine);
  std::mt19937_64 random{1984};
  int loaded = 0;
  int refused = 0;
  for (int i = 0; i < 2500; ++i) {
    const std::string text = mutated(i % 4 == 0 ? complete : k_rich_scene, random);
    INFO(text);
    try {
      const Description description = load_text(text);
      const std::string written = effective_configuration(description.scene, description.machine);
      const Description again = load_text(written);
      REQUIRE(effective_configuration(again.scene, again.machine) == written);
      ++loaded;
    } catch (const DescriptionError& error) {
      REQUIRE(std::string{error.what()}.find("scene.yaml:") != std::string::npos);
      ++refused;
    }
  }
  // Both happen, or the mutations show nothing.
  CHECK(loaded > 40);
  CHECK(refused > 1000);
}

TEST_CASE("a damaged override loads or is refused") {
  std::mt19937_64 random{1985};
  for (int i = 0; i < 1500; ++i) {
    const char* whole = i % 2 == 0 ? "board.arithmetic.multiply.clocks=415.5"
                                   : "object.union.0.place=[{scale: 2}, {translate: [1, 2, 3]}]";
    const std::string text = mutated(whole, random);
    INFO(text);
    try {
      static_cast<void>(load_text(k_rich_scene, {text}));
    } catch (const DescriptionError&) {
      continue;
    }
  }
}

}  // namespace maquette::sim
