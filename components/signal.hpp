// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "framework/literal.hpp"
#include "framework/port.hpp"

/// @file
/// What generic components need to know of the signals that they are wired to.

namespace trocar {

/// The SI unit of a dimension.
Unit si_unit(const Dimension& dimension);

/// A single number in that unit.
Signature real_signal(const Unit& unit);

/// One unit for each number of a signal: six for a wrench, one for each axis of Joints.
std::vector<Unit> number_units(const Signature& signature);

/// The same type and frame, each unit multiplied by `factor`.
Signature multiplied(const Signature& signature, const Dimension& factor);
Signature divided(const Signature& signature, const Dimension& divisor);

/// Numbers that may be added and scaled one by one.
/// @throw std::invalid_argument for a type that holds a Rotation, which may not.
void require_linear(const Port& port);

/// The numbers that a literal gives a signal: a quantity, or a list with one for each number.
/// Bare numbers only where dimensionless, or zero.
/// @param what names the parameter in errors
/// @throw std::invalid_argument with the value, what is needed and an example.
std::vector<double> read_numbers(const Literal& literal, const Signature& signature,
                                 const std::string& what);

/// What a literal is by itself: a number a dimensionless double, a quantity a double in its unit,
/// a list of three a Vector3 in the unit of the first that has one.
std::optional<Signature> natural_signature_of(const Literal& literal);

}  // namespace trocar
