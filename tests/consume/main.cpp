// A stranger's program: two balls meet, through the facade and through the template core.
#include <cstdio>

#include <osculo/osculo.hpp>
#include <osculo/simulate.hpp>
#include <osculo/version.hpp>

int main() {
    osculo::Scene scene;
    scene.balls = {{"a", 1, 0.5, {0, 0}, {1, 0}, {}}, {"b", 1, 0.5, {3, 0}, {0, 0}, {}}};
    scene.limits.time = 5;
    const osculo::Run run = osculo::simulate(scene);
    if (run.events.size() != 1 || run.events[0].time != 2) return 1;

    namespace engine = osculo::engine;
    using Vec = osculo::math::Vec<double>;
    using Type =
        engine::UniformScene<double, engine::NoObstacles, engine::NoRecorder, engine::AllPairs>;
    engine::SceneData<Type> data;
    data.bodies.resize(2);
    data.bodies[0].state = {osculo::math::WidePoint<double>(Vec(0, 0)), Vec(1, 0)};
    data.bodies[1].state = {osculo::math::WidePoint<double>(Vec(3, 0)), Vec(0, 0)};
    engine::Engine<Type> core(std::move(data));
    core.run({5, 100});
    if (core.event_count() != 1) return 1;
    std::printf("osculo %s: contact after %g s\n", osculo::kVersion, run.events[0].time);
    return 0;
}
