#pragma once

#include "support/exact.hpp"
#include "support/scalars.hpp"

/// The two groups of scalar types whose arithmetic makes different promises.
namespace osculo::support {

/// Contacts are decided in twice the digits, and exactly where those do not suffice.
using BuiltinScalars = testing::Types<double, long double>;
/// Contacts are decided in the type's own digits.
using WiderScalars = testing::Types<math::Quad, Digits50>;

}  // namespace osculo::support
