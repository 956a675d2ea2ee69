#include "osculo/osculo.hpp"

/// A kind of obstacle without an overload of first_contact, unless there is no mistake.
template <osculo::math::Scalar S>
struct Unknown {
    osculo::math::Vec<S> place;
};

#if !OSCULO_MISTAKE
template <osculo::math::Scalar S>
S first_contact(const osculo::motion::LinearPath<S>&, const S&, const Unknown<S>&,
                const osculo::math::ContactHistory<S>&, const S&) {
    return osculo::math::never<S>();
}
#endif
template <osculo::math::Scalar S>
osculo::math::Vec<S> contact_normal(const osculo::math::WidePoint<S>&, const Unknown<S>& unknown) {
    return unknown.place;
}

using Type = osculo::engine::UniformScene<double, osculo::engine::Obstacles<Unknown>,
                                          osculo::engine::NoRecorder, osculo::engine::AllPairs>;

osculo::Status run(osculo::engine::Engine<Type>& engine) {
    return engine.run({1, 1});
}
osculo::engine::Engine<Type> make() {
    return osculo::engine::Engine<Type>(osculo::engine::SceneData<Type>{});
}
