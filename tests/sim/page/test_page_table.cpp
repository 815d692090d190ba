#include "sim/page/page_table.hpp"

#include "tests/catch.hpp"
#include "tests/sim/page/well_formed.hpp"

using namespace maquette::sim;
using namespace maquette::tests;
using Catch::Matchers::ContainsSubstring;

TEST_CASE("A table has its headings, row by row its cells, and says what they head") {
  PageTable table{"Boards", {{"board"}, {"time s", true}}, {{"board<0>", "1.5"}, {"board1", ""}}};
  const std::string markup = table_element(table).markup;
  CHECK(ill_formed(markup).empty());
  CHECK_THAT(markup, ContainsSubstring("<caption>Boards</caption>"));
  CHECK_THAT(markup, ContainsSubstring("<th scope=\"col\">board</th>"));
  CHECK_THAT(markup, ContainsSubstring("<th scope=\"col\" class=\"number\">time s</th>"));
  CHECK_THAT(markup, ContainsSubstring("<th scope=\"row\">board&lt;0&gt;</th>"));
  CHECK_THAT(markup, ContainsSubstring("<td class=\"number\">1.5</td>"));
  CHECK_THAT(markup, !ContainsSubstring("filterable"));
  table.is_long = true;
  CHECK_THAT(table_element(table).markup, ContainsSubstring("filterable"));
}

TEST_CASE("Cells are as deep as their shade") {
  const PageTable table{"Waits", {{"waits"}, {"for a", true}}, {{"b", "2"}}, false, false,
                        {{0.25}}};
  CHECK_THAT(table_element(table).markup,
             ContainsSubstring("<td style=\"--shade:0.250\" class=\"number\">2</td>"));
}

TEST_CASE("Definitions are terms with their meaning") {
  CHECK(definitions({{"a", "1 & 2"}}).markup == "<dl><dt>a</dt>\n<dd>1 &amp; 2</dd>\n</dl>\n");
}
