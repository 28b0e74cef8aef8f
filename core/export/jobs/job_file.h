#pragma once

#include "core/system/file.h"
#include "core/export/jobs/jobs.h"

#include <optional>

namespace fumage {

inline constexpr std::string_view kJobsFormat = "fumage-jobs";
inline constexpr int kJobsVersion = 1;
/// Largest list of jobs without the pictures of its presets, some hundred of them, and largest file.
inline constexpr std::size_t kMaxJobsBytes = std::size_t{1} << 22U;
inline constexpr std::size_t kMaxJobsFileBytes = std::size_t{256} << 20U;

/// Jobs that were read, and what the reader had to put right in their presets.
struct JobsReading {
    std::vector<ExportJob> jobs;
    std::vector<Message> warnings; ///< as of PresetReading, a bounded number of them
};

/// Jobs as JSON: each with its whole preset and all that its kind asks for, in the words of the command line. Paths
/// that are not UTF-8 get replacement characters. parseJobs() of it gives the same jobs; writing those again gives the
/// same text.
[[nodiscard]] std::string formatJobs(std::span<const ExportJob> jobs);

/// Reads jobs from a text that may be anything. What is missing is as the command line has it: the whole timeline, the
/// format that the ending of the output asks for, the passes of the engine. The preset may be the name of one, as
/// loadPreset() takes it; a job whose preset cannot be read has a refusal, and the others stay. Outputs get the ending
/// of their format; "~/" at the beginning of a path is the user's home.
/// @param place  name of the source for messages, usually the file; may be empty
/// @param folder where paths that are not whole begin; empty: the working folder
/// @error Syntax, NotUtf8, NotFinite, TooDeep, TooLarge, WrongType, WrongVersion, OutOfRange, UnknownName; UnknownKey
/// with the nearest one: a slip would cost
///        hours. Places have line and column. OutOfMemory
/// O(n log n) in the text.
[[nodiscard]] Result<JobsReading> parseJobs(
    std::string_view json, const std::string& place = "", const std::filesystem::path& folder = {});

/// parseJobs() of a file, whose folder its paths begin in.
/// @error those of readFile() and parseJobs()
[[nodiscard]] Result<JobsReading> readJobsFile(const std::filesystem::path& path);
/// Writes formatJobs(), whole or not at all.
/// @error TooLarge where readJobsFile() would not read it; those of writeFileAtomically()
[[nodiscard]] Status writeJobsFile(
    const std::filesystem::path& path, std::span<const ExportJob> jobs, FileAccess access = FileAccess::Usual);

/// A plan alone, as one of the objects of formatJobs() without a preset: what a program remembers.
[[nodiscard]] std::string formatPlan(const ExportPlan& plan);
/// Reads what formatPlan() writes, also of other versions: lines that this one does not know, or finds wrong, are left
/// out. The file names nothing that is read.
/// @return none: it is no such text
[[nodiscard]] std::optional<ExportPlan> parsePlan(std::string_view json);

} // namespace fumage
