#include "sim/page/data_url.hpp"

#include <string>

#include "tests/catch.hpp"

using maquette::sim::data_url;

TEST_CASE("bytes in an address are those of RFC 4648's examples, and any byte is") {
  CHECK(data_url("text/plain", "") == "data:text/plain;base64,");
  CHECK(data_url("a/b", "f") == "data:a/b;base64,Zg==");
  CHECK(data_url("a/b", "fo") == "data:a/b;base64,Zm8=");
  CHECK(data_url("a/b", "foo") == "data:a/b;base64,Zm9v");
  CHECK(data_url("a/b", "foob") == "data:a/b;base64,Zm9vYg==");
  CHECK(data_url("a/b", "fooba") == "data:a/b;base64,Zm9vYmE=");
  CHECK(data_url("a/b", "foobar") == "data:a/b;base64,Zm9vYmFy");
  CHECK(data_url("a/b", std::string("\xff\xfe\x00\x80", 4)) == "data:a/b;base64,//4AgA==");
}
