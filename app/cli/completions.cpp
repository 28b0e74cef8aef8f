// The scripts with which bash and zsh complete a command line, made from the options that the program itself reads.

#include "app/cli/command.h"

#include "core/effect/parameter_table.h"
#include "core/preset/library.h"

#include <algorithm>
#include <memory>

namespace fumage::cli {

namespace {

struct Choice {
    std::string name; ///< "--output"
    const CLI::Option* option;
};

/// What can stand after an option or as an argument: one of some words, a file, or both; neither where only the user
/// knows it.
struct Values {
    std::string words;
    bool files = false;
    bool unfinished = false; ///< more follows without a space, as in KEY=
};

std::string joined(std::string all, const std::string& more)
{
    return all.empty() ? more : std::move(all) + " " + more;
}

Values valuesOf(const CLI::Option& option)
{
    const std::string type = option.get_type_name();
    Values values;
    if (const std::size_t open = type.find('{'); open != std::string::npos) {
        values.words = type.substr(open + 1, type.find('}', open) - open - 1);
        std::replace(values.words.begin(), values.words.end(), ',', ' ');
    } else if (type.starts_with("PRESET")) {
        for (const LibraryEntry& entry : builtinPresets()) {
            values.words = joined(values.words, entry.id);
        }
        values.files = true;
    } else if (type.starts_with("KEY=VALUE")) {
        for (const Parameter& parameter : parameterTable()) {
            values.words = joined(values.words, std::string(parameter.key) + "=");
        }
        values.unfinished = true;
    } else if (type.starts_with("FILE") || type.starts_with("FOLDER")) {
        values.files = true;
    }
    return values;
}

bool takesValue(const CLI::Option& option)
{
    return option.get_items_expected_max() > 0;
}

std::vector<std::string> namesOf(const CLI::Option& option)
{
    std::vector<std::string> names;
    for (const std::string& name : option.get_snames()) {
        names.push_back("-" + name);
    }
    for (const std::string& name : option.get_lnames()) {
        names.push_back("--" + name);
    }
    return names;
}

/// Options, or the arguments that are none, of a command.
std::vector<const CLI::Option*> optionsOf(const CLI::App& command, bool positional)
{
    return command.get_options([&](const CLI::Option* option) {
        return option->get_positional() == positional && !option->get_group().empty();
    });
}

std::vector<const CLI::App*> subcommandsOf(const CLI::App& program)
{
    return program.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

/// Those of the program are understood after a subcommand too.
std::vector<const CLI::Option*> optionsWithin(const CLI::App& program, const CLI::App* command)
{
    std::vector<const CLI::Option*> options = optionsOf(program, false);
    if (command != nullptr) {
        std::erase_if(options,
            [&](const CLI::Option* each) { return command->get_option_no_throw(each->get_name()) != nullptr; });
        const std::vector<const CLI::Option*> own = optionsOf(*command, false);
        options.insert(options.begin(), own.begin(), own.end());
    }
    return options;
}

// bash

std::string bashReply(const Values& values)
{
    std::string line;
    if (values.unfinished) {
        line += "compopt -o nospace; ";
    }
    if (!values.words.empty()) {
        line += "words='" + values.words + "'; ";
    }
    return line + (values.files ? "files=yes" : "files=");
}

/// Lines of a case statement over "subcommand:option before the cursor", and the one for everything else.
std::string bashCases(const CLI::App& program, const CLI::App* command)
{
    const std::string prefix = command == nullptr ? "" : command->get_name();
    std::string lines;
    std::string all;
    for (const CLI::Option* option : optionsWithin(program, command)) {
        std::string patterns;
        for (const std::string& name : namesOf(*option)) {
            all = joined(all, name);
            patterns += (patterns.empty() ? "" : " | ") + prefix + ":" + name;
        }
        if (takesValue(*option)) {
            lines += "    " + patterns + ") " + bashReply(valuesOf(*option)) + " ;;\n";
        }
    }
    Values arguments;
    if (command == nullptr) {
        for (const CLI::App* each : subcommandsOf(program)) {
            arguments.words = joined(arguments.words, each->get_name());
        }
    } else if (const auto positionals = optionsOf(*command, true); !positionals.empty()) {
        arguments = valuesOf(*positionals.front());
    }
    return lines + "    " + prefix + ":*) " + bashReply(arguments) + "; options='" + all + "' ;;\n";
}

std::string bashScript(const CLI::App& program)
{
    std::string names;
    std::string cases;
    for (const CLI::App* command : subcommandsOf(program)) {
        names += (names.empty() ? "" : " | ") + command->get_name();
        cases += bashCases(program, command);
    }
    return R"(# Completion for bash, written by "fumage-cli completions bash".
_fumage_cli() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command='' words='' options='' files='' i
    for ((i = 1; i < COMP_CWORD; i++)); do
        case ${COMP_WORDS[i]} in
        )"
        + names + R"() command=${COMP_WORDS[i]}; break ;;
        esac
    done
    case $command:$before in
)" + cases
        + bashCases(program, nullptr) + R"(    esac
    [[ $word == -* ]] && words=$options files=''
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word"; [ -z "$files" ] || compgen -f -- "$word")
    [ -z "$files" ] || compopt -o filenames
}
complete -F _fumage_cli fumage-cli
)";
}

