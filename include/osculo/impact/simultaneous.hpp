#pragma once

namespace osculo::impact {

// How contacts at one instant that share balls are resolved. A law is a type that says whether the
// engine has to find them all: kGathersCluster.

/// Pair by pair in the total order of events. Only the first contact is taken: what it leaves
/// touching and approaching is found again by detection and becomes the next event, at the same
/// instant, until no touching pair approaches.
struct Sequential {
    static constexpr const char* kName = "sequential";
    static constexpr bool kGathersCluster = false;
};

/// All at once (impact/symmetric.hpp): contacts of one instant, and the touching things that they
/// push on. What has just one contact is resolved as by Sequential, bit for bit.
struct Symmetric {
    static constexpr const char* kName = "symmetric";
    static constexpr bool kGathersCluster = true;
};

}  // namespace osculo::impact
