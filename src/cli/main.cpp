#include <new>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/files.hpp"
#include "osculo/version.hpp"
#include "presets/nearest_name.hpp"

namespace osculo::cli {
namespace {

int fail(int code, std::string_view message) {
    fmt::print(stderr, "osculo: {}\n", message);
    return code;
}

// What CLI11 says, or something more helpful about words it does not know.
std::string usage_message(const CLI::App& app, const CLI::ParseError& error) {
    const auto commands = app.get_subcommands();
    const std::string see_help = fmt::format(
        " (see osculo {}--help)", commands.empty() ? "" : commands.front()->get_name() + ' ');
    const std::vector<std::string> unknown = app.remaining(true);
    if (dynamic_cast<const CLI::ExtrasError*>(&error) == nullptr || unknown.empty()) {
        return error.what() + see_help;
    }
    const std::string& word = unknown.front();
    std::vector<std::string> names;
    if (commands.empty()) {
        for (const CLI::App* command : app.get_subcommands({})) {
            names.push_back(command->get_name());
        }
    } else {
        for (const CLI::Option* option : commands.front()->get_options()) {
            for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
        }
    }
    const std::vector<std::string_view> candidates(names.begin(), names.end());
    return fmt::format("{} \"{}\"{}{}", commands.empty() ? "unknown command" : "unexpected", word,
                       did_you_mean(word, candidates), see_help);
}

int main_with(int argc, char** argv) {
    CLI::App app("Exact, event-driven simulation of colliding balls in the plane.", "osculo");
    app.set_version_flag("--version", std::string("osculo ") + kVersion);
    app.set_help_flag("-h,--help", "print this help");
    app.footer(
        "Examples:\n"
        "  osculo run preset:break -o run.json --svg shot.svg\n"
        "  osculo presets gas --balls 16 > gas.json\n"
        "  osculo COMMAND --help");
    ExitCode exit_code = kFinished;
    add_run(app, exit_code);
    add_render(app);
    add_replay(app);
    add_check(app);
    add_presets(app);
    add_batch(app, exit_code);

    try {
        app.parse(argc, argv);
        if (app.get_subcommands().empty())
            return fail(kUsage, "a command is needed, see osculo --help");
        return exit_code;
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) {  // help or version
            std::ostringstream text;
            app.exit(error, text, text);
            write_output(text.str());
            return kFinished;
        }
        return fail(kUsage, usage_message(app, error));
    }
}

}  // namespace
}  // namespace osculo::cli

int main(int argc, char** argv) {
    using namespace osculo::cli;
    handle_signals();
    try {
        return main_with(argc, argv);
    } catch (const Failure& failure) {
        return fail(failure.code(), failure.what());
    } catch (const std::bad_alloc&) {
        return fail(kInputOutput, "not enough memory");
    } catch (const std::exception& error) {
        return fail(kInputOutput, error.what());
    }
}
