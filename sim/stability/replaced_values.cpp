#include "sim/stability/replaced_values.hpp"

#include <optional>

#include "sim/scene/scene_description.hpp"
#include "sim/stability/random_cases.hpp"
#include "sim/stability/tally.hpp"
#include "sim/stability/trial_picture.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {

namespace {

constexpr const char* k_not_finite[] = {"nan", ".nan", "-nan", "inf", "-inf", ".inf", "1e999"};
constexpr const char* k_extreme[] = {"0",     "1e-300", "1e-30", "1e-12", "1e-9", "1e-6", "1e-3",
                                     "-1e-9", "64",     "1e3",   "1e6",   "1e9",  "-1e9", "1e12",
                                     "1e18",  "1e30",   "-1e30", "1e38",  "1e300"};
constexpr int k_extreme_count = sizeof k_extreme / sizeof k_extreme[0];
/// Of a scene with many control points about so many numbers are replaced.
constexpr std::size_t k_most_numbers = 40;
constexpr PictureFormat k_format{16, 12};

/// Pointers to all scalars below a node that start like a number.
void add_numbers(YamlNode& node, std::vector<YamlNode*>& numbers) {
  if (node.kind == YamlKind::scalar && node.text.find_first_of("0123456789") < 2) {
    numbers.push_back(&node);
  }
  for (YamlNode& item : node.items) {
    add_numbers(item, numbers);
  }
  for (YamlEntry& entry : node.entries) {
    add_numbers(entry.value, numbers);
  }
}

/// The scene, if it is allowed.
std::optional<Scene> allowed_scene(const YamlNode& root) {
  try {
    return read_scene(root);
  } catch (const DescriptionError&) {
    return std::nullopt;
  }
}

/// The text with its unit and another number.
std::string with_number(const std::string& text, const char* number) {
  const std::size_t unit = text.find(' ');
  return number + (unit == std::string::npos ? "" : text.substr(unit));
}

struct ReplacementTally {
  int not_refused = 0;
  int allowed = 0;
  int unsound = 0;

  void operator+=(const ReplacementTally& other) {
    not_refused += other.not_refused;
    allowed += other.allowed;
    unsound += other.unsound;
  }
};

template <class Real>
void replace(YamlNode& root, YamlNode& number, ReplacementTally& tally) {
  const std::string original = number.text;
  for (const char* value : k_not_finite) {
    number.text = with_number(original, value);
    tally.not_refused += allowed_scene(root) ? 1 : 0;
  }
  for (const char* value : k_extreme) {
    number.text = with_number(original, value);
    if (const std::optional<Scene> scene = allowed_scene(root)) {
      ++tally.allowed;
      tally.unsound += trial_picture<Real>(*scene, k_format).unsound > 0 ? 1 : 0;
    }
  }
  number.text = original;
}

/// Several numbers of a scene at extreme values together.
template <class Real>
void replace_several(trial::Random& random, const std::vector<ShippedScene>& scenes,
                     ReplacementTally& tally) {
  constexpr int k_most = 6;
  YamlNode root =
      scenes[static_cast<std::size_t>(random.below(static_cast<int>(scenes.size())))].written;
  std::vector<YamlNode*> numbers;
  add_numbers(root, numbers);
  for (int left = 2 + random.below(k_most - 1); left > 0; --left) {
    YamlNode& number =
        *numbers[static_cast<std::size_t>(random.below(static_cast<int>(numbers.size())))];
    const std::string original = number.text;
    number.text = with_number(original, k_extreme[random.below(k_extreme_count)]);
    if (!allowed_scene(root)) {
      number.text = original;
    }
  }
  const std::optional<Scene> scene = allowed_scene(root);
  ++tally.allowed;
  tally.unsound += trial_picture<Real>(*scene, k_format).unsound > 0 ? 1 : 0;
}

}  // namespace

template <class Real>
std::vector<StabilityRow> replaced_value_rows(const std::vector<ShippedScene>& scenes, int trials,
                                              int stride) {
  const char* group = "extreme";
  const auto add = [&](int number, ReplacementTally& tally) {
    YamlNode root = scenes[static_cast<std::size_t>(number)].written;
    std::vector<YamlNode*> numbers;
    add_numbers(root, numbers);
    const std::size_t step = 1 + numbers.size() * static_cast<std::size_t>(stride) / k_most_numbers;
    for (std::size_t i = 0; i < numbers.size(); i += step) {
      replace<Real>(root, *numbers[i], tally);
    }
  };
  const auto tally = tally_over<ReplacementTally>(static_cast<int>(scenes.size()), add);
  const auto several = tally_over<ReplacementTally>(trials, [&](int number, ReplacementTally& sum) {
    trial::Random random(static_cast<std::uint32_t>(number) + 5000000);
    replace_several<Real>(random, scenes, sum);
  });
  return {
      {group, "several at the limits", "scenes that are allowed", 1.0 * several.allowed, {}},
      {group, "several at the limits", "of them, pictures with a pixel without luminance",
       1.0 * several.unsound, 0},
      {group, "values that are not finite", "not refused on reading", 1.0 * tally.not_refused, 0},
      {group, "values at the limits", "scenes that are allowed", 1.0 * tally.allowed, {}},
      {group, "values at the limits", "of them, pictures with a pixel without luminance",
       1.0 * tally.unsound, 0}};
}

template std::vector<StabilityRow> replaced_value_rows<float>(const std::vector<ShippedScene>&, int,
                                                              int);
template std::vector<StabilityRow> replaced_value_rows<double>(const std::vector<ShippedScene>&,
                                                               int, int);

}  // namespace maquette::sim
