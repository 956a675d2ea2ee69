// Bytes of the engines of the ready-made scene types, of what they keep per ball, and of obstacles.

#include <cstdio>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "osculo/osculo.hpp"

namespace {

using namespace osculo;

template <class Type>
void line(const char* name) {
    using S = typename Type::Scalar;
    std::printf("%-34s %7zu %7zu %7zu\n", name, sizeof(engine::Engine<Type>),
                sizeof(engine::Body<Type>), sizeof(engine::Event<S>));
}

template <class S>
void lines(const char* scalar) {
    using namespace engine;
    const auto name = [&](const char* rest) {
        static char text[80];
        std::snprintf(text, sizeof text, "%s, %s", scalar, rest);
        return text;
    };
    line<UniformScene<S, NoObstacles, NoRecorder, AllPairs>>(name("no obstacles, all pairs"));
    line<UniformScene<S, Walls, NoRecorder, AllPairs>>(name("walls, all pairs"));
    line<UniformScene<S, Walls, NoRecorder, CellGrid>>(name("walls, cell grid"));
    line<UniformScene<S, Table, NoRecorder, AllPairs>>(name("table, all pairs"));
    line<UniformScene<S, Table, PieceRecorder, CellGrid>>(name("table, cell grid, pieces"));
    std::printf("%-34s %zu / %zu / %zu / %zu\n", name("segment / arc / point / rim"),
                sizeof(geometry::Segment<S>), sizeof(geometry::Arc<S>), sizeof(geometry::Point<S>),
                sizeof(geometry::Rim<S>));
}

}  // namespace

int main() {
    std::printf("%-34s %7s %7s %7s\n", "bytes", "engine", "a ball", "event");
    lines<double>("double");
    lines<long double>("long double");
    lines<math::Quad>("quad");
    lines<boost::multiprecision::cpp_bin_float_50>("50 digits");
    return 0;
}
