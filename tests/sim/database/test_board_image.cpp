#include "sim/database/board_image.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>

#include "models/board/mc68000/mc68000.hpp"
#include "sim/database/board_stack.hpp"
#include "sim/database/prepared_scene.hpp"
#include "sim/run/host_arithmetic.hpp"
#include "sim/scene/description_loader.hpp"
#include "tests/catch.hpp"

using namespace maquette;
using namespace maquette::models::mc68000;

namespace {

constexpr std::uint32_t k_frame_base = 0x800000;
constexpr std::int32_t k_stack_bytes = 16384;

/// A frame memory that remembers what was written, in words.
class WrittenWords final : public ExternalBus {
 public:
  BusReply access(const BusRequest& request, const Account& /*account*/) override {
    CHECK(request.kind == BusRequest::Kind::write);
    CHECK(request.size == OperandSize::word);
    words_[request.address] = request.value;
    ++writes_;
    return {};
  }

  /// The colour of a pixel, or nothing when it was not written.
  [[nodiscard]] std::int64_t pixel(int column, int row, int width) const {
    const std::uint32_t address =
        k_frame_base + 4 * static_cast<std::uint32_t>(row * width + column);
    const auto high = words_.find(address);
    const auto low = words_.find(address + 2);
    return high == words_.end() || low == words_.end() ? -1
                                                       : (high->second << 16U | low->second) >> 8U;
  }

  [[nodiscard]] std::int64_t writes() const { return writes_; }

