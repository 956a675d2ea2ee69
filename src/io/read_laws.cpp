#include "io/read_laws.hpp"

namespace osculo::io {
namespace {

using Names = std::string_view[];

// The law must be given, and available, before anything is said about the members it brings along.
std::size_t law_of(const Value& value, std::span<const std::string_view> available,
                   std::span<const std::string_view> planned) {
    const std::optional<Value> law = value.member("law");
    if (!law) throw SceneError(value.path() + ".law", "must be given", "missing");
    return choice(*law, available, planned);
}

// A member that may be left out.
void take(const Fields& fields, std::string_view name, double& number) {
    if (const auto value = fields.find(name)) number = value->number();
}

BallBallImpact read_ball_ball(const Value& value) {
    static constexpr Names kLaws{"restitution", "frictional"};
    static constexpr Names kRestitution{"law", "restitution"};
    static constexpr Names kFrictional{"law", "restitution", "friction"};
    BallBallImpact result;
    if (law_of(value, kLaws, {}) == 0) {
        take(Fields(value, kRestitution), "restitution", result.restitution);
        return result;
    }
    const Fields fields(value, kFrictional);
    result.law = BallBallLaw::frictional;
    take(fields, "restitution", result.restitution);
    // A number, or the three coefficients of a + b exp(-c u).
    const Value friction = fields.require("friction");
    if (friction.kind() == NodeKind::array) {
        result.friction = friction.numbers<3>();
    } else {
        result.friction[0] = friction.number();
    }
    return result;
}

CushionImpact read_ball_cushion(const Value& value) {
    static constexpr Names kLaws{"restitution", "frictional", "han_2005", "mathavan_2010",
                                 "stronge"};
    static constexpr CushionLaw kValues[]{CushionLaw::restitution, CushionLaw::frictional,
                                          CushionLaw::han_2005, CushionLaw::mathavan_2010,
                                          CushionLaw::stronge};
    static constexpr Names kRestitution{"law", "restitution"};
    static constexpr Names kFrictional{"law", "restitution", "friction"};
    static constexpr Names kHan{"law", "restitution", "friction", "height"};
    static constexpr Names kMathavan{"law", "restitution", "friction", "height", "cloth_friction"};
    static constexpr Names kStronge{"law", "restitution", "friction", "height", "frequency_ratio"};
    static constexpr std::span<const std::string_view> kKeys[]{kRestitution, kFrictional, kHan,
                                                               kMathavan, kStronge};
    const std::size_t law = law_of(value, kLaws, {});
    const Fields fields(value, kKeys[law]);
    CushionImpact result;
    result.law = kValues[law];
    take(fields, "restitution", result.restitution);
    if (result.law == CushionLaw::restitution) return result;
    result.friction = fields.require("friction").number();
    if (result.law == CushionLaw::frictional) return result;
    result.height = fields.require("height").number();
    if (result.law == CushionLaw::mathavan_2010) {
        if (const auto own = fields.find("cloth_friction")) result.cloth_friction = own->number();
    }
    if (result.law == CushionLaw::stronge) take(fields, "frequency_ratio", result.frequency_ratio);
    return result;
}

Medium read_medium(const Value& value) {
    static constexpr Names kKeys{"density", "viscosity", "drag_coefficient", "rolling"};
    const Fields fields(value, kKeys);
    Medium medium;
    take(fields, "density", medium.density);
    take(fields, "viscosity", medium.viscosity);
    take(fields, "drag_coefficient", medium.drag_coefficient);
    if (const auto rolling = fields.find("rolling")) medium.rolling = rolling->boolean();
    return medium;
}

ResistedMotion read_resisted(const Value& value) {
    static constexpr Names kKeys{"law", "constant", "linear", "quadratic", "medium"};
    const Fields fields(value, kKeys);
    ResistedMotion resisted;
    take(fields, "constant", resisted.constant);
    take(fields, "linear", resisted.linear);
    take(fields, "quadratic", resisted.quadratic);
    if (const auto medium = fields.find("medium")) resisted.medium = read_medium(*medium);
    return resisted;
}

}  // namespace

MotionLaw read_motion(const Value& value) {
    static constexpr Names kLaws{"uniform", "rolling", "cloth", "resisted"};
    static constexpr Names kUniform{"law"};
    static constexpr Names kRolling{"law", "friction"};
    static constexpr Names kCloth{"law", "sliding_friction", "rolling_friction",
                                  "spinning_friction"};
    const std::size_t law = law_of(value, kLaws, {});
    if (law == 1) {
        RollingMotion rolling;
        take(Fields(value, kRolling), "friction", rolling.friction);
        return rolling;
    }
    if (law == 2) {
        const Fields fields(value, kCloth);
        ClothMotion cloth;
        take(fields, "sliding_friction", cloth.sliding_friction);
        take(fields, "rolling_friction", cloth.rolling_friction);
        take(fields, "spinning_friction", cloth.spinning_friction);
        return cloth;
    }
    if (law == 3) return read_resisted(value);
    const Fields fields(value, kUniform);
    return UniformMotion{};
}

Impacts read_impacts(const Value& value, const Impacts& defaults) {
    static constexpr Names kSimultaneous{"symmetric", "sequential"};
    static constexpr Names kKeys{"ball_ball", "ball_cushion", "simultaneous", "contact_time",
                                 "rest_speed"};
    const Fields fields(value, kKeys);
    Impacts result = defaults;
    if (const auto law = fields.find("ball_ball")) result.ball_ball = read_ball_ball(*law);
    if (const auto law = fields.find("ball_cushion")) {
        result.ball_cushion = read_ball_cushion(*law);
    }
    if (const auto law = fields.find("simultaneous")) {
        result.simultaneous =
            choice(*law, kSimultaneous) == 0 ? Simultaneous::symmetric : Simultaneous::sequential;
    }
    take(fields, "contact_time", result.contact_time);
    if (const auto speed = fields.find("rest_speed")) result.rest_speed = speed->number();
    return result;
}

Cue read_cue(const Value& value) {
    static constexpr Names kKeys{
        "ball", "speed",    "azimuth",     "elevation",    "offset",
        "mass", "end_mass", "restitution", "miscue_limit", "allow_obstructed"};
    const Fields fields(value, kKeys);
    Cue cue;
    if (const auto ball = fields.find("ball")) cue.ball = ball->text();
    cue.speed = fields.require("speed").number();
    cue.azimuth = fields.require("azimuth").number();
    take(fields, "elevation", cue.elevation);
    if (const auto offset = fields.find("offset")) cue.offset = offset->numbers<2>();
    take(fields, "mass", cue.mass);
    take(fields, "end_mass", cue.end_mass);
    take(fields, "restitution", cue.restitution);
    take(fields, "miscue_limit", cue.miscue_limit);
    if (const auto allow = fields.find("allow_obstructed")) {
        cue.allow_obstructed = allow->boolean();
    }
    return cue;
}

}  // namespace osculo::io
