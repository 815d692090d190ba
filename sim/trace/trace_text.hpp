#pragma once

#include <fmt/format.h>

#include <ostream>
#include <utility>

namespace maquette::sim {

/// Formatted text on its way to a stream, in large pieces.
class TraceText {
 public:
  explicit TraceText(std::ostream& stream) : stream_(stream) {}
  TraceText(const TraceText&) = delete;
  TraceText& operator=(const TraceText&) = delete;
  TraceText(TraceText&&) = delete;
  TraceText& operator=(TraceText&&) = delete;
  ~TraceText() { flush(); }

  template <typename... Values>
  void add(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(buffer_), format, std::forward<Values>(values)...);
    if (buffer_.size() > k_piece_bytes) {
      flush();
    }
  }

  void flush() {
    stream_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    buffer_.clear();
  }

 private:
  static constexpr std::size_t k_piece_bytes = 1U << 16U;

  std::ostream& stream_;
  fmt::memory_buffer buffer_;
};

}  // namespace maquette::sim
