#include "sim/command_line/standard_streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <initializer_list>

namespace maquette::sim {

void occupy_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    // The lowest descriptor that is free is the one that is given, so all below are taken.
    if (::fcntl(stream, F_GETFD) == -1) {
      const int wrong_way = stream == STDIN_FILENO ? O_WRONLY : O_RDONLY;
      static_cast<void>(::open("/dev/null", wrong_way));
    }
  }
}

}  // namespace maquette::sim
