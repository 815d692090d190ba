#pragma once

#include "firmware/primitives/algebraic.hpp"
#include "firmware/primitives/box.hpp"
#include "firmware/primitives/cone.hpp"
#include "firmware/primitives/cylinder.hpp"
#include "firmware/primitives/half_space.hpp"
#include "firmware/primitives/patches.hpp"
#include "firmware/primitives/prism.hpp"
#include "firmware/primitives/revolution.hpp"
#include "firmware/primitives/sphere.hpp"
#include "firmware/primitives/terrain.hpp"

namespace maquette::firmware {

/// The primitives in the order of PrimitiveKind: one line each.
template <class Real>
inline constexpr Primitive<Real> k_primitives[k_primitive_kind_count] = {
    {half_space::intersect<Real>, half_space::settle<Real>, half_space::bounds<Real>,
     convex_hit_limit<Real>, true},
    {box::intersect<Real>, box::settle<Real>, box::bounds<Real>, convex_hit_limit<Real>, true},
    {sphere::intersect<Real>, sphere::settle<Real>, sphere::bounds<Real>, convex_hit_limit<Real>,
     true},
    {cylinder::intersect<Real>, cylinder::settle<Real>, cylinder::bounds<Real>,
     convex_hit_limit<Real>, true},
    {cone::intersect<Real>, cone::settle<Real>, cone::bounds<Real>, convex_hit_limit<Real>, true},
    {revolution::intersect<Real>, revolution::settle<Real>, revolution::bounds<Real>,
     revolution::hit_limit<Real>, false},
    {terrain::intersect<Real>, terrain::settle<Real>, terrain::bounds<Real>,
     terrain::hit_limit<Real>, false},
    {algebraic::intersect<Real>, algebraic::settle<Real>, algebraic::bounds<Real>,
     algebraic::hit_limit<Real>, false},
    {prism::intersect<Real>, prism::settle<Real>, prism::bounds<Real>, prism::hit_limit<Real>,
     false},
    {patches::intersect<Real>, patches::settle<Real>, patches::bounds<Real>,
     patches::hit_limit<Real>, false},
};

template <class Real>
constexpr const Primitive<Real>& primitive_of(PrimitiveKind kind) {
  return k_primitives<Real>[static_cast<int>(kind)];
}

}  // namespace maquette::firmware
