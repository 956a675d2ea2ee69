#pragma once

#include <string>

#include "support/builder.hpp"
#include "support/scalars.hpp"

/// Tests of what both laws for simultaneous contacts must do.
namespace osculo::support {

/// A scalar type and a law.
template <class S, class Law>
struct Under {
    using Scalar = S;
    using Type = TableScene<S, Law>;
    static constexpr bool kSymmetric = Law::kGathersCluster;
};

// The law does not depend on the scalar type, and each of them takes the compiler a while: the
// symmetric one is tried in double. tests/engine/cluster_test.cpp has the others.
using NativeUnderBoth =
    ::testing::Types<Under<double, impact::Sequential>, Under<long double, impact::Sequential>,
                     Under<math::Quad, impact::Sequential>, Under<double, impact::Symmetric>>;
using AllUnderBoth =
    ::testing::Types<Under<double, impact::Sequential>, Under<long double, impact::Sequential>,
                     Under<math::Quad, impact::Sequential>, Under<Digits50, impact::Sequential>,
                     Under<Digits100, impact::Sequential>, Under<double, impact::Symmetric>>;

/// Names the instances: "double_symmetric".
struct UnderName {
    template <class U>
    static std::string GetName(int index) {
        return ScalarName::GetName<typename U::Scalar>(index) +
               (U::kSymmetric ? "_symmetric" : "_sequential");
    }
};

}  // namespace osculo::support
