#include "json_mutator.hpp"

#include <array>
#include <random>
#include <vector>

#include <nlohmann/json.hpp>

namespace osculo::fuzz {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array kNumbers{0.0,
                              -0.0,
                              1.0,
                              -1.0,
                              0.5,
                              2.0,
                              3.0,
                              1e-3,
                              1e-9,
                              1e-16,
                              1e-300,
                              5e-324,
                              1e9,
                              1e16,
                              1e150,
                              1e300,
                              -1e-9,
                              0.1,
                              1.5707963267948966,
                              6.283185307179586,
                              0.028575,
                              0.4};

constexpr std::array kWords{
    "uniform",    "rolling",       "resisted", "cloth",          "left",
    "both",       "capture",       "paper",    "tipping",        "restitution",
    "frictional", "han_2005",      "stronge",  "mathavan_2010",  "symmetric",
    "sequential", "cue",           "a",        "pool-9ft",       "carom-10ft",
    "eight-ball", "three-cushion", "",         "osculo/scene-1", "osculo/run-1"};

constexpr std::array kKeys{
    "motion",    "gravity",      "balls",        "segments",     "arcs",        "rims",
    "impacts",   "cue",          "limits",       "table",        "rack",        "closed",
    "law",       "friction",     "position",     "velocity",     "spin",        "mass",
    "radius",    "inertia",      "id",           "from",         "to",          "side",
    "center",    "height",       "offset",       "speed",        "azimuth",     "elevation",
    "ball_ball", "ball_cushion", "simultaneous", "contact_time", "restitution", "constant",
    "linear",    "quadratic",    "from_angle",   "to_angle"};

class Mutator {
public:
    explicit Mutator(unsigned seed) : random_(seed) {}

    void mutate(Json& document) {
        std::vector<Json*> nodes;
        collect(document, nodes);
        for (std::size_t changes = 1 + below(3); changes > 0 && !nodes.empty(); --changes) {
            change(*nodes[below(nodes.size())]);
            nodes.clear();  // what they point to may be gone
            collect(document, nodes);
        }
    }

    std::size_t below(std::size_t count) { return random_() % count; }

private:
    static void collect(Json& node, std::vector<Json*>& nodes) {
        nodes.push_back(&node);
        if (!node.is_structured()) return;
        for (auto& child : node) collect(child, nodes);
    }

    void change(Json& node) {
        if (node.is_array()) return change_array(node);
        if (node.is_object()) return change_object(node);
        switch (below(8)) {
            case 0: node = nullptr; return;
            case 1: node = below(2) == 0; return;
            case 2: node = kWords[below(kWords.size())]; return;
            case 3: node = Json::array({number(), number()}); return;
            default: break;
        }
        if (node.is_string()) {
            node = kWords[below(kWords.size())];
        } else if (node.is_number() && below(2) == 0) {
            node = node.get<double>() * (below(2) == 0 ? 1 + 1e-15 : 1.25);
        } else {
            node = number();
        }
    }

    void change_array(Json& node) {
        if (node.empty() || below(4) == 0) {
            node.push_back(node.empty() ? Json(number()) : node[below(node.size())]);
        } else if (below(2) == 0) {
            node.erase(below(node.size()));
        } else {
            std::swap(node[below(node.size())], node[below(node.size())]);
        }
    }

    void change_object(Json& node) {
        if (!node.empty() && below(3) == 0) {
            node.erase(std::next(node.begin(), static_cast<std::ptrdiff_t>(below(node.size()))));
            return;
        }
        Json value = number();
        if (below(3) == 0) value = kWords[below(kWords.size())];
        if (below(4) == 0) value = Json{{"law", kWords[below(kWords.size())]}};
        node[kKeys[below(kKeys.size())]] = value;
    }

    double number() { return kNumbers[below(kNumbers.size())]; }

    std::minstd_rand random_;
};

}  // namespace

std::string mutated_json(std::string_view text, unsigned seed) {
    Mutator mutator(seed);
    if (mutator.below(10) == 0) return {};
    Json document = Json::parse(text, nullptr, false);
    if (document.is_discarded()) return {};
    mutator.mutate(document);
    return document.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace osculo::fuzz
