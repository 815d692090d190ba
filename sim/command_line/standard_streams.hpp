#pragma once

namespace maquette::sim {

/// Takes the descriptors of standard streams that are closed, lest a file that is opened later gets
/// one of them and what is printed; printing and reading fail as before. To be called before
/// anything is opened.
void occupy_closed_streams();

}  // namespace maquette::sim
