#pragma once

namespace osculo::impact {

/// How a cluster of contacts at one instant is resolved. A law is a type with
///
///     static constexpr bool kGathersCluster;      // wants every contact of the cluster, not only
///     the first template <class Cluster, class ResolveOne> static void resolve(Cluster& cluster,
///     ResolveOne&& resolve_one);
///
/// where a cluster is a range of contacts in the total order of events and resolve_one(contact)
/// applies the binary law to one of them.

/// Pair by pair in the total order of events. Only the first contact is taken: what it leaves
/// touching and approaching is found again by detection and becomes the next event, at the same
/// instant, until no touching pair approaches.
struct Sequential {
    static constexpr const char* kName = "sequential";
    static constexpr bool kGathersCluster = false;

    template <class Cluster, class ResolveOne>
    static void resolve(Cluster& cluster, ResolveOne&& resolve_one) {
        for (auto& contact : cluster) resolve_one(contact);
    }
};

}  // namespace osculo::impact
