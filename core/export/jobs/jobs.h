#pragma once

#include "core/export/export_task.h"
#include "core/export/plan.h"

#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace fumage {

/// Longest name of a job, in bytes.
inline constexpr std::size_t kMaxJobName = 1000;

/// An export that can wait: all that it needs, so that what is changed meanwhile does not touch it.
struct ExportJob {
    std::string name; ///< what people call it
    Preset preset; ///< whose smoke is exported
    ExportPlan plan; ///< where its project is set, pictures carry the preset, whatever stands in the project
    std::optional<Error> refusal{}; ///< why it cannot be done: the preset that it names cannot be read
    std::string presetName{}; ///< which, as it was named
};

/// Most jobs of one list, and most files that they write.
inline constexpr std::size_t kMaxJobs = 256;
inline constexpr std::size_t kMaxJobFiles = std::size_t{1} << 20U;

/// Does a job. On the calling thread.
/// @param task as runExport()
/// @return the flipbook, where that is what was made
/// @error its refusal; those of runExport()
[[nodiscard]] Result<std::optional<Flipbook>> runJob(const ExportJob& job, const ExportTask& task = {});

/// The files that jobs write, manifests among them, to find those that one would write over another's. Folders are the
/// same by whatever way they are named. Names in which A to Z are small or not are the same, as for file systems that
/// ignore case; of folders that are there the system knows.
class JobFiles {
public:
    /// Takes the files of a job in. O(files).
    /// @error WouldOverwrite where a job before writes one of them: it stays out then; TooLarge beyond kMaxJobFiles
    [[nodiscard]] Status add(const ExportJob& job);
    /// The same of files that are named themselves.
    /// @param name of what they are written by
    [[nodiscard]] Status add(const std::string& name, std::span<const std::filesystem::path> files);
    /// Whether add() would take a job in.
    [[nodiscard]] Status check(const ExportJob& job) const;
    /// @return which of the jobs that were taken in writes a file, counted from 0; none: nobody does
    [[nodiscard]] std::optional<std::size_t> writerOf(const std::filesystem::path& file) const;

private:
    [[nodiscard]] Status check(const std::string& name, std::span<const std::filesystem::path> files) const;

    std::vector<std::string> m_names; ///< of the jobs
    std::unordered_map<std::string, std::size_t> m_writers; ///< which job, by what its file is compared by
};

/// Whether the jobs of a list leave one another alone: no two write the same file, and none the preset's file of
/// another. Nothing is read but where folders lie. A job that would write over its own preset says so when it is done.
/// @error WouldOverwrite, TooLarge
[[nodiscard]] Status checkJobs(std::span<const ExportJob> jobs);

} // namespace fumage
