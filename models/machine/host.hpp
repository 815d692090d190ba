#pragma once

#include <tlm_utils/simple_initiator_socket.h>
#include <cstdint>
#include <systemc>
#include <tlm>
#include <vector>

#include "models/board/kvm02_parameters.hpp"
#include "models/bus/access_law.hpp"
#include "models/bus/bus_transaction.hpp"
#include "models/bus/duration.hpp"
#include "models/bus/versabus.hpp"
#include "models/machine/host_parameters.hpp"
#include "models/machine/host_statistics.hpp"

namespace maquette::models {

/// What the host writes into a memory: code and database of a board, or what boards share.
struct LoadImage {
  std::uint64_t base;  ///< bus address
  std::vector<unsigned char> bytes;
};

/// A bus of a machine, and what the host does on it.
struct Backplane {
  VersaBus& bus;
  std::vector<int> boards;        ///< masters of the bus, held until everything is loaded
  std::vector<LoadImage> images;  ///< in their order
};

/// The EXORmacs host: holds the boards in reset, writes images into memories as a bus master word
/// by word, and starts the boards. An image is padded to whole bus words.
///
/// Assumption: its bus interface has the access clocks and the slack of the boards'.
class Host : public sc_core::sc_module {
 public:
  /// Loads the images of one backplane after the other, then notifies `start`. Both buses and start
  /// are kept by reference. Whoever makes it binds a socket to each backplane and tells the host
  /// its number there.
  Host(const sc_core::sc_module_name& name, const HostParameters& parameters,
       const Kvm02Parameters& interface, std::vector<Backplane> backplanes,
       sc_core::sc_event& start);

  sc_core::sc_vector<tlm_utils::simple_initiator_socket<Host>> bus_masters;

  /// As a master of its buses.
  [[nodiscard]] const AccessLaw& access_law() const { return access_law_; }

  /// Its number on a backplane, told before the simulation starts.
  void set_master(std::size_t backplane, int master) { masters_[backplane] = master; }

  [[nodiscard]] const HostStatistics& statistics() const { return statistics_; }

 private:
  void run();
  void load(std::size_t backplane, LoadImage& image);

  AccessLaw access_law_;
  Duration word_time_;
  std::vector<Backplane> backplanes_;
  std::vector<int> masters_;  // the host's number on each
  BusTransaction transaction_;
  sc_core::sc_event& start_;
  HostStatistics statistics_;
};

}  // namespace maquette::models
