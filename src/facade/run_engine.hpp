#pragma once

#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include "compile_scene.hpp"
#include "convert.hpp"
#include "engine_player.hpp"
#include "engine_run.hpp"
#include "osculo/engine/scenes.hpp"
#include "ready_engine.hpp"
#include "text.hpp"

namespace osculo::facade {

/// "uniform/restitution/symmetric/rims+segments+arcs+points/double/pieces/all-pairs".
template <class Type>
[[nodiscard]] std::string engine_name(const char* obstacles, const char* scalar) {
    return concatenated(Type::Motion::kName, "/", Type::Impact::kName, "/",
                        Type::Simultaneous::kName, "/", obstacles, "/", scalar, "/",
                        Type::Recorder::kName, "/", Type::BroadPhase::kName);
}

/// The scalar types by their names on the command line.
template <math::Scalar S>
struct PrecisionOf;
template <>
struct PrecisionOf<double> {
    static constexpr Precision kPrecision = Precision::double_precision;
    static constexpr const char* kName = "double";
};
template <>
struct PrecisionOf<long double> {
    static constexpr Precision kPrecision = Precision::extended;
    static constexpr const char* kName = "extended";
};
template <>
struct PrecisionOf<math::Quad> {
    static constexpr Precision kPrecision = Precision::quad;
    static constexpr const char* kName = "quad";
};
template <>
struct PrecisionOf<boost::multiprecision::cpp_bin_float_50> {
    static constexpr Precision kPrecision = Precision::digits50;
    static constexpr const char* kName = "50";
};
template <>
struct PrecisionOf<boost::multiprecision::cpp_bin_float_100> {
    static constexpr Precision kPrecision = Precision::digits100;
    static constexpr const char* kName = "100";
};

template <class ObstacleKinds>
struct ObstacleName;
template <>
struct ObstacleName<engine::NoObstacles> {
    static constexpr bool kSegments = false, kArcsAndRims = false;
    static constexpr const char* kName = "open";
};
template <>
struct ObstacleName<engine::Walls> {
    static constexpr bool kSegments = true, kArcsAndRims = false;
    static constexpr const char* kName = "segments+points";
};
template <>
struct ObstacleName<engine::Table> {
    static constexpr bool kSegments = true, kArcsAndRims = true;
    static constexpr const char* kName = "rims+segments+arcs+points";
};

template <>
struct ObstacleName<engine::PullingTable> {
    static constexpr bool kSegments = true, kArcsAndRims = true;
    static constexpr const char* kName = "rims+segments+arcs+points";
};

/// The scene's cushion law that an engine has; laws without spin have restitution only.
template <class Laws>
inline constexpr CushionLaw kCushionLaw = CushionLaw::restitution;
template <>
inline constexpr CushionLaw kCushionLaw<engine::WithFriction<impact::CushionHan2005>> =
    CushionLaw::han_2005;

/// Of a law that serves one kind of motion.
template <class Law>
inline constexpr MotionKind kMotionKind = MotionKind::uniform;
template <>
inline constexpr MotionKind kMotionKind<motion::Rolling> = MotionKind::rolling;
template <>
inline constexpr MotionKind kMotionKind<motion::WithRims<motion::Rolling>> = MotionKind::rolling;
template <>
inline constexpr MotionKind kMotionKind<motion::WithTippingRims<motion::Rolling>> =
    MotionKind::rolling;
template <>
inline constexpr MotionKind kMotionKind<motion::Resisted> = MotionKind::resisted;
template <>
inline constexpr MotionKind kMotionKind<motion::Disc> = MotionKind::resisted;
template <>
inline constexpr MotionKind kMotionKind<motion::Cloth> = MotionKind::cloth;

template <class Type>
[[nodiscard]] ReadyEngine ready_engine() {
    using S = typename Type::Scalar;
    using Name = ObstacleName<typename Type::ObstacleList>;
    ReadyEngine engine;
    engine.precision = PrecisionOf<S>::kPrecision;
    engine.motion = kMotionKind<typename Type::Motion>;
    engine.discs = std::is_same_v<typename Type::Motion, motion::Disc>;
    engine.cushion = kCushionLaw<typename Type::Impact>;
    engine.simultaneous =
        Type::Simultaneous::kGathersCluster ? Simultaneous::symmetric : Simultaneous::sequential;
    engine.segments = Name::kSegments;
    engine.arcs_and_rims = Name::kArcsAndRims;
    engine.pulling_rims = engine::kHasRims<typename Type::Motion> && !kTips<Type>;
    engine.tipping_rims = kTips<Type>;
    engine.record = Type::Recorder::kPieces                           ? Record::pieces
                    : Type::Recorder::kEvents && !kContactsOnly<Type> ? Record::events
                                                                      : Record::none;
    engine.cell_grid = Type::BroadPhase::kCrossings;
    engine.name = [] { return engine_name<Type>(Name::kName, PrecisionOf<S>::kName); };
    engine.begin = nullptr;
    engine.make_player = nullptr;
    if constexpr (!kContactsOnly<Type>) engine.begin = &begin_engine_run<Type>;
    if constexpr (Type::Recorder::kEvents) engine.make_player = &make_engine_player<Type>;
    return engine;
}

}  // namespace osculo::facade
