#include "core/export/sheets/flipbook_files.h"
#include "core/export/jobs/jobs.h"

#include "core/base/text.h"

namespace fumage {

namespace {

/// Where a folder lies, be it there or not.
std::filesystem::path placeOf(const std::filesystem::path& folder)
{
    std::error_code unknown;
    // Of what is not there yet weakly_canonical() leaves a relative path as it is, and makes it whole once it is there.
    const std::filesystem::path place = std::filesystem::absolute(folder.empty() ? "." : folder, unknown);
    const std::filesystem::path whole = unknown ? place : std::filesystem::weakly_canonical(place, unknown);
    return unknown ? folder.lexically_normal() : whole;
}

/// What a job writes, by where it lies. Files of a plan lie in one folder; its manifest may lie above them.
std::vector<std::string> placesOf(const ExportJob& job)
{
    const ExportPlan& plan = job.plan;
    std::vector<std::string> places;
    const std::filesystem::path folder = placeOf(plan.output.parent_path());
    for (const std::filesystem::path& file : filesOf(job.preset.scene, plan)) {
        places.push_back((folder / file.filename()).string());
    }
    if (const std::filesystem::path manifest = manifestOf(plan); !manifest.empty()) {
        places.push_back((placeOf(manifest.parent_path()) / manifest.filename()).string());
    }
    return places;
}

} // namespace

Result<std::optional<Flipbook>> runJob(const ExportJob& job, const Task& task)
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
    const std::vector<std::string> files = placesOf(job);
    if (files.size() + m_writers.size() > kMaxJobFiles) {
        return Error{ErrorCode::TooLarge, makeMessage("the jobs write more than %1 files", kMaxJobFiles),
            inQuotes(job.name), makeMessage("Make two lists of them")};
    }
    for (const std::string& file : files) {
        if (const auto found = m_writers.find(file); found != m_writers.end()) {
            return Error{ErrorCode::WouldOverwrite,
                makeMessage("%1 would write over a file of %2", inQuotes(job.name), inQuotes(m_names[found->second])),
                file, makeMessage("Choose another name")};
        }
    }
    return Done{};
}

Status JobFiles::add(const ExportJob& job)
{
    if (Status status = check(job); !status) {
        return status;
    }
    for (std::string& file : placesOf(job)) {
        m_writers.emplace(std::move(file), m_names.size());
    }
    m_names.push_back(job.name);
    return Done{};
}

std::optional<std::size_t> JobFiles::writerOf(const std::filesystem::path& file) const
{
    const auto found = m_writers.find((placeOf(file.parent_path()) / file.filename()).string());
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
