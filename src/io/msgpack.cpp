#include <nlohmann/json.hpp>

#include "osculo/io.hpp"

namespace osculo::io {

std::string msgpack_from_json(std::string_view text) {
    using Json = nlohmann::ordered_json;
    std::string result;
    try {
        Json::to_msgpack(Json::parse(text), result);
    } catch (const Json::exception& error) {
        throw FormatError(error.what());
    }
    return result;
}

}  // namespace osculo::io
