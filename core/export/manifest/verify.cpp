#include "core/export/manifest/verify.h"

#include "core/system/file.h"
#include "core/system/path.h"
#include "core/export/sheets/cell_frames.h"
#include "core/export/sheets/flipbook.h"
#include "core/export/manifest/recorded.h"
#include "core/export/output_name.h"

#include <algorithm>
#include <map>
#include <set>

namespace fumage {

namespace {

/// What manifests say of a file together.
struct Expectation {
    std::optional<int> frame;
    Content content;
    bool contradicted = false;
};

std::map<std::string, Expectation> expectationsOf(const ManifestSet& set)
{
    std::map<std::string, Expectation> all;
    for (const FoundManifest& found : set.manifests) {
        for (const ManifestEntry& entry : found.manifest.files) {
            const auto [at, isNew] = all.try_emplace(entry.file, Expectation{entry.frame, entry.content, false});
            at->second.contradicted = at->second.contradicted || at->second.content != entry.content;
        }
    }
    return all;
}

/// What is wrong with a file that could not be opened, or read to its end.
FileState stateAfter(const Error& error, const std::filesystem::path& file)
{
    std::error_code unknown;
    switch (error.code) {
    case ErrorCode::FileNotFound: return FileState::Missing;
    case ErrorCode::NotAFile:
        return std::filesystem::exists(std::filesystem::symlink_status(file, unknown)) ? FileState::NotAFile
                                                                                       : FileState::Missing;
    case ErrorCode::Syntax:
    case ErrorCode::TooLarge: return FileState::Broken;
    default: return FileState::Unreadable;
    }
}

CheckedFile checkFile(const std::string& name, const std::filesystem::path& file, const Expectation& expected)
{
    const Result<Content> content = contentOfFile(file);
    CheckedFile checked{name, expected.frame, FileState::Same};
    if (!content) {
        checked.state = stateAfter(content.error(), file);
        checked.why = checked.state == FileState::Missing ? Message() : content.error().message;
    } else if (expected.contradicted) {
        checked.state = FileState::Contradicted;
    } else {
        checked.state = content.value() == expected.content ? FileState::Same : FileState::Different;
    }
    return checked;
}

/// Files that have the ending of one that is named, and are not.
std::vector<CheckedFile> extrasOf(const ManifestSet& set, const std::map<std::string, Expectation>& expected)
{
    std::set<std::string> endings;
    for (const auto& [file, expectation] : expected) {
        endings.insert(endingOf(pathFrom(file)));
    }
    std::vector<CheckedFile> extras;
    std::error_code error;
    for (std::filesystem::directory_iterator at(set.folder, error), end; !error && at != end; at.increment(error)) {
        const std::string name = at->path().filename().string();
        const bool isOfTheKind =
            endings.contains(endingOf(at->path())) && !name.starts_with('.') && !name.ends_with(".json");
        if (isOfTheKind && !expected.contains(name) && at->is_regular_file(error)) {
            extras.push_back({name, {}, FileState::Extra});
        }
    }
    std::ranges::sort(extras, {}, &CheckedFile::file);
    return extras;
}

std::vector<CheckedFile> unnamedOf(const FrameRange& frames, const std::map<std::string, Expectation>& expected)
{
    std::set<int> named;
    for (const auto& [file, expectation] : expected) {
        named.insert(expectation.frame.value_or(-1));
    }
    std::vector<CheckedFile> unnamed;
    for (int i = 0; i < frames.count(); ++i) {
        if (!named.contains(frames.at(i))) {
            unnamed.push_back({{}, frames.at(i), FileState::Missing});
        }
    }
    return unnamed;
}

/// Parts of one job as one, so that its air is baked once.
std::map<std::string, Manifest> jobsOf(const ManifestSet& set)
{
    std::map<std::string, Manifest> jobs;
    for (const FoundManifest& found : set.manifests) {
        const auto [at, isNew] = jobs.try_emplace(found.manifest.job.hash(), found.manifest);
        if (!isNew) {
            at->second.files.insert(at->second.files.end(), found.manifest.files.begin(), found.manifest.files.end());
        }
    }
    return jobs;
}

/// Renders the flipbook of a job, where it shows a frame that is wanted.
Status renderFlipbookJob(
    const Manifest& job, const FrameRange& wanted, std::vector<CheckedFile>& checked, const Task& task)
{
    const Result<FlipbookOptions> options = flipbookOf(job.job);
    if (!options) {
        return options.error();
    }
    const std::vector<int> shown = framesOfCells(options.value());
    if (std::ranges::none_of(shown, [&](int frame) { return wanted.has(frame); })) {
        return Done{};
    }
    const Result<std::vector<FlipbookFile>> made = encodeFlipbook(job.job.scene, options.value(), task);
    if (!made) {
        return made.error();
    }
    std::map<std::string, Content> contents;
    for (const FlipbookFile& file : made.value()) {
        Result<Content> content = contentOf(file.bytes);
        if (!content) {
            return content.error();
        }
        contents[file.path.filename().string()] = std::move(content).value();
    }
    for (const ManifestEntry& entry : job.files) {
        const auto found = contents.find(pathFrom(entry.file).filename().string());
        checked.push_back({entry.file, {},
            found != contents.end() && found->second == entry.content ? FileState::Same : FileState::Different});
    }
    return Done{};
}

/// Why files of wanted frames are not rendered again: of a job that is neither frames nor a flipbook.
std::optional<Error> refusalOf(const Manifest& job, const FrameRange& wanted)
{
    const bool hasWanted = std::ranges::any_of(
        job.files, [&](const ManifestEntry& entry) { return entry.frame && wanted.has(*entry.frame); });
    const Result<SequenceOptions> options = sequenceOf(job.job);
    return hasWanted && !options ? std::optional(options.error()) : std::nullopt;
}

/// Renders the frames of a job that are wanted.
Status renderFrames(const Manifest& job, const FrameRange& wanted, std::vector<CheckedFile>& checked, const Task& task)
{
    Result<SequenceOptions> options = sequenceOf(job.job);
    if (!options) {
        return options.error();
    }
    std::map<int, const ManifestEntry*> entries;
    for (const ManifestEntry& entry : job.files) {
        const int frame = entry.frame.value_or(-1);
        if (wanted.has(frame)) {
            entries.emplace(frame, &entry);
        }
    }
    if (entries.empty()) {
        return Done{};
    }
    FrameRange& range = options.value().frames;
    range.first = entries.begin()->first;
    range.last = entries.rbegin()->first;
    for (int i = 0; i < range.count(); ++i) {
        if (!entries.contains(range.at(i))) {
            options.value().leftOut.push_back(range.at(i));
        }
    }
    std::map<int, Content> made;
    const auto keep = [&](int frame, std::span<const std::byte> bytes) -> Status {
        Result<Content> content = contentOf(bytes);
        if (!content) {
            return content.error();
        }
        made[frame] = std::move(content).value();
        return Done{};
    };
    if (Status status = encodeFrames(job.job.scene, options.value(), keep, task); !status) {
        return status;
    }
    for (const auto& [frame, entry] : entries) {
        const auto found = made.find(frame);
        checked.push_back({entry->file, frame,
            found != made.end() && found->second == entry->content ? FileState::Same : FileState::Different});
    }
    return Done{};
}

} // namespace

std::string_view nameOf(FileState state)
{
    switch (state) {
    case FileState::Same: return "same";
    case FileState::Missing: return "missing";
    case FileState::Different: return "different";
    case FileState::Broken: return "broken";
    case FileState::Contradicted: return "contradicted";
    case FileState::Extra: return "extra";
    case FileState::NotAFile: return "not_a_file";
    case FileState::Unreadable: return "unreadable";
    }
    return {};
}

Result<ManifestSet> openManifests(const std::filesystem::path& folderOrManifest)
{
    std::error_code error;
    if (!std::filesystem::is_directory(folderOrManifest, error)) {
        Result<Manifest> manifest = readManifest(folderOrManifest);
        if (!manifest) {
            return manifest.error();
        }
        ManifestSet set{folderOrManifest.parent_path(), false, {}};
        set.manifests.push_back({folderOrManifest, std::move(manifest).value()});
        return set;
    }
    std::vector<Error> broken;
    Result<std::vector<FoundManifest>> found = findManifests(folderOrManifest, &broken);
    if (!found) {
        return found.error();
    }
    if (found.value().empty() && !broken.empty()) {
        return broken.front();
    }
    if (found.value().empty()) {
        return Error{ErrorCode::FileNotFound, makeMessage("there is no manifest in this folder"),
            folderOrManifest.string(), makeMessage("Write pictures with --manifest")};
    }
    return ManifestSet{folderOrManifest, true, std::move(found).value(), std::move(broken)};
}

Result<std::vector<CheckedFile>> checkFiles(
    const ManifestSet& set, const std::optional<FrameRange>& frames, const Task& task)
{
    const std::map<std::string, Expectation> expected = expectationsOf(set);
    std::vector<CheckedFile> checked;
    const int total = static_cast<int>(expected.size());
    for (const auto& [file, expectation] : expected) {
        if (task.stopped()) {
            return Error{ErrorCode::Cancelled, makeMessage("interrupted"), {}, {}};
        }
        checked.push_back(checkFile(file, set.folder / pathFrom(file), expectation));
        task.progress(ProgressPhase::Frames, static_cast<int>(checked.size()), total);
    }
    std::vector<CheckedFile> others = set.whole ? extrasOf(set, expected) : std::vector<CheckedFile>();
    checked.insert(checked.end(), others.begin(), others.end());
    others = frames ? unnamedOf(*frames, expected) : std::vector<CheckedFile>();
    checked.insert(checked.end(), others.begin(), others.end());
    return checked;
}

Result<std::vector<CheckedFile>> renderAgain(const ManifestSet& set, const FrameRange& frames, const Task& task)
{
    std::vector<CheckedFile> checked;
    std::optional<Error> refusal;
    for (const auto& [hash, job] : jobsOf(set)) {
        Status status = Done{};
        if (job.job.kind == kFramesKind) {
            status = renderFrames(job, frames, checked, task);
        } else if (job.job.kind == kFlipbookKind) {
            status = renderFlipbookJob(job, frames, checked, task);
        } else {
            refusal = refusal ? refusal : refusalOf(job, frames);
        }
        if (!status) {
            return status.error();
        }
    }
    if (checked.empty() && refusal) {
        refusal->place = set.folder.string();
        return *refusal;
    }
    if (checked.empty()) {
        return Error{ErrorCode::OutOfRange,
            makeMessage("the manifests name none of the frames %1 to %2", frames.first, frames.last),
            set.folder.string(), makeMessage("Choose some that have been rendered, as pictures or in a flipbook")};
    }
    return checked;
}

} // namespace fumage
