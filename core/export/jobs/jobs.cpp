#include "core/export/sheets/flipbook_files.h"
#include "core/export/jobs/jobs.h"

#include "core/base/text.h"

#include <algorithm>

namespace fumage {

namespace {

/// Where a folder lies, be it there or not.
std::filesystem::path placeOf(const std::filesystem::path& folder)
{
    std::error_code unknown;
    // Of what is not there yet weakly_canonical() leaves a relative path as it is, and makes it whole once it is there.
    const std::filesystem::path place = std::filesystem::absolute(folder.empty() ? "." : folder, unknown);
    const std::filesystem::path whole = unknown ? place : std::filesystem::weakly_canonical(place, unknown);
    const std::filesystem::path found = unknown ? folder.lexically_normal() : whole;
    return found.has_filename() ? found : found.parent_path(); // "a/b/.." is "a/"
}

/// A folder, and what stands for it where files are compared.
struct Folder {
    std::filesystem::path place;
    std::string key; ///< what is not there yet in small letters
};

Folder folderAt(const std::filesystem::path& folder)
{
    Folder found{placeOf(folder), {}};
    std::error_code unknown;
    std::filesystem::path there = found.place;
    while (!std::filesystem::exists(there, unknown) && there.has_relative_path()) {
        there = there.parent_path();
    }
    found.key = found.place.string();
    const std::size_t known = std::min(there.string().size(), found.key.size());
    found.key = found.key.substr(0, known) + inSmallLetters(found.key.substr(known)) + '/';
    return found;
}

/// A file by where it lies.
struct Place {
    std::string file;
    std::string key; ///< what it is compared by
};

Place placeIn(const Folder& folder, const std::filesystem::path& name)
{
    return {(folder.place / name).string(), folder.key + inSmallLetters(name.string())};
}

/// @param files most of them after others of their folder, which is looked for once
std::vector<Place> placesOf(std::span<const std::filesystem::path> files)
{
    std::vector<Place> places;
    places.reserve(files.size());
    std::filesystem::path named;
    Folder folder;
    for (const std::filesystem::path& file : files) {
        if (places.empty() || file.parent_path() != named) {
            named = file.parent_path();
            folder = folderAt(named);
        }
        places.push_back(placeIn(folder, file.filename()));
    }
    return places;
}

/// What a job writes, its manifest among it.
std::vector<std::filesystem::path> allFilesOf(const ExportJob& job)
{
    std::vector<std::filesystem::path> files = filesOf(job.preset.scene, job.plan);
    if (std::filesystem::path manifest = manifestOf(job.plan); !manifest.empty()) {
        files.push_back(std::move(manifest));
    }
    return files;
}

} // namespace

Result<std::optional<Flipbook>> runJob(const ExportJob& job, const ExportTask& task)
{
    if (job.refusal) {
        return *job.refusal;
    }
    ExportPlan plan = job.plan;
    if (plan.project) {
        plan.project = job.preset;
    }
    return runExport(job.preset.scene, plan, task);
}

Status JobFiles::check(const ExportJob& job) const
{
    return check(job.name, allFilesOf(job));
}

Status JobFiles::check(const std::string& name, std::span<const std::filesystem::path> files) const
{
    if (files.size() + m_writers.size() > kMaxJobFiles) {
        return Error{ErrorCode::TooLarge, makeMessage("the jobs write more than %1 files", kMaxJobFiles),
            inQuotes(name), makeMessage("Make two lists of them")};
    }
    for (const Place& place : placesOf(files)) {
        if (const auto found = m_writers.find(place.key); found != m_writers.end()) {
            return Error{ErrorCode::WouldOverwrite,
                makeMessage("%1 would write over a file of %2", inQuotes(name), inQuotes(m_names[found->second])),
                place.file, makeMessage("Choose another name")};
        }
    }
    return Done{};
}

Status JobFiles::add(const ExportJob& job)
{
    return add(job.name, allFilesOf(job));
}

Status JobFiles::add(const std::string& name, std::span<const std::filesystem::path> files)
{
    if (Status status = check(name, files); !status) {
        return status;
    }
    for (Place& place : placesOf(files)) {
        m_writers.emplace(std::move(place.key), m_names.size());
    }
    m_names.push_back(name);
    return Done{};
}

std::optional<std::size_t> JobFiles::writerOf(const std::filesystem::path& file) const
{
    const auto found = m_writers.find(placeIn(folderAt(file.parent_path()), file.filename()).key);
    return found == m_writers.end() ? std::nullopt : std::optional(found->second);
}

Status checkJobs(std::span<const ExportJob> jobs)
{
    JobFiles files;
    for (const ExportJob& job : jobs) {
        if (Status status = files.add(job); !status) {
            return status;
        }
    }
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        const std::filesystem::path& source = jobs[i].plan.source;
        const std::optional<std::size_t> writer = source.empty() ? std::nullopt : files.writerOf(source);
        if (writer && *writer != i) {
            return Error{ErrorCode::WouldOverwrite,
                makeMessage("%1 would overwrite the preset that %2 is made of", inQuotes(jobs[*writer].name),
                    inQuotes(jobs[i].name)),
                source.string(), makeMessage("Choose another name")};
        }
    }
    return Done{};
}

} // namespace fumage
