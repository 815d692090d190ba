#pragma once

#include <tlm_utils/simple_initiator_socket.h>
#include <cstdint>
#include <optional>
#include <systemc>
#include <tlm>
#include <vector>

#include "models/bus_transaction.hpp"
#include "models/instant.hpp"
#include "models/machine_parameters.hpp"
#include "models/versabus.hpp"

namespace maquette::models {

/// Code and database of one board, to be written into its RAM.
struct BoardImage {
  int master;              ///< the board's number on the bus
  std::uint64_t ram_base;  ///< bus address of its RAM
  std::vector<unsigned char> bytes;
};

struct HostStatistics {
  std::optional<Instant> finished;  ///< all boards loaded and started, when they are
  std::int64_t words = 0;
  Duration waited{};
  Duration transferred{};
};

/// The EXORmacs host: holds the boards in reset, writes their images into their RAM as a bus master
/// word by word, and starts them. An image is padded to whole bus words.
///
/// Assumption: its bus interface has the access clocks and the slack of the boards'.
class Host : public sc_core::sc_module {
 public:
  /// Loads `images` in their order; every board has one, an empty one when there is nothing to
  /// load. Then notifies `start`, which is kept by reference.
  Host(const sc_core::sc_module_name& name, const HostParameters& parameters,
       const Kvm02Parameters& interface, VersaBus& bus, std::vector<BoardImage> images,
       sc_core::sc_event& start);

  tlm_utils::simple_initiator_socket<Host> bus_master;

  [[nodiscard]] const HostStatistics& statistics() const { return statistics_; }

 private:
  void run();
  void load(BoardImage& image);

  Duration word_time_;
  VersaBus& bus_;
  int master_;
  std::vector<BoardImage> images_;
  BusTransaction transaction_;
  sc_core::sc_event& start_;
  HostStatistics statistics_;
};

}  // namespace maquette::models
