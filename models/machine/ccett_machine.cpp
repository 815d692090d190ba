#include "models/machine/ccett_machine.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "models/board/long_word.hpp"
#include "models/bus/kernel_time.hpp"

namespace maquette::models {

namespace {

bool shares_something(const MachineParameters& parameters) {
  return is_claimed(parameters.allotment.assignment) || is_shared(parameters.board.database);
}

// The header of zeros, then the database, to the end of a long word.
std::vector<unsigned char> shared_content(const std::vector<unsigned char>& database) {
  const std::size_t used_bytes = SharedWindow::k_header_bytes + database.size();
  std::vector<unsigned char> content((used_bytes + k_long_bytes - 1) / k_long_bytes * k_long_bytes);
  std::copy(database.begin(), database.end(), content.begin() + SharedWindow::k_header_bytes);
  return content;
}

/// What the host writes of the content of shared memory: its header, and of the database what is to
/// be loaded.
std::vector<ImageRange> shared_ranges(const FrameSetup& setup, std::size_t bytes) {
  if (!setup.shared_loaded) {
    return {{0, bytes}};
  }
  std::vector<ImageRange> ranges{{0, SharedWindow::k_header_bytes}};
  for (const ImageRange& range : *setup.shared_loaded) {
    ranges.push_back(
        {SharedWindow::k_header_bytes + range.first, SharedWindow::k_header_bytes + range.end});
  }
  return ranges;
}

void add_images(std::uint64_t base, const std::vector<unsigned char>& bytes,
                const std::vector<ImageRange>& ranges, std::vector<LoadImage>& images) {
  for (const ImageRange& range : ranges) {
    images.push_back({base + range.first,
                      {bytes.begin() + static_cast<std::ptrdiff_t>(range.first),
                       bytes.begin() + static_cast<std::ptrdiff_t>(range.end)}});
  }
}

std::string bus_name(std::size_t port) { return port == 0 ? "bus" : "bus" + std::to_string(port); }

PixelStore pixel_store(const MachineParameters& parameters, const FrameSetup& setup) {
  return {interlace_of(parameters.allotment, static_cast<int>(parameters.boards.size())),
          parameters.frame_memory.width, parameters.frame_memory.height, setup.pixel_address};
}

void check_distribution(const MachineParameters& parameters, const FrameSetup& setup) {
  const AllotmentParameters& allotment = parameters.allotment;
  if (allotment.order != Allotment::interlaced || is_claimed(allotment.assignment) ||
      parameters.frame_memory.ports > 1 || keeps_line(parameters.board.pixel_write)) {
    throw std::invalid_argument(
        "boards keep the pixels of a fixed interlace alone, one by one, on one backplane");
  }
  if (pixel_store(parameters, setup).bytes() + setup.pixel_address >
      static_cast<std::uint64_t>(parameters.board.ram_bytes)) {
    throw std::invalid_argument("a board's own pixels do not fit into its RAM");
  }
}

void check(const MachineParameters& parameters, const FrameSetup& setup) {
  const PixelRectangle& zone = setup.useful_zone;
  if (zone.column0 < 0 || zone.row0 < 0 || zone.width < 0 || zone.height < 0 ||
      zone.column0 + zone.width > parameters.frame_memory.width ||
      zone.row0 + zone.height > parameters.frame_memory.height) {
    throw std::invalid_argument("the useful zone must lie within the frame memory");
  }
  if (!setup.images.empty() && setup.images.size() != parameters.boards.size()) {
    throw std::invalid_argument("there must be one image per board");
  }
  if (is_claimed(parameters.allotment.assignment) && parameters.frame_memory.ports > 1) {
    throw std::invalid_argument("units on demand need a frame memory of one port");
  }
  if (is_shared(parameters.board.database) == setup.shared_database.empty()) {
    throw std::invalid_argument("a shared database must be given, and only when it is shared");
  }
  if (is_distributed(parameters.frame_memory)) {
    check_distribution(parameters, setup);
  }
  for (const auto& image : setup.images) {
    if (setup.image_address + image.size() > static_cast<std::size_t>(parameters.board.ram_bytes)) {
      throw std::invalid_argument("a board's image is larger than its RAM");
    }
    for (const ImageRange& range : setup.loaded.value_or(std::vector<ImageRange>{})) {
      if (range.first > range.end || range.end > image.size()) {
        throw std::invalid_argument("a part of an image must lie within it");
      }
    }
  }
  for (const ImageRange& range : setup.shared_loaded.value_or(std::vector<ImageRange>{})) {
    if (range.first > range.end || range.end > setup.shared_database.size()) {
      throw std::invalid_argument("a part of the shared database must lie within it");
    }
  }
}

}  // namespace

CcettMachine::CcettMachine(const sc_core::sc_module_name& name, const MachineParameters& parameters,
                           PixelSource& source, const FrameSetup& setup)
    : sc_module(name),
      video_(parameters.video),
      zone_(setup.useful_zone),
      allotment_(parameters.allotment, zone_, static_cast<int>(parameters.boards.size())),
      start_("start"),
      timing_(parameters.video, parameters.frame_memory.width, parameters.frame_memory.height),
      frame_memory_("frame_memory", parameters.frame_memory, timing_, setup.background,
                    setup.keep_log) {
  check(parameters, setup);
  if (is_distributed(parameters.frame_memory)) {
    own_pixels_ = pixel_store(parameters, setup);
  }
  const MachineAddresses addresses = machine_addresses(parameters, setup.shared_database.size());
  std::vector<Backplane> backplanes = make_buses(parameters, addresses);
  if (shares_something(parameters)) {
    const std::vector<unsigned char> content = shared_content(setup.shared_database);
    make_shared_memory(parameters, addresses, content.size());
    if (!setup.images.empty()) {
      add_images(addresses.shared.base, content, shared_ranges(setup, content.size()),
                 backplanes[0].images);
    }
  }
  for (std::size_t index = 0; index < parameters.boards.size(); ++index) {
    Backplane& backplane = backplanes[index % backplanes.size()];
    backplane.boards.push_back(make_board(index, parameters, addresses, backplane.bus, source));
    if (!setup.images.empty()) {
      const std::vector<unsigned char>& image = setup.images[index];
      add_images(addresses.ram(index) + setup.image_address, image,
                 setup.loaded.value_or(std::vector<ImageRange>{{0, image.size()}}),
                 backplane.images);
    }
  }
  if (setup.program) {
    slots_.emplace(setup.program->threads);
    for (std::size_t index = 0; index < boards_.size(); ++index) {
      boards_[index]->execute(setup.program->entry, setup.program->host_routines,
                              setup.program->resident.at(index), *slots_);
    }
  }
  if (has_units(parameters.units)) {
    make_units(parameters, addresses, setup, backplanes[0]);
  }
  make_host(parameters, std::move(backplanes));
}

std::vector<Backplane> CcettMachine::make_buses(const MachineParameters& parameters,
                                                const MachineAddresses& addresses) {
  std::vector<Backplane> backplanes;
  const auto ports = static_cast<std::size_t>(parameters.frame_memory.ports);
  for (std::size_t port = 0; port < ports; ++port) {
    buses_.push_back(std::make_unique<VersaBus>(bus_name(port).c_str(), parameters.bus));
    VersaBus& bus = *buses_.back();
    if (!own_pixels_) {
      bus.attach_slave(frame_memory_.bus_ports[port],
                       {frame_memory_.name(), addresses.frame.base, frame_memory_.size_bytes()});
    }
    backplanes.push_back({bus, {}, {}});
  }
  return backplanes;
}

void CcettMachine::make_shared_memory(const MachineParameters& parameters,
                                      const MachineAddresses& addresses, std::size_t bytes) {
  shared_memory_.emplace("shared_memory", parameters.shared_memory, bytes,
                         parameters.frame_memory.ports);
  for (std::size_t port = 0; port < buses_.size(); ++port) {
    buses_[port]->attach_slave(
        shared_memory_->bus_ports[port],
        {shared_memory_->name(), addresses.shared.base, shared_memory_->size_bytes()});
  }
}

int CcettMachine::make_board(std::size_t index, const MachineParameters& parameters,
                             const MachineAddresses& addresses, VersaBus& bus,
                             PixelSource& source) {
  BoardShare share{allotment_,
                   static_cast<std::int64_t>(index),
                   static_cast<std::int64_t>(parameters.boards.size()),
                   {}};
  if (is_claimed(parameters.allotment.assignment)) {
    share.claim = parameters.allotment.claim;
  }
  BoardSite site{bus, addresses.frame, addresses.shared};
  if (own_pixels_) {
    site.own_pixels.emplace(*own_pixels_, static_cast<int>(index), frame_memory_);
  }
  boards_.push_back(std::make_unique<Kvm02>(("board" + std::to_string(index)).c_str(),
                                            parameters.board, site, share, source, start_));
  Kvm02& board = *boards_.back();
  const int master = bus.attach_master(
      board.bus_master, {board.name(), parameters.boards[index], board.access_law()});
  board.set_master(master);
  bus.attach_slave(board.ram_port, {board.name(), addresses.ram(index), board.ram_bytes(), true});
  return master;
}

void CcettMachine::make_units(const MachineParameters& parameters,
                              const MachineAddresses& addresses, const FrameSetup& setup,
                              Backplane& backplane) {
  if (setup.legs == nullptr || setup.program) {
    throw std::invalid_argument("boards with function units need the legs of counted pixels");
  }
  units_.emplace(parameters, addresses, *buses_[0], *setup.legs, start_);
  for (std::size_t index = 0; index < boards_.size(); ++index) {
    units_->serve(*boards_[index], addresses.ram(index) + setup.reply_address);
  }
  backplane.boards.insert(backplane.boards.end(), units_->masters().begin(),
                          units_->masters().end());
  for (std::size_t unit = 0; unit < setup.unit_images.size(); ++unit) {
    const std::vector<unsigned char>& image = setup.unit_images[unit];
    add_images(addresses.unit(unit), image,
               setup.unit_loaded.empty() ? std::vector<ImageRange>{{0, image.size()}}
                                         : setup.unit_loaded.at(unit),
               backplane.images);
  }
}

void CcettMachine::make_host(const MachineParameters& parameters,
                             std::vector<Backplane> backplanes) {
  host_ = std::make_unique<Host>("host", parameters.host, parameters.board, std::move(backplanes),
                                 start_);
  for (std::size_t i = 0; i < buses_.size(); ++i) {
    host_->set_master(
        i, buses_[i]->attach_master(host_->bus_masters[i],
                                    {host_->name(), parameters.host.place, host_->access_law()}));
  }
}

void CcettMachine::observe_bus(const std::function<void(const BusAccess&)>& observer) {
  for (std::size_t port = 0; port < buses_.size(); ++port) {
    buses_[port]->observe([this, observer, port](BusAccess access) {
      const auto board = port + static_cast<std::size_t>(access.master) * buses_.size();
      access.master = static_cast<int>(std::min(board, last_master()));
      observer(access);
    });
  }
}

void CcettMachine::observe_lines(
    const std::function<void(std::size_t backplane, const LineState&)>& observer) {
  for (std::size_t port = 0; port < buses_.size(); ++port) {
    buses_[port]->observe_lines([observer, port](const LineState& line) { observer(port, line); });
  }
}

void CcettMachine::observe_pixels(const PixelObserver& observer) {
  for (std::size_t index = 0; index < boards_.size(); ++index) {
    boards_[index]->observe_pixels(static_cast<int>(index), observer);
  }
}

void CcettMachine::observe_pauses(
    const std::function<void(std::size_t master, bool pauses, Instant from)>& observer) {
  const auto of_master = [&observer](std::size_t master) {
    return [observer, master](bool pauses, Instant from) { observer(master, pauses, from); };
  };
  for (std::size_t index = 0; index < boards_.size(); ++index) {
    boards_[index]->observe_pauses(of_master(index));
  }
  if (units_) {
    units_->observe_pauses([&](std::size_t unit) { return of_master(boards_.size() + unit); });
  }
}

void CcettMachine::observe_handovers(const HandoverObserver& observer) {
  if (units_) {
    units_->observe_handovers(observer);
  }
}

VideoReader& CcettMachine::watch_video(Duration from, Duration to) {
  video_reader_ = std::make_unique<VideoReader>(
      (std::string(basename()) + "_video_reader").c_str(), video_, frame_memory_.parameters(),
      VideoWatch{start_, from, to, [this] { return finished().has_value(); }});
  frame_memory_.observe([this](const MemoryAccess& access) { video_reader_->tell(access); });
  return *video_reader_;
}

std::optional<Instant> CcettMachine::finished() const {
  Instant last{};
  for (const auto& board : boards_) {
    const std::optional<Instant> finished = board->finished();
    if (!finished) {
      return std::nullopt;
    }
    last = std::max(last, *finished);
  }
  return last;
}

std::int64_t CcettMachine::pixels_taken() const {
  std::int64_t taken = 0;
  for (const auto& board : boards_) {
    taken += board->pixels_taken();
  }
  return taken;
}

// The host's number, behind boards and units.
std::size_t CcettMachine::last_master() const {
  return boards_.size() + (units_ ? units_->masters().size() : 0);
}

// Boards may be ahead of the kernel.
Instant CcettMachine::furthest_known() const {
  Instant furthest = kernel_now();
  for (const auto& board : boards_) {
    furthest = std::max(furthest, board->accounted());
  }
  if (units_) {
    furthest = std::max(furthest, units_->accounted());
  }
  return furthest;
}

MachineStatistics CcettMachine::statistics() const {
  MachineStatistics statistics;
  const std::optional<Instant> finish = finished();
  const Instant end = finish.value_or(furthest_known());
  statistics.has_finished = finish.has_value();
  statistics.host = host_->statistics();
  statistics.load_time = statistics.host.finished.value_or(end);
  statistics.frame_time = end - statistics.load_time;
  for (const auto& board : boards_) {
    statistics.boards.push_back(board->statistics(end));
  }
  std::vector<BusStatistics> backplanes;
  for (const auto& bus : buses_) {
    backplanes.push_back(bus->statistics());
  }
  if (units_) {
    statistics.units = units_->statistics(end);
  }
  statistics.bus = combined(backplanes, last_master());
  statistics.backplanes = static_cast<int>(buses_.size());
  return statistics;
}

void CcettMachine::verify_frame() const {
  for (int row = 0; row < timing_.height(); ++row) {
    for (int column = 0; column < timing_.width(); ++column) {
      const bool useful = column >= zone_.column0 && column < zone_.column0 + zone_.width &&
                          row >= zone_.row0 && row < zone_.row0 + zone_.height;
      if (useful ? !frame_memory_.written_once(column, row)
                 : !frame_memory_.untouched(column, row)) {
        throw std::logic_error(
            "pixel (" + std::to_string(column) + ", " + std::to_string(row) + ") was " +
            (useful ? "not written exactly once" : "written outside the useful zone"));
      }
    }
  }
}

}  // namespace maquette::models
