#include <string>

#include "sim/report/digest.hpp"
#include "tests/catch.hpp"

using maquette::sim::sha1_of;

namespace {

std::string digest(const std::string& text) { return sha1_of(text.data(), text.size()); }

}  // namespace

TEST_CASE("digests are those of FIPS 180's examples and of texts around whole blocks") {
  CHECK(digest("") == "da39a3ee5e6b4b0d3255bfef95601890afd80709");
  CHECK(digest("abc") == "a9993e364706816aba3e25717850c26c9cd0d89d");
  CHECK(digest("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
        "84983e441c3bd26ebaae4aa1f95129e5e54670f1");
  CHECK(digest(std::string(1'000'000, 'a')) == "34aa973cd4c4daa4f61eeb2bdbad27316534016f");
  CHECK(digest(std::string(55, 'x')) == "cef734ba81a024479e09eb5a75b6ddae62e6abf1");
  CHECK(digest(std::string(56, 'x')) == "901305367c259952f4e7af8323f480d59f81335b");
  CHECK(digest(std::string(63, 'x')) == "0ddc4e0cccd9a12850deb5abb0853a4425559fec");
  CHECK(digest(std::string(64, 'x')) == "bb2fa3ee7afb9f54c6dfb5d021f14b1ffe40c163");
  CHECK(digest(std::string(65, 'x')) == "78c741ddc482e4cdf8c474a0876347a0905b6233");
  CHECK(digest(std::string(119, 'x')) == "4300320394f7ee239bcdce7d3b8bcee173a0cd5c");
  CHECK(digest(std::string(120, 'x')) == "ceb2821639c4b6dcb10bce0e522ca2e608ce056d");
  CHECK(digest(std::string(128, 'x')) == "150fa3fbdc899bd0b8f95a9fb6027f564d953762");
}
