#include "io/read.hpp"
#include "osculo/io.hpp"

namespace osculo::io {
namespace {

Scene scene_of(const Document& document) {
    return read_scene(Value(document, "scene"));
}

Run run_of(Document document) {
    document.is_run = true;
    return read_run(Value(document, "run"));
}

std::variant<Scene, Run> scene_or_run_of(Document document) {
    const Value whole(document, "file");
    const auto schema = whole.member("schema");
    if (schema && schema->kind() == NodeKind::text && schema->text() == kRunSchema) {
        return run_of(std::move(document));
    }
    return read_scene(whole);
}

}  // namespace

Scene scene_from_json(std::string_view text) {
    return scene_of(parse_json(text));
}

Scene scene_from_msgpack(std::string_view bytes) {
    return scene_of(parse_msgpack(bytes));
}

Run run_from_json(std::string_view text) {
    return run_of(parse_json(text));
}

Run run_from_msgpack(std::string_view bytes) {
    return run_of(parse_msgpack(bytes));
}

std::variant<Scene, Run> scene_or_run_from_json(std::string_view text) {
    return scene_or_run_of(parse_json(text));
}

std::variant<Scene, Run> scene_or_run_from_msgpack(std::string_view bytes) {
    return scene_or_run_of(parse_msgpack(bytes));
}

}  // namespace osculo::io
