#include "app/cli/command.h"

#include "core/base/parallel.h"
#include "core/base/simd.h"
#include "core/version.h"

#include <exception>
#include <iostream>
#include <memory>

namespace {

using namespace fumage;
using namespace fumage::cli;

int exitCodeOf(ErrorCode code)
{
    switch (code) {
    case ErrorCode::Cancelled: return kInterrupted;
    case ErrorCode::NotUtf8:
    case ErrorCode::Syntax:
    case ErrorCode::TooDeep:
    case ErrorCode::TooLarge:
    case ErrorCode::WrongType:
    case ErrorCode::WrongVersion:
    case ErrorCode::NotFinite:
    case ErrorCode::UnknownKey:
    case ErrorCode::UnknownName:
    case ErrorCode::OutOfRange: return kBadInput;
    default: return kFailure;
    }
}

int report(const Error& error)
{
    std::cerr << "fumage-cli: " << error.text() << '\n';
    return exitCodeOf(error.code);
}

int run(int argc, char** argv)
{
    CLI::App program("Fumage makes smoke: it renders presets to pictures and bakes noise, without a display.", "fumage-cli");
    program.set_version_flag("--version", std::string("fumage-cli ") + FUMAGE_VERSION);
    program.footer("Start with:\n"
                   "  fumage-cli presets\n"
                   "  fumage-cli render campfire --frames 0-119 --output frames/fire_####.png\n\n"
                   "Exit codes: 0 done, 1 could not be done, 2 wrong usage, 3 bad preset or value, 130 interrupted.");
    program.require_subcommand(1);
    int threads = 0;
    std::string simd;
    program.add_option("--threads", threads, "Use at most this many threads; 0 is as many as there are")->check(CLI::Range(0, 1024));
    program.add_option("--simd", simd, "Force an instruction set (avx512, avx2, sse4, baseline): slower, the same bits")->type_name("NAME");
    program.fallthrough();

    Action action;
    addRender(program, action);
    addFlipbook(program, action);
    addBakeNoise(program, action);
    addDump(program, action);
    addValidate(program, action);
    addInfo(program, action);
    addPresets(program, action);
    addParameters(program, action);
    addSchema(program, action);
    addCompletions(program, action);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? kSuccess : kUsage;
    }
    if (!simd.empty()) {
        if (const Status status = forceSimdTarget(simd); !status) {
            return report(status.error());
        }
    }
    (void)interruption(); // before any thread starts, so that all of them have the signals blocked
    const std::unique_ptr<ThreadLimit> limit = threads > 0 ? std::make_unique<ThreadLimit>(threads) : nullptr;
    const Status status = action();
    return status ? kSuccess : report(status.error());
}

} // namespace

int main(int argc, char** argv)
{
    try {
        return run(argc, argv);
    } catch (const std::bad_alloc&) {
        std::cerr << "fumage-cli: not enough memory. Use fewer particles or a smaller picture\n";
    } catch (const std::exception& error) {
        std::cerr << "fumage-cli: " << error.what() << '\n';
    }
    return fumage::cli::kFailure;
}