 private:
  std::map<std::uint32_t, std::uint32_t> words_;
  std::int64_t writes_ = 0;
};

sim::Description coarse_description(const std::string& scene) {
  const std::string project = MAQUETTE_PROJECT_DIRECTORY;
  return sim::load_description({project + "/scenes/" + scene,
                                {},
                                {"frame_memory.width=24 pixels", "frame_memory.height=18 pixels"},
                                project});
}

firmware::BoardOrder whole_frame(int width) {
  firmware::BoardOrder order{};
  order.unit_step = 1;
  order.unit_width = 1;
  order.unit_height = 1;
  order.frame_width = static_cast<std::uint16_t>(width);
  order.frame_memory = k_frame_base;
  return order;
}

constexpr unsigned char k_untouched = 0xA5;

/// Paints the stack, so that it can be told how far down the program goes.
void paint_stack(sim::BoardImage& image) {
  std::fill(image.ram.end() - k_stack_bytes, image.ram.begin() + image.stack, k_untouched);
}

std::int64_t used_stack(const sim::BoardImage& image) {
  const auto lowest = std::find_if(image.ram.end() - k_stack_bytes, image.ram.end(),
                                   [](unsigned char byte) { return byte != k_untouched; });
  return image.ram.begin() + image.stack - lowest;
}

/// The arithmetic of IEEE numbers is the host's.
Stop run(sim::BoardImage& image, ExternalBus& bus) {
  NativeCalls routines;
  firmware::Work work{};
  Mc68000 processor({image.ram.data(), static_cast<std::uint32_t>(image.ram.size())}, bus);
  processor.registers().program_counter = sim::beginning_of(image.program);
  processor.registers().stack() = image.stack;
  if (image.program.code->numbers == firmware::NumberFormat::ieee_single) {
    sim::host_arithmetic(image.program)(routines, work);
  }
  processor.use(routines);
  return processor.run({});
}

void compare_with_firmware(const std::string& scene, firmware::NumberFormat numbers) {
  INFO(scene << ", format " << static_cast<int>(numbers));
  const sim::Description description = coarse_description(scene);
  const sim::PictureFormat format = sim::picture_format_of(description.machine);
  const sim::PreparedScene<float> prepared(sim::packed_scene<float>(description.scene, format));
  sim::SynthesisArea<float> area(prepared.frame().database);
  sim::BoardImage image =
      sim::board_image(numbers, prepared, area.view(), whole_frame(format.width),
                       {1U << 20U, 0x800, 1024, 32, 0, 0, k_stack_bytes, 0});
  paint_stack(image);
  WrittenWords memory;
  const Stop stop = run(image, memory);
  INFO(name_of(stop.reason) << " at " << stop.instruction_address);
  REQUIRE(stop.reason == StopReason::stop_instruction);
  CHECK(used_stack(image) > 0);
  CHECK(used_stack(image) <=
        sim::board_stack_bytes(
            sim::needed_pieces(sim::program_code(numbers), prepared.frame().database.needs),
            prepared.packed().tree_height));

  const firmware::Rectangle& zone = prepared.frame().prepared.useful_zone;
  std::int64_t pixels = 0;
  int different = 0;
  for (std::int16_t row = zone.first_row; row < zone.end_row; ++row) {
    for (std::int16_t column = zone.first_column; column < zone.end_column; ++column) {
      ++pixels;
      const firmware::Pixel pixel =
          firmware::synthesize(prepared.frame(), area.view(), column, row);
      different += memory.pixel(column, row, format.width) == pixel.rgb ? 0 : 1;
    }
  }
  CHECK(pixels > 0);
  CHECK(different == 0);
  CHECK(memory.writes() == 2 * pixels);
}

void compare_all_scenes(firmware::NumberFormat numbers) {
  const std::filesystem::path scenes = std::string(MAQUETTE_PROJECT_DIRECTORY) + "/scenes";
  for (const auto& entry : std::filesystem::directory_iterator(scenes)) {
    if (entry.path().extension() == ".yaml") {
      compare_with_firmware(entry.path().filename(), numbers);
    }
  }
  for (const auto& entry : std::filesystem::directory_iterator(scenes / "primitives")) {
    compare_with_firmware("primitives/" + entry.path().filename().string(), numbers);
  }
}

TEST_CASE("the program of a board has the firmware's pixels, bit for bit, on the stack as told") {
  compare_all_scenes(firmware::NumberFormat::ffp);
}

TEST_CASE("so it has with IEEE numbers") {
  compare_all_scenes(firmware::NumberFormat::ieee_single);
}

TEST_CASE("what does not fit into a board's RAM is refused") {
  const sim::Description description = coarse_description("photo4.yaml");
  const sim::PictureFormat format = sim::picture_format_of(description.machine);
  const sim::PreparedScene<float> prepared(sim::packed_scene<float>(description.scene, format));
  sim::SynthesisArea<float> area(prepared.frame().database);
  const auto image_in = [&](std::uint32_t ram_bytes) {
    return sim::board_image(firmware::NumberFormat::ffp, prepared, area.view(),
                            whole_frame(format.width),
                            {ram_bytes, 0x800, 1024, 32, 0, 0, k_stack_bytes, 0});
  };
  const sim::BoardImage image = image_in(1U << 20U);
  CHECK_THROWS_AS(image_in(image.loaded_end), std::out_of_range);
  CHECK_THROWS_AS(image_in(0x1000), std::out_of_range);
}

TEST_CASE("a larger arithmetic package than the program's has its room before the database") {
  const sim::Description description = coarse_description("photo4.yaml");
  const sim::PictureFormat format = sim::picture_format_of(description.machine);
  const sim::PreparedScene<float> prepared(sim::packed_scene<float>(description.scene, format));
  sim::SynthesisArea<float> area(prepared.frame().database);
  for (const std::uint32_t package_bytes : {1U, 100U, 6144U, 6145U}) {
    const sim::BoardImage image = sim::board_image(
        firmware::NumberFormat::ieee_single, prepared, area.view(), whole_frame(format.width),
        {1U << 20U, 0x800, 1024, 32, 0, 0, k_stack_bytes, package_bytes});
    const std::uint32_t room = image.database - image.program.package;
    CHECK(room >= image.program.code->package.bytes.size());
    CHECK(room >= package_bytes);
    CHECK(room <= std::max(package_bytes + 1, 16U));
    CHECK(image.database % 2 == 0);
  }
}

}  // namespace
