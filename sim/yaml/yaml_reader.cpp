#include "sim/yaml/yaml_reader.hpp"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <sstream>
#include <utility>

#include "sim/yaml/description_error.hpp"

namespace maquette::sim {
namespace {

/// What is known of an anchored node: its copy and its size.
struct Anchored {
  YamlNode node;
  std::size_t bytes = 0;
  int height = 0;
};

/// A sequence or mapping whose end has not come yet.
struct OpenNode {
  YamlNode node;
  YAML::anchor_t anchor = 0;
  std::size_t bytes_before = 0;  ///< of all nodes before it
  int height = 1;
  bool awaits_value = false;  ///< of a mapping: the last entry has only its key
};

void check_double_keys(const YamlNode& mapping) {
  std::vector<const YamlEntry*> sorted;
  sorted.reserve(mapping.entries.size());
  for (const YamlEntry& entry : mapping.entries) {
    sorted.push_back(&entry);
  }
  std::stable_sort(sorted.begin(), sorted.end(), [](const YamlEntry* left, const YamlEntry* right) {
    return left->key < right->key;
  });
  const auto twice = std::adjacent_find(
      sorted.begin(), sorted.end(),
      [](const YamlEntry* left, const YamlEntry* right) { return left->key == right->key; });
  if (twice != sorted.end()) {
    const YamlEntry& first = **twice;
    const YamlEntry& second = **std::next(twice);
    throw DescriptionError(second.place.position(),
                           "`" + second.key + "` is given twice; it stands already in line " +
                               std::to_string(first.place.line));
  }
}

/// Builds the tree from the parser's events.
class TreeBuilder : public YAML::EventHandler {
 public:
  TreeBuilder(std::shared_ptr<const std::string> file, int first_column)
      : file_(std::move(file)), first_column_(first_column) {}

  [[nodiscard]] YamlPlace place(const YAML::Mark& mark) const {
    const int line = std::max(mark.line, 0);
    const int column = std::max(mark.column, 0);
    return {file_, line + 1, column + (line == 0 ? first_column_ : 1)};
  }

  YamlNode take_root() { return std::move(root_); }

  void OnDocumentStart(const YAML::Mark& /*mark*/) override {}
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    add_leaf(new_node(YamlKind::null, mark, {}, {}), anchor);
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    add_leaf(new_node(YamlKind::scalar, mark, tag, value), anchor);
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto found = anchors_.find(anchor);
    if (found == anchors_.end()) {
      fail(mark, "an alias stands inside of what it refers to");
    }
    const Anchored& anchored = found->second;
    count_bytes(place(mark), anchored.bytes);
    check_nesting(mark, anchored.height);
    add(YamlNode{anchored.node}, anchored.height);
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value /*style*/) override {
    open(YamlKind::sequence, mark, tag, anchor);
  }
  void OnSequenceEnd() override { close(); }

  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value /*style*/) override {
    open(YamlKind::mapping, mark, tag, anchor);
  }
  void OnMapEnd() override {
    check_double_keys(open_.back().node);
    close();
  }

  [[noreturn]] void fail(const YAML::Mark& mark, const std::string& message) const {
    throw DescriptionError(place(mark).position(), message);
  }

 private:
  YamlNode new_node(YamlKind kind, const YAML::Mark& mark, const std::string& tag,
                    const std::string& text) {
    if (!tag.empty() && tag != "?" && tag != "!") {
      fail(mark, "tag `" + tag + "`: tags are not used in descriptions");
    }
    YamlNode node;
    node.kind = kind;
    node.place = place(mark);
    node.text = text;
    count_bytes(node.place, bytes_of(node));
    return node;
  }

  /// What a node takes in memory without those below it. An entry takes less than key and value.
  static std::size_t bytes_of(const YamlNode& node) { return sizeof(YamlNode) + node.text.size(); }

