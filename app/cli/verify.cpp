#include "app/cli/command.h"
#include "app/cli/json_answer.h"
#include "app/cli/progress.h"

#include "core/base/memory.h"
#include "core/system/path.h"
#include "core/base/text.h"
#include "core/export/manifest/verify.h"
#include "core/version.h"

#include <algorithm>
#include <memory>
#include <sstream>

namespace fumage::cli {

namespace {

struct VerifyOptions {
    std::string target;
    std::string frames;
    std::string rendered;
    bool asJson = false;
};

using Checked = std::vector<CheckedFile>;

/// What was found, of files or of frames that were rendered again.
struct Finding {
    Checked files;
    bool rendered = false;

    [[nodiscard]] int count(FileState state) const
    {
        return static_cast<int>(std::ranges::count(files, state, &CheckedFile::state));
    }
    [[nodiscard]] bool isClean() const { return count(FileState::Same) == static_cast<int>(files.size()); }
};

Result<std::optional<FrameRange>> rangeOf(const std::string& text, const char* option)
{
    if (text.empty()) {
        return std::optional<FrameRange>();
    }
    const Result<FrameRange> range = parseFrameRange(text);
    if (!range) {
        Error error = range.error();
        error.place = std::string(option);
        return error;
    }
    return std::optional(range.value());
}

/// Other versions may make other pictures; then it is not the machine that differs.
void warnOfVersions(const ManifestSet& set)
{
    for (const FoundManifest& found : set.manifests) {
        if (found.manifest.job.program != FUMAGE_VERSION) {
            warn(found.path.string() + ": written by Fumage " + found.manifest.job.program + ", this is "
                + FUMAGE_VERSION);
            return;
        }
    }
}

Result<Finding> find(const VerifyOptions& options, const ManifestSet& set)
{
    const Result<std::optional<FrameRange>> wanted = rangeOf(options.frames, "--frames");
    const Result<std::optional<FrameRange>> again = rangeOf(options.rendered, "--render");
    if (!wanted || !again) {
        return wanted ? again.error() : wanted.error();
    }
    const bool renders = again.value().has_value();
    ProgressBar bar(renders ? "Rendering" : "Checking");
    Result<Checked> checked = withinMemory([&] {
        return renders ? renderAgain(set, *again.value(), bar.task()) : checkFiles(set, wanted.value(), bar.task());
    });
    return checked ? Result<Finding>(Finding{std::move(checked).value(), renders}) : checked.error();
}

std::string nameOf(const CheckedFile& file)
{
    return file.file.empty() ? "frame " + std::to_string(file.frame.value_or(0)) : printable(file.file);
}

Status answerInText(const Finding& finding, const ManifestSet& set)
{
    std::ostringstream out;
    for (const Error& error : set.broken) {
        out << "unreadable manifest: " << printable(error.text()) << '\n';
    }
    for (const FileState state : kAllFileStates) {
        for (const CheckedFile& file : finding.files) {
            if (file.state == state && state != FileState::Same) {
                out << (state == FileState::NotAFile ? "not a file" : nameOf(state)) << ": " << nameOf(file)
                    << (file.why.empty() ? "" : " (" + printable(file.why.text()) + ")") << '\n';
            }
        }
    }
    const int same = finding.count(FileState::Same);
    out << same << " of " << finding.files.size()
        << (finding.rendered ? " files come out the same on this machine\n" : " files are as the manifest says\n");
    return print(out.str());
}

Status answerInJson(const Finding& finding, const ManifestSet& set)
{
    nlohmann::ordered_json answer{{"folder", set.folder.string()}, {"manifests", set.manifests.size()},
        {"rendered", finding.rendered}, {"clean", finding.isClean() && set.broken.empty()},
        {"same", finding.count(FileState::Same)}};
    for (const FileState state : kAllFileStates) {
        if (state == FileState::Same) {
            continue;
        }
        auto files = nlohmann::ordered_json::array();
        for (const CheckedFile& file : finding.files) {
            if (file.state == state) {
                files.push_back(file.file.empty() ? nlohmann::ordered_json(file.frame.value_or(0))
                                                  : nlohmann::ordered_json(file.file));
            }
        }
        answer[std::string(nameOf(state))] = files;
    }
    answer["unreadable_manifests"] = nlohmann::ordered_json::array();
    for (const Error& error : set.broken) {
        answer["unreadable_manifests"].push_back(error.text());
    }
    return printJson(answer);
}

Status verify(const VerifyOptions& options)
{
    const Result<ManifestSet> set = openManifests(pathFrom(options.target));
    if (!set) {
        return set.error();
    }
    warnOfVersions(set.value());
    const Result<Finding> finding = find(options, set.value());
    if (!finding) {
        return finding.error();
    }
    Status told =
        options.asJson ? answerInJson(finding.value(), set.value()) : answerInText(finding.value(), set.value());
    if (!told || (finding.value().isClean() && set.value().broken.empty())) {
        return told;
    }
    const Message remedy = finding.value().rendered
        ? Message()
        : makeMessage("Render them again; with --skip-existing what is there stays");
    return Error{ErrorCode::Mismatch,
        finding.value().rendered ? makeMessage("this machine does not make the same pictures")
                                 : makeMessage("the files are not what the manifest says"),
        options.target, remedy};
}

} // namespace

void addVerify(CLI::App& program, Action& action)
{
    auto options = std::make_shared<VerifyOptions>();
    CLI::App* command =
        program.add_subcommand("verify", "Hold pictures against the manifest that was written with them");
    command->add_option("target", options->target, "A folder with manifests, or one manifest")
        ->required()
        ->type_name("FOLDER");
    CLI::Option* frames = command
                              ->add_option("-f,--frames", options->frames,
                                  "Frames that must be there: 0-119. Default: those that the manifests name")
                              ->type_name("RANGE");
    command
        ->add_option("--render", options->rendered,
            "Render these frames again, and flipbooks that show one of them, and say whether this machine makes the "
            "same bits; files are not looked at")
        ->type_name("RANGE")
        ->excludes(frames);
    addJson(*command, options->asJson);
    command->footer("Files that are missing, different, broken, or in no manifest (of a folder) are named. A picture "
                    "that was compressed anew is the same as long as it shows the same.\n"
                    "Exit codes: 0 all is as it should be, 4 it is not, others as everywhere.\n"
                    "Examples:\n"
                    "  fumage-cli render chimney --manifest --output frames/smoke_####.png\n"
                    "  fumage-cli verify frames/ --frames 0-119\n"
                    "  fumage-cli verify frames/ --render 7");
    command->callback([options, &action] { action = [options] { return verify(*options); }; });
}

} // namespace fumage::cli
