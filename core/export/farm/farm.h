#pragma once

#include "core/base/result.h"
#include "core/export/sequence.h"

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace fumage {

/// What hands out work to the machines of a studio.
enum class Farm {
    Slurm, ///< script of an array
    OpenJd, ///< Open Job Description, jobtemplate-2023-09 with TASK_CHUNKING, as JSON
    Flamenco, ///< job type of Flamenco 3, JavaScript
    Deadline, ///< files for its CommandLine plugin, and a script that submits them
};
inline constexpr std::array kAllFarms{Farm::Slurm, Farm::OpenJd, Farm::Flamenco, Farm::Deadline};

/// "slurm", "openjd": what the command line calls it.
[[nodiscard]] std::string_view nameOf(Farm farm);

/// Frames of a preset, rendered by many machines that share a folder.
struct FarmJob {
    std::filesystem::path
        folder; ///< absolute, as all machines see it; the preset, the frames and the farm's files lie in it
    std::string name; ///< of the job, and of the farm's files; the preset's file is name.fumage.json
    std::string output; ///< file name of the frames; a run of # becomes the number
    FrameRange frames;
    int perTask = 1; ///< frames, see framesPerTask()
    std::vector<std::string> renderWords; ///< options of "fumage-cli render" beside preset, frames, output, manifest
                                          ///< and what is there already
    std::vector<std::string>
        joinWords; ///< a command of fumage-cli when all frames are there, with paths from the folder; empty: none
};

/// Most frames that a farm takes as one task.
[[nodiscard]] int mostPerTask(Farm farm);

/// The preset's file, from the folder.
[[nodiscard]] std::string presetFileOf(const FarmJob& job);

struct FarmFile {
    std::filesystem::path path; ///< in the job's folder
    std::string contents;
};

/// What a farm takes, and how it is handed over.
struct FarmFiles {
    std::vector<FarmFile> files; ///< 1 or more
    std::string submit; ///< what a person does with them: a command, or a sentence
};

/// Writes the templates of resources/farm for a job. Names are quoted as each format asks for.
/// @error OutOfRange where a name has characters that the farm has no way to write, and where there are more frames a
/// task than it takes
[[nodiscard]] Result<FarmFiles> makeFarmFiles(Farm farm, const FarmJob& job);

} // namespace fumage
