#include "sim/page/html.hpp"

#include <random>

#include "tests/catch.hpp"
#include "tests/sim/page/well_formed.hpp"

using namespace maquette::sim;
using namespace maquette::tests;

TEST_CASE("No text is taken for markup") {
  CHECK(text("<script>alert(\"a & b\")</script>").markup ==
        "&lt;script&gt;alert(&quot;a &amp; b&quot;)&lt;/script&gt;");
  CHECK(element("p", "1 < 2").markup == "<p>1 &lt; 2</p>\n");
  CHECK(void_element("img", {{"alt", "\"/><script>"}}).markup ==
        "<img alt=\"&quot;/&gt;&lt;script&gt;\"/>");
}

TEST_CASE("Texts that are UTF-8 stay, what no page may hold is replaced") {
  CHECK(text("Synth\xC3\xA8se \xE2\x82\xAC \xF0\x9F\x98\x80\n").markup ==
        "Synth\xC3\xA8se \xE2\x82\xAC \xF0\x9F\x98\x80\n");
  const std::string replaced = "\xEF\xBF\xBD";
  CHECK(text(std::string_view("a\0b", 3)).markup == "a" + replaced + "b");
  CHECK(text("\x1B[1m").markup == replaced + "[1m");
  CHECK(text("\xFF"
             "a")
            .markup == replaced + "a");
  CHECK(text("\xC3").markup == replaced);
  CHECK(text("\xE2\x82<").markup == replaced + replaced + "&lt;");
}

TEST_CASE("Any bytes make markup that is well-formed") {
  std::mt19937 random(7);
  for (int i = 0; i < 2000; ++i) {
    std::string bytes;
    for (auto length = random() % 40; length > 0; --length) {
      bytes += random() % 2 == 0 ? "<>&\"/= -!?]"[random() % 11] : static_cast<char>(random());
    }
    const Html markup = element("p", {{"title", bytes}}, text(bytes)) +
                        data_element("data", "\"" + bytes + "\"") + folded(bytes, text(bytes));
    INFO(markup.markup);
    CHECK(ill_formed(markup.markup).empty());
  }
}

TEST_CASE("The check of well-formedness finds what is not") {
  for (const char* wrong : {"<p>", "</p>", "<p></b>", "a & b", "<p", "<a><b></a></b>", "<br>"}) {
    INFO(wrong);
    CHECK_FALSE(ill_formed(wrong).empty());
  }
  CHECK(ill_formed("<!DOCTYPE html>\n<p title=\"a\">b &amp; c<br/></p>").empty());
}

TEST_CASE("Data within a page ends no script and stays the same JSON") {
  CHECK(data_element("d", R"({"name":"</script><!--&"})").markup ==
        "<script type=\"application/json\" id=\"d\">"
        R"({"name":"\u003c/script\u003e\u003c!--\u0026"})"
        "</script>\n");
}