  /// Anchored nodes count again, since they are kept apart for their aliases.
  void count_bytes(const YamlPlace& place, std::size_t bytes) {
    bytes_ += bytes;
    if (bytes_ > k_tree_limit_bytes) {
      throw DescriptionError(place.position(),
                             "more than " + std::to_string(k_tree_limit_bytes >> 20U) +
                                 " MiB of values once aliases are replaced by what they stand for");
    }
  }

  void check_nesting(const YAML::Mark& mark, int height) const {
    if (static_cast<int>(open_.size()) + height > k_nesting_limit) {
      fail(mark, "nested deeper than " + std::to_string(k_nesting_limit) + " levels");
    }
  }

  void open(YamlKind kind, const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) {
    check_nesting(mark, 1);
    const std::size_t before = bytes_;
    open_.push_back({new_node(kind, mark, tag, {}), anchor, before});
  }

  void close() {
    OpenNode done = std::move(open_.back());
    open_.pop_back();
    if (done.anchor != YAML::NullAnchor) {
      const std::size_t bytes = bytes_ - done.bytes_before;
      count_bytes(done.node.place, bytes);
      anchors_[done.anchor] = {done.node, bytes, done.height};
    }
    add(std::move(done.node), done.height);
  }

  void add_leaf(YamlNode node, YAML::anchor_t anchor) {
    if (anchor != YAML::NullAnchor) {
      count_bytes(node.place, bytes_of(node));
      anchors_[anchor] = {node, bytes_of(node), 0};
    }
    add(std::move(node), 0);
  }

  void add(YamlNode node, int height) {
    if (open_.empty()) {
      root_ = std::move(node);
      return;
    }
    OpenNode& parent = open_.back();
    parent.height = std::max(parent.height, height + 1);
    if (parent.node.kind == YamlKind::sequence) {
      parent.node.items.push_back(std::move(node));
    } else if (parent.awaits_value) {
      YamlEntry& entry = parent.node.entries.back();
      entry.value = std::move(node);
      if (entry.value.kind == YamlKind::null) {
        entry.value.place = entry.place;  // the parser's mark is at what follows
      }
      parent.awaits_value = false;
    } else {
      if (node.kind != YamlKind::scalar) {
        throw DescriptionError(node.place.position(),
                               "a key must be a text, not " + node.kind_name());
      }
      parent.node.entries.push_back({std::move(node.text), node.place, {}});
      parent.awaits_value = true;
    }
  }

  std::shared_ptr<const std::string> file_;
  int first_column_;
  YamlNode root_;
  std::vector<OpenNode> open_;
  std::map<YAML::anchor_t, Anchored> anchors_;
  std::size_t bytes_ = 0;
};

/// Whether there is a tab before all else but spaces in a line, counted from 0.
bool is_indented_by_tab(const std::string& text, int line) {
  std::istringstream lines{text};
  std::string content;
  for (int i = 0; i <= line; ++i) {
    std::getline(lines, content);
  }
  const std::size_t first = content.find_first_not_of(' ');
  return first != std::string::npos && content[first] == '\t';
}

}  // namespace

YamlNode parse_yaml(const std::string& text, const std::string& file, int first_column) {
  std::istringstream stream{text};
  TreeBuilder builder{std::make_shared<const std::string>(file), first_column};
  try {
    YAML::Parser parser{stream};
    if (!parser.HandleNextDocument(builder)) {
      throw DescriptionError({file, 1, first_column}, "nothing is written here");
    }
    YamlNode root = builder.take_root();
    if (parser.HandleNextDocument(builder)) {
      throw DescriptionError(builder.take_root().place.position(),
                             "a second document starts here; one per file is allowed");
    }
    return root;
  } catch (const YAML::Exception& error) {
    builder.fail(error.mark, is_indented_by_tab(text, error.mark.line)
                                 ? "a tab indents this line; spaces are allowed"
                                 : error.msg);
  }
}

YamlNode parse_yaml(const InputFile& input) { return parse_yaml(input.content, input.path); }

YamlNode load_yaml(const std::string& file) { return parse_yaml(read_input(file)); }

}  // namespace maquette::sim
