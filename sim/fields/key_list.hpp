#pragma once

#include <string_view>
#include <vector>

#include "sim/fields/declaration.hpp"

namespace maquette::sim {

/// The visitor of declared fields that lists the keys at the top.
class KeyList {
 public:
  template <class Value, class Type>
  void field(const Declaration& declaration, const Value& /*value*/, const Type& /*type*/) {
    keys_.push_back(declaration.key);
  }

  template <class Body>
  void group(const Declaration& declaration, const Body& /*body*/) {
    keys_.push_back(declaration.key);
  }

  template <class Body>
  void optional_group(const Declaration& declaration, const bool& /*present*/,
                      const Body& /*body*/) {
    keys_.push_back(declaration.key);
  }

  [[nodiscard]] const std::vector<std::string_view>& keys() const { return keys_; }

 private:
  std::vector<std::string_view> keys_;
};

}  // namespace maquette::sim
