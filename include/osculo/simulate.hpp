#pragma once

#include <optional>
#include <string_view>

#include "osculo/run.hpp"
#include "osculo/scene.hpp"

namespace osculo {

/// The scalar type of a run. Results are rounded to double whatever it is.
enum class Precision {
    double_precision,  ///< 53 bits
    extended,          ///< long double: 64 bits on x86
    quad,              ///< __float128: 113 bits
    digits50,          ///< Boost.Multiprecision cpp_bin_float_50
    digits100,         ///< Boost.Multiprecision cpp_bin_float_100
};

/// "double", "extended", "quad", "50", "100", as on the command line.
[[nodiscard]] std::string_view to_string(Precision precision);
[[nodiscard]] std::optional<Precision> precision_from_string(std::string_view name);

/// What a run keeps besides the final states.
enum class Record { none, events, pieces /* and events */ };

struct Options {
    Precision precision = Precision::double_precision;
    Record record = Record::pieces;
    bool audit =
        false;  ///< check the run from its pieces; records them for that whatever `record` is
    /// Run the scene in higher precisions as well and say how far the run can be trusted
    /// (certificate.hpp); keeps the events, which it is about, whatever `record` is. Takes some 10
    /// to 1000 times as long; not for precision digits100.
    bool certify = false;
};

/// Runs the scene to rest or to its limits. Throws SceneError if the scene breaks a rule, or if no
/// engine has its motion law in the precision asked for; after that nothing is thrown but
/// std::bad_alloc. Same scene and options: same bits, whatever machine or thread.
[[nodiscard]] Run simulate(const Scene& scene, const Options& options = {});

/// The engine that simulate() would take for the scene, and what that engine leaves out. Throws as
/// simulate() does if there is none.
[[nodiscard]] EngineInfo choose_engine(const Scene& scene, const Options& options = {});

}  // namespace osculo
