#include "sim/page/page.hpp"

#include <nlohmann/json.hpp>

#include "sim/page/assets.hpp"
#include "sim/page/data_url.hpp"

namespace maquette::sim {
namespace {

constexpr std::string_view k_script = ".js";
constexpr std::string_view k_library = "chart_library.js";

bool is_module(std::string_view name) {
  return name.size() > k_script.size() && name != k_library &&
         name.substr(name.size() - k_script.size()) == k_script;
}

/// The modules by the names under which they import each other: "#charts" is charts.js.
std::string import_map() {
  nlohmann::ordered_json imports = nlohmann::ordered_json::object();
  for (const Asset& asset : assets()) {
    if (is_module(asset.name)) {
      const std::string_view stem = asset.name.substr(0, asset.name.size() - k_script.size());
      imports["#" + std::string(stem)] = data_url("text/javascript", asset.content);
    }
  }
  return nlohmann::ordered_json{{"imports", imports}}.dump();
}

Html scripts() {
  return element("script", {{"type", "importmap"}}, Html{import_map()}) +
         element("script", {{"src", data_url("text/javascript", asset(k_library))}}, {}) +
         element("script", {{"type", "module"}}, Html{"import \"#report\";"});
}

Html head(const std::string& title) {
  return element(
      "head",
      void_element("meta", {{"charset", "utf-8"}}) +
          void_element("meta", {{"http-equiv", "Content-Security-Policy"},
                                {"content",
                                 "default-src 'none'; img-src data:; style-src "
                                 "'unsafe-inline'; script-src 'unsafe-inline' data:"}}) +
          void_element("meta",
                       {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}}) +
          void_element("meta", {{"name", "color-scheme"}, {"content", "light dark"}}) +
          element("title", title) + element("style", Html{std::string(asset("style.css"))}));
}

Html contents(const std::vector<Section>& sections) {
  Html links;
  for (const Section& section : sections) {
    links += element("li", element("a", {{"href", "#" + section.id}}, text(section.title)));
  }
  return element("nav", {{"aria-label", "Contents"}}, element("ul", links));
}

Html body_of(const Section& section) {
  return element(
      "section", {{"id", section.id}, {"aria-labelledby", section.id + "-title"}},
      element("h2", {{"id", section.id + "-title"}}, text(section.title)) + section.content);
}

}  // namespace

std::string page(const std::string& title, const std::vector<Section>& sections) {
  Html main;
  for (const Section& section : sections) {
    main += body_of(section);
  }
  const Html body = element("body", element("header", element("h1", title) + contents(sections)) +
                                        element("main", main) + scripts());
  return "<!DOCTYPE html>\n" + element("html",
                                       {{"lang", "en"}, {"xmlns", "http://www.w3.org/1999/xhtml"}},
                                       head(title) + body)
                                   .markup;
}

}  // namespace maquette::sim
