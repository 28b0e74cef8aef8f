#include "core/export/manifest/manifest_parts.h"

#include "core/system/file.h"
#include "core/system/path.h"
#include "core/base/text.h"
#include "core/export/output_name.h"

#include <algorithm>
#include <set>

namespace fumage {

namespace {

constexpr std::string_view kEnding = ".manifest.json";

/// The name without what says that it is a manifest.
std::string stemOf(const std::filesystem::path& manifest)
{
    std::string name = manifest.filename().string();
    for (const std::string_view ending : {kEnding, std::string_view(".json")}) {
        if (name.ends_with(ending)) {
            return name.substr(0, name.size() - ending.size());
        }
    }
    return name;
}

/// Whether a file is a part of a manifest with this stem, or the manifest itself.
bool belongsTo(const std::string& stem, const std::filesystem::path& path)
{
    const std::string name = stemOf(path);
    return isManifest(path)
        && (name == stem
            || (name.starts_with(stem + ".")
                && name.find_first_not_of("0123456789-x", stem.size() + 1) == std::string::npos));
}

std::vector<std::filesystem::path> manifestsIn(const std::filesystem::path& folder, std::error_code& error)
{
    std::vector<std::filesystem::path> found;
    for (std::filesystem::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
        if (isManifest(at->path())) {
            found.push_back(at->path());
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

std::filesystem::path folderOf(const std::filesystem::path& file)
{
    return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

} // namespace

bool isManifest(const std::filesystem::path& file)
{
    return file.filename().string().ends_with(kEnding);
}

std::filesystem::path withinFolderOf(const std::filesystem::path& manifest, const std::filesystem::path& file)
{
    return std::filesystem::absolute(file).lexically_normal().lexically_relative(
        std::filesystem::absolute(folderOf(manifest)).lexically_normal());
}

std::filesystem::path manifestBeside(const std::filesystem::path& output)
{
    return output.parent_path() / pathFrom(nameWithoutNumber(output) + std::string(kEnding));
}

std::filesystem::path partOf(const std::filesystem::path& manifest, const std::optional<FrameRange>& frames)
{
    std::string name = stemOf(manifest);
    if (frames) {
        name += "." + std::to_string(frames->first) + "-" + std::to_string(frames->last)
            + (frames->step > 1 ? "x" + std::to_string(frames->step) : "");
    }
    return manifest.parent_path() / pathFrom(name + std::string(kEnding));
}

Result<Manifest> readManifest(const std::filesystem::path& path)
{
    const Result<std::string> text = readFile(path, kMaxManifestBytes);
    return text ? parseManifest(text.value(), path.string()) : text.error();
}

Result<std::vector<FoundManifest>> findManifests(const std::filesystem::path& folder, std::vector<Error>* broken)
{
    std::error_code error;
    std::vector<FoundManifest> found;
    for (const std::filesystem::path& path : manifestsIn(folder, error)) {
        Result<Manifest> manifest = readManifest(path);
        if (!manifest && broken != nullptr) {
            broken->push_back(manifest.error());
            continue;
        }
        if (!manifest) {
            return manifest.error();
        }
        found.push_back({path, std::move(manifest).value()});
    }
    if (error) {
        return Error{ErrorCode::FileNotFound, makeMessage("the folder cannot be read: %1", error.message()),
            folder.string(), {}};
    }
    return found;
}

ManifestRecorder::ManifestRecorder(
    ManifestJob job, const std::filesystem::path& manifest, const std::optional<FrameRange>& frames)
    : m_manifest(manifest)
    , m_part(partOf(manifest, frames))
    , m_recorded{std::move(job), {}, {}}
{
    m_recorded.jobHash = m_recorded.job.hash();
}

Status ManifestRecorder::add(
    const std::filesystem::path& file, std::optional<int> frame, std::span<const std::byte> bytes)
{
    Result<Content> content = contentOf(bytes);
    if (!content) {
        Error error = content.error();
        error.place = file.string();
        return error;
    }
    return add(file, frame, std::move(content).value());
}

Status ManifestRecorder::add(const std::filesystem::path& file, std::optional<int> frame, Content content)
{
    const std::filesystem::path within = withinFolderOf(m_manifest, file);
    if (within.empty() || *within.begin() == "..") {
        return Error{ErrorCode::OutOfRange,
            makeMessage("%1 does not lie in the folder of its manifest", inQuotes(file.string())), m_manifest.string(),
            makeMessage("Name one in the folder of the pictures, or above it")};
    }
    m_recorded.files.push_back({within.generic_string(), frame, std::move(content)});
    return Done{};
}

Status ManifestRecorder::write()
{
    if (m_recorded.files.empty()) {
        return Done{};
    }
    const auto orderOf = [](const ManifestEntry& entry) { return entry.frame.value_or(-1); };
    std::ranges::stable_sort(m_recorded.files, {}, orderOf);
    if (Status status = makeFolderOf(m_part); !status) {
        return status;
    }
    if (Status status = writeFileAtomically(m_part, formatManifest(m_recorded)); !status) {
        return status;
    }
    removeOutdated();
    return Done{};
}

void ManifestRecorder::removeOutdated() const
{
    std::set<std::string> mine;
    for (const ManifestEntry& entry : m_recorded.files) {
        mine.insert(entry.file);
    }
    std::error_code ignored; // what cannot be read or removed, checking will tell
    for (const std::filesystem::path& path : manifestsIn(folderOf(m_manifest), ignored)) {
        if (path.filename() == m_part.filename() || !belongsTo(stemOf(m_manifest), path)) {
            continue;
        }
        const Result<Manifest> other = readManifest(path);
        const auto isMine = [&](const ManifestEntry& entry) { return mine.contains(entry.file); };
        if (other && other.value().jobHash != m_recorded.jobHash
            && std::any_of(other.value().files.begin(), other.value().files.end(), isMine)) {
            std::filesystem::remove(path, ignored);
        }
    }
}

} // namespace fumage