// zsh

/// Text inside '...' and [...].
std::string zshQuoted(const std::string& text)
{
    std::string out;
    for (const char c : text) {
        if (c == '\'') {
            out += "'\\''";
        } else if (c == '[' || c == ']' || c == ':' || c == '\\') {
            out += std::string("\\") + c;
        } else {
            out += c;
        }
    }
    return out;
}

std::string zshValues(const CLI::Option& option)
{
    const Values values = valuesOf(option);
    if (values.unfinished) {
        return ":parameter:{compadd -S \"\" -- " + values.words + "}";
    }
    if (!values.words.empty() && values.files) {
        return ":preset:{compadd -- " + values.words + "; _files}";
    }
    return values.files ? ":file:_files" : ":value:(" + values.words + ")";
}

/// The specifications that _arguments takes, one a line.
std::string zshArguments(const CLI::App& program, const CLI::App* command)
{
    std::string lines;
    for (const CLI::Option* option : optionsWithin(program, command)) {
        std::string all;
        for (const std::string& name : namesOf(*option)) {
            all = joined(all, name);
        }
        for (const std::string& name : namesOf(*option)) {
            const bool repeats = option->get_items_expected_max() > 1;
            const std::string before = repeats ? "*" : "(" + all + ")";
            lines += " \\\n        '" + before + name + "[" + zshQuoted(option->get_description()) + "]"
                + (takesValue(*option) ? zshValues(*option) : "") + "'";
        }
    }
    if (command != nullptr) {
        for (const CLI::Option* option : optionsOf(*command, true)) {
            lines += " \\\n        '" + std::string(option->get_items_expected_max() > 1 ? "*" : "") + ":"
                + zshValues(*option).substr(1) + "'";
        }
    }
    return lines;
}

std::string zshScript(const CLI::App& program)
{
    std::string descriptions;
    std::string cases;
    for (const CLI::App* command : subcommandsOf(program)) {
        descriptions += "        '" + command->get_name() + ":" + zshQuoted(command->get_description()) + "'\n";
        cases +=
            "    " + command->get_name() + ")\n        _arguments" + zshArguments(program, command) + "\n        ;;\n";
    }
    return R"(#compdef fumage-cli
# Completion for zsh, written by "fumage-cli completions zsh".
_fumage-cli() {
    local curcontext=$curcontext state line
    local -a commands=(
)" + descriptions
        + R"(    )
    _arguments -C)"
        + zshArguments(program, nullptr) + R"( \
        '1: :->command' '*:: :->arguments'
    if [[ $state == command ]]; then
        _describe command commands
        return
    fi
    [[ $state == arguments ]] || return
    case $words[1] in
)" + cases
        + R"(    esac
}
_fumage-cli "$@"
)";
}

} // namespace

void addCompletions(CLI::App& program, Action& action)
{
    CLI::App* command = program.add_subcommand(
        "completions", "Print the script with which a shell completes this program's command line");
    const auto shell = std::make_shared<std::string>();
    command->add_option("shell", *shell, "bash or zsh")->required()->check(CLI::IsMember({"bash", "zsh"}));
    command->footer("Packages install them. By hand:\n"
                    "  fumage-cli completions bash > ~/.local/share/bash-completion/completions/fumage-cli\n"
                    "  fumage-cli completions zsh > ~/.zfunc/_fumage-cli");
    command->callback([&program, &action, shell] {
        action = [&program, shell]() -> Status {
            return print(*shell == "bash" ? bashScript(program) : zshScript(program));
        };
    });
}

} // namespace fumage::cli
