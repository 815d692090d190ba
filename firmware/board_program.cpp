#include "firmware/preprocess.hpp"
#include "firmware/synthesize.hpp"

// What a board's RAM holds of the firmware: its two entry points in single precision. Compiled
// freestanding for the 68000; its only undefined names are the arithmetic package.
namespace maquette::firmware {

template void preprocess<float>(const Database<float>& database, Prepared<float>& prepared);
template Pixel synthesize<float>(const Frame<float>& frame, const WorkArea<float>& area,
                                 std::int16_t column, std::int16_t row);

}  // namespace maquette::firmware
