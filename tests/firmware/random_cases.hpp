#pragma once

#include "sim/stability/random_cases.hpp"

/// The tests draw their cases as the measured stability does.
namespace maquette::firmware::trial {

using sim::trial::determinant;
using sim::trial::inverse;
using sim::trial::moved;
using sim::trial::Placement;
using sim::trial::Random;
using sim::trial::scaled;
using sim::trial::turned;
using sim::trial::unmoved;

}  // namespace maquette::firmware::trial
