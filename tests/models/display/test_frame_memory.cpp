#include <stdexcept>

#include "models/display/frame_memory.hpp"
#include "models/display/shown_picture.hpp"
#include "tests/catch.hpp"
#include "tests/models/bus/traffic.hpp"

namespace {

using namespace maquette::models;
using namespace maquette::models::traffic;

FrameMemoryParameters small(int bits) {
  FrameMemoryParameters parameters;
  parameters.width = 8;
  parameters.height = 6;
  parameters.red_bits = parameters.green_bits = parameters.blue_bits = bits;
  parameters.video_priority = false;
  return parameters;
}

VideoTiming timing_of(const FrameMemoryParameters& parameters) {
  return {VideoParameters{}, parameters.width, parameters.height};
}

// Calls the bus port as the bus does: one access of a word.
class Probe : public sc_core::sc_module {
 public:
  Probe(const sc_core::sc_module_name& name, FrameMemory& memory)
      : sc_module(name), socket("socket") {
    socket.bind(memory.bus_ports[0]);
    access_.set_extension(&strobe_);
  }

  tlm_utils::simple_initiator_socket<Probe> socket;

  Duration access(tlm::tlm_command command, std::uint64_t address, std::vector<unsigned char>& word,
                  Instant strobe) {
    access_.set_command(command);
    access_.set_address(address);
    access_.set_data_ptr(word.data());
    access_.set_data_length(static_cast<unsigned>(word.size()));
    strobe_.instant = strobe;
    sc_core::sc_time delay = to_sc_time(strobe);
    socket->b_transport(access_, delay);
    return to_duration(delay) - strobe;
  }

  Duration write(std::uint64_t address, std::vector<unsigned char> word, Instant strobe) {
    return access(tlm::TLM_WRITE_COMMAND, address, word, strobe);
  }

  [[nodiscard]] tlm::tlm_response_status status() const { return access_.get_response_status(); }

