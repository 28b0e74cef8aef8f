#include "app/cli/command.h"
#include "app/cli/number_options.h"
#include "app/cli/system.h"

#include "core/base/caught.h"
#include "core/base/parallel.h"
#include "core/base/simd.h"
#include "core/base/text.h"
#include "core/version.h"

#include <algorithm>
#include <iostream>
#include <memory>
#include <new>
#include <sstream>
#include <string_view>
#include <vector>

namespace {

using namespace fumage;
using namespace fumage::cli;

int report(const Error& error)
{
    std::cerr << "fumage-cli: " << printable(error.text()) << '\n';
    tellOpenJd("fail", error.text());
    return exitCodeOf(error.code);
}

/// Prints help, or what is wrong with the command line.
int answer(const CLI::App& program, const CLI::ParseError& error)
{
    std::ostringstream out;
    std::ostringstream complaint;
    if (program.exit(error, out, complaint) == 0) {
        const Status status = print(out.str());
        return status ? kSuccess : report(status.error());
    }
    const bool isValue = dynamic_cast<const CLI::ValidationError*>(&error) != nullptr
        || dynamic_cast<const CLI::ConversionError*>(&error) != nullptr;
    std::cerr << "fumage-cli: " << (isValue ? printable(error.what()) + '\n' : complaint.str());
    return isValue ? kBadInput : kUsage;
}

/// Whether the first word that is no option is a command.
Status checkCommand(const CLI::App& program, const std::vector<std::string>& words)
{
    const auto word =
        std::find_if(words.begin(), words.end(), [](const std::string& text) { return !text.starts_with('-'); });
    const bool isValue = word != words.begin() && word != words.end()
        && (*(word - 1) == "--threads" || *(word - 1) == "--simd" || *(word - 1) == "--progress");
    if (word == words.end() || isValue) {
        return Done{};
    }
    std::vector<std::string> names;
    for (const CLI::App* command : program.get_subcommands(nullptr)) {
        names.push_back(command->get_name());
    }
    if (std::find(names.begin(), names.end(), *word) != names.end()) {
        return Done{};
    }
    const std::vector<std::string_view> candidates(names.begin(), names.end());
    const std::string_view near = nearestName(*word, candidates);
    return Error{ErrorCode::UnknownName, makeMessage("there is no command %1", inQuotes(*word)), {},
        near.empty() ? makeMessage("List them with: fumage-cli --help")
                     : makeMessage("Did you mean %1?", inQuotes(near))};
}

/// Options that come before or after any command.
struct CommonOptions {
    int threads = 0;
    std::string simd;
    bool quiet = false;
    std::string progress;

    void addTo(CLI::App& program)
    {
        constexpr int kMaxThreads = 1024;
        addWhole(
            program, "--threads", threads, 0, kMaxThreads, "Use at most this many threads; 0 is as many as there are");
        program
            .add_option(
                "--simd", simd, "Force an instruction set (avx512, avx2, sse4, baseline): slower, the same bits")
            ->type_name("NAME");
        program
            .add_option("--progress", progress,
                "Say how far the work is: bar (on terminals, the default), or openjd, lines that Open Job Description "
                "reads on standard output")
            ->check(CLI::IsMember({"bar", "openjd"}));
        program.add_flag("-q,--quiet", quiet, "Say nothing but what goes wrong");
        program.fallthrough();
    }

    void apply() const
    {
        if (quiet) {
            beQuiet();
        }
        if (progress == "openjd") {
            talkToOpenJd();
        }
    }
};

void addCommands(CLI::App& program, Action& action)
{
    program.require_subcommand(1);
    addRender(program, action);
    addFlipbook(program, action);
    addVideo(program, action);
    addVolume(program, action);
    addCheckSheet(program, action);
    addFit(program, action);
    addBakeNoise(program, action);
    addDump(program, action);
    addAir(program, action);
    addJoin(program, action);
    addFarm(program, action);
    addVerify(program, action);
    addValidate(program, action);
    addInfo(program, action);
    addPresets(program, action);
    addParameters(program, action);
    addSchema(program, action);
    addCompletions(program, action);
}

/// The words of the command line; "help render" is "render --help", as in git.
std::vector<std::string> wordsOf(int argc, char** argv)
{
    std::vector<std::string> words = argumentsOf(argc, argv);
    if (!words.empty() && words.front() == "help") {
        words.erase(words.begin());
        words.emplace_back("--help");
    }
    return words;
}

int run(int argc, char** argv)
{
    (void)interruption(); // before any thread starts, so that all of them have the signals blocked
    const StandardStreams streams;
    CLI::App program(
        "Fumage makes smoke: it renders presets to pictures and bakes noise, without a display.", "fumage-cli");
    program.allow_windows_style_options(false); // /tmp/smoke.png is a file
    program.set_version_flag("-V,--version", std::string("fumage-cli ") + FUMAGE_VERSION);
    program.footer("Start with:\n"
                   "  fumage-cli presets\n"
                   "  fumage-cli render campfire --frames 0-119 --output frames/fire_####.png\n\n"
                   "Exit codes: 0 done, 1 could not be done, 2 wrong usage, 3 bad preset or value, 4 files are not "
                   "what verify expects: trying again is of no use. "
                   "75 the disk is full, memory, threads or open files ran out, or reading or writing failed, 130 "
                   "interrupted: the same may work another time or on another machine.");
    CommonOptions common;
    common.addTo(program);
    Action action;
    addCommands(program, action);
    std::vector<std::string> words = wordsOf(argc, argv);
    if (const Status status = checkCommand(program, words); !status) {
        (void)report(status.error());
        return kUsage;
    }
    try {
        std::reverse(words.begin(), words.end()); // as the library takes them
        program.parse(words);
    } catch (const CLI::ParseError& error) {
        return answer(program, error);
    }
    common.apply();
    if (const Status status = common.simd.empty() ? Status(Done{}) : forceSimdTarget(common.simd); !status) {
        return report(status.error());
    }
    const std::unique_ptr<ThreadLimit> limit =
        common.threads > 0 ? std::make_unique<ThreadLimit>(common.threads) : nullptr;
    const Status status = action();
    return status ? kSuccess : report(status.error());
}

} // namespace

int main(int argc, char** argv)
{
    try {
        return run(argc, argv);
    } catch (const std::bad_alloc&) { // there may be none left for a message that is put together
        std::cerr << "fumage-cli: not enough memory. Use fewer particles or a smaller picture\n";
        return fumage::cli::kTryAgain;
    } catch (...) {
        return report(fumage::caughtError());
    }
}