 private:
  BusStrobe strobe_;  // before the payload, which frees its extensions
  tlm::tlm_generic_payload access_;
};

TEST_CASE("a pixel is two 16-bit words or one of 32 bits") {
  FrameMemory memory("memory", small(8), timing_of(small(8)), 0x102030, false);
  Probe probe("probe", memory);
  sc_core::sc_start(sc_core::SC_ZERO_TIME);
  CHECK(memory.picture().at(3, 0) == 0x102030);
  CHECK(memory.untouched(3, 0));
  CHECK(probe.write(12, {0xAB, 0xCD}, Instant{0}) == Duration{250'000});
  CHECK(memory.picture().at(3, 0) == 0xABCD30);
  CHECK_FALSE(memory.written_once(3, 0));
  probe.write(14, {0xEF, 0x99}, Instant{0});
  CHECK(memory.picture().at(3, 0) == 0xABCDEF);
  CHECK(memory.written_once(3, 0));
  probe.write(4 * 47, {1, 2, 3, 4}, Instant{0});
  CHECK(memory.picture().at(7, 5) == 0x010203);
  CHECK(memory.written_once(7, 5));
  probe.write(14, {0xEF, 0}, Instant{0});
  CHECK_FALSE(memory.written_once(3, 0));
  std::vector<unsigned char> word(4);
  probe.access(tlm::TLM_READ_COMMAND, 12, word, Instant{0});
  CHECK(word == std::vector<unsigned char>{0xAB, 0xCD, 0xEF, 0});
  for (int again = 0; again < 40; ++again) {
    probe.write(16, {1, 1}, Instant{0});  // the count saturates, its neighbour's stays
  }
  CHECK_FALSE(memory.written_once(4, 0));
  CHECK(memory.untouched(5, 0));
  probe.write(4 * 48, {1, 1}, Instant{0});
  CHECK(probe.status() == tlm::TLM_ADDRESS_ERROR_RESPONSE);
  probe.write(4 * 48 - 2, {1, 1, 1, 1}, Instant{0});
  CHECK(probe.status() == tlm::TLM_ADDRESS_ERROR_RESPONSE);
}

TEST_CASE("planes keep the top bits and show full code as full scale") {
  FrameMemoryParameters parameters = small(5);
  parameters.blue_bits = 1;
  FrameMemory memory("memory", parameters, timing_of(parameters), 0xFFFFFF, false);
  Probe probe("probe", memory);
  sc_core::sc_start(sc_core::SC_ZERO_TIME);
  CHECK(memory.picture().at(0, 0) == 0xFFFFFF);
  probe.write(0, {0x87, 0x08, 0x7F, 0}, Instant{0});
  // 0x87 has code 16 of 31, 0x08 code 1, 0x7F code 0 of 1.
  CHECK(memory.picture().at(0, 0) == 0x840800);
  std::vector<unsigned char> word(4);
  probe.access(tlm::TLM_READ_COMMAND, 0, word, Instant{0});
  CHECK(word == std::vector<unsigned char>{0x80, 0x08, 0, 0});
}

TEST_CASE("the video reader's slots delay the bus") {
  FrameMemoryParameters parameters = small(8);
  parameters.video_priority = true;
  FrameMemory memory("memory", parameters, timing_of(parameters), 0, false);
  Probe probe("probe", memory);
  sc_core::sc_start(sc_core::SC_ZERO_TIME);
  const Instant slot = 22 * Duration{64'000'000} + Duration{10'500'000};  // line 23
  CHECK(probe.write(0, {0, 0}, slot - Duration{250'000}) == Duration{250'000});
  CHECK(probe.write(0, {0, 0}, slot - Duration{249'999}) == Duration{249'999 + 400'000 + 250'000});
  CHECK(probe.write(0, {0, 0}, slot) == Duration{650'000});
  CHECK(probe.write(0, {0, 0}, slot + Duration{399'999}) == Duration{250'001});
  CHECK(probe.write(0, {0, 0}, slot + Duration{400'000}) == Duration{250'000});
}

FrameMemoryParameters comparing(int depth_bits) {
  FrameMemoryParameters parameters = small(5);
  parameters.depth_bits = depth_bits;
  parameters.depth_compare = true;
  return parameters;
}

void check_nearest(int depth_bits) {
  const FrameMemoryParameters parameters = comparing(depth_bits);
  const PixelFormat format(parameters);
  FrameMemory memory("memory", parameters, timing_of(parameters), 0x102030, false);
  Probe probe("probe", memory);
  sc_core::sc_start(sc_core::SC_ZERO_TIME);
  std::vector<std::uint32_t> expected(48, format.written(0x102030, 0xFFFF) & format.kept());
  std::mt19937 generator(static_cast<unsigned>(depth_bits));
  for (int one = 0; one < 2000; ++one) {
    const auto pixel = static_cast<std::size_t>(below(generator, 48));
    const auto depth =
        static_cast<std::uint16_t>(below(generator, 4) == 0 ? 0xFFFF : below(generator, 0x10000));
    const std::uint32_t bytes =
        format.written(static_cast<std::uint32_t>(below(generator, 1 << 24)), depth);
    const std::vector<unsigned char> written{
        static_cast<unsigned char>(bytes >> 24U), static_cast<unsigned char>(bytes >> 16U),
        static_cast<unsigned char>(bytes >> 8U), static_cast<unsigned char>(bytes)};
    if (below(generator, 2) == 0) {
      CHECK(probe.write(4 * pixel, written, Instant{0}) == 2 * parameters.access_time);
    } else {
      CHECK(probe.write(4 * pixel, {written[0], written[1]}, Instant{0}) == parameters.access_time);
      CHECK(probe.write(4 * pixel + 2, {written[2], written[3]}, Instant{0}) ==
            2 * parameters.access_time);
    }
    const std::uint32_t kept = bytes & format.kept();
    if (format.depth(kept) <= format.depth(expected[pixel])) {
      expected[pixel] = kept;
    }
    REQUIRE(memory.picture().pixels[pixel] == format.colour(expected[pixel]));
    REQUIRE(memory.depths().values[pixel] == format.depth(expected[pixel]));
  }
}

TEST_CASE("where depths are compared each pixel is the last of the nearest that were written") {
  check_nearest(16);
}

TEST_CASE("depths are compared by the planes that there are") { check_nearest(3); }

TEST_CASE("reading the depth and writing it are two accesses, each clear of the video slots") {
  FrameMemoryParameters parameters = comparing(16);
  parameters.video_priority = true;
  FrameMemory memory("memory", parameters, timing_of(parameters), 0, false);
  Probe probe("probe", memory);
  sc_core::sc_start(sc_core::SC_ZERO_TIME);
  const Instant slot = 22 * Duration{64'000'000} + Duration{10'500'000};  // line 23
  CHECK(probe.write(2, {0, 0}, slot - Duration{500'000}) == Duration{500'000});
  CHECK(probe.write(2, {0, 0}, slot - Duration{499'999}) == Duration{499'999 + 400'000 + 250'000});
  CHECK(probe.write(0, {0, 0}, slot - Duration{250'000}) == Duration{250'000});
  std::vector<unsigned char> word(2);
  CHECK(probe.access(tlm::TLM_READ_COMMAND, 2, word, slot - Duration{250'000}) ==
        Duration{250'000});
}

TEST_CASE("what makes no frame memory is refused") {
  FrameMemoryParameters depthless = small(8);
  depthless.depth_compare = true;
  CHECK_THROWS_AS(FrameMemory("depthless", depthless, timing_of(small(8)), 0, false),
                  std::invalid_argument);
  CHECK_THROWS_AS(FrameMemory("nine", small(9), timing_of(small(8)), 0, false),
                  std::invalid_argument);
  CHECK_THROWS_AS(FrameMemory("none", small(0), timing_of(small(8)), 0, false),
                  std::invalid_argument);
  FrameMemory memory("memory", small(8), timing_of(small(8)), 0, false);
  CHECK_THROWS_AS(memory.picture_at(Instant{0}), std::logic_error);
}

TEST_CASE("a write that is done in the instant of the scan is shown, a tick later it is not") {
  const FrameMemoryParameters parameters = small(8);
  const VideoTiming timing = timing_of(parameters);
  FrameMemory memory("memory", parameters, timing, 0, true);
  Probe probe("probe", memory);
  sc_core::sc_start(sc_core::SC_ZERO_TIME);
  const Instant far{39'000'000'000};
  const Instant first = *timing.last_scan(0, 0, far);
  const Instant second = *timing.last_scan(1, 0, far);
  probe.write(0, {9, 9}, first - parameters.access_time);
  probe.write(4, {9, 9}, second - parameters.access_time + k_tick);
  const Picture shown = shown_picture(memory, timing, far);
  CHECK(shown.at(0, 0) == 0x090900);
  CHECK(shown.at(1, 0) == 0);
  CHECK(memory.picture_at(far).at(1, 0) == 0x090900);
}

TEST_CASE("snapshots: the memory and the screen at any instant") {
  const FrameMemoryParameters parameters = small(8);
  const VideoTiming timing = timing_of(parameters);
  FrameMemory memory("memory", parameters, timing, 0x000001, true);
  Probe probe("probe", memory);
  sc_core::sc_start(sc_core::SC_ZERO_TIME);
  std::mt19937 generator(4);
  struct Write {
    Instant done;
    int column;
    int row;
    std::uint32_t rgb;
  };
  std::vector<Write> writes;
  Instant strobe{0};
  for (int one = 0; one < 400; ++one) {
    strobe += Duration{below(generator, 1'000'000'000)};
    const Write write{strobe + parameters.access_time, below(generator, 8), below(generator, 6),
                      static_cast<std::uint32_t>(below(generator, 1 << 24))};
    probe.write(
        static_cast<std::uint64_t>(4 * (8 * write.row + write.column)),
        {static_cast<unsigned char>(write.rgb >> 16U), static_cast<unsigned char>(write.rgb >> 8U),
         static_cast<unsigned char>(write.rgb), 0},
        strobe);
    writes.push_back(write);
  }
  const auto held = [&](int column, int row, Instant instant) {
    std::uint32_t rgb = 1;
    for (const Write& write : writes) {
      if (write.column == column && write.row == row && write.done <= instant) {
        rgb = write.rgb;
      }
    }
    return rgb;
  };
  for (int one = 0; one < 60; ++one) {
    const Write& near = writes[static_cast<std::size_t>(below(generator, 400))];
    const Instant instant = near.done + Duration{below(generator, 3) - 1};
    const Picture in_memory = memory.picture_at(instant);
    const Picture on_screen = shown_picture(memory, timing, instant);
    for (int row = 0; row < 6; ++row) {
      for (int column = 0; column < 8; ++column) {
        REQUIRE(in_memory.at(column, row) == held(column, row, instant));
        const auto scanned = timing.last_scan(column, row, instant);
        REQUIRE(on_screen.at(column, row) == (scanned ? held(column, row, *scanned) : 1));
      }
    }
  }
  CHECK(memory.picture_at(strobe + parameters.access_time).pixels == memory.picture().pixels);
}

}  // namespace
