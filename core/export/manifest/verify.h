#pragma once

#include "core/base/task.h"
#include "core/export/manifest/manifest_parts.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fumage {

/// What a file is against its manifest.
enum class FileState {
    Same,
    Missing,
    Different,
    Broken, ///< a picture that does not read to its end
    Contradicted, ///< two manifests say different things of it
    Extra, ///< it lies beside files of its kind, and is in no manifest
    NotAFile, ///< a folder, a pipe or a device has its name
    Unreadable, ///< it is there, and may not or cannot be read
};
inline constexpr std::array kAllFileStates{FileState::Same, FileState::Missing, FileState::Different, FileState::Broken,
    FileState::Contradicted, FileState::Extra, FileState::NotAFile, FileState::Unreadable};

/// "same", "missing": what answers for programs call it.
[[nodiscard]] std::string_view nameOf(FileState state);

struct CheckedFile {
    std::string file; ///< path from the folder; of a frame that no manifest names: empty
    std::optional<int> frame;
    FileState state = FileState::Same;
    Message why{}; ///< it is not a file, unreadable or broken; else empty
};

/// Manifests, and where their files lie.
struct ManifestSet {
    std::filesystem::path folder;
    bool whole = false; ///< whether these are all that the folder has
    std::vector<FoundManifest> manifests; ///< 1 or more
    std::vector<Error> broken{}; ///< what is wrong with others, whose files nobody knows
};

/// Those of a folder, or a single one.
/// @error FileNotFound where there is none; those of readManifest() where none can be read
[[nodiscard]] Result<ManifestSet> openManifests(const std::filesystem::path& folderOrManifest);

/// Holds the files of a folder against its manifests; one that cannot be read does not keep others from being looked
/// at. Files may have any size.
/// @param frames that must be there; none: those that the manifests name
/// @return       all files, by name; frames that no manifest names come last
/// @error        Cancelled, OutOfMemory
[[nodiscard]] Result<std::vector<CheckedFile>> checkFiles(
    const ManifestSet& set, const std::optional<FrameRange>& frames, const Task& task = {});

/// Renders frames again, and holds what this machine makes of them against the manifests; flipbooks that show one of
/// them as a whole. Files are not looked at.
/// @return the frames of the manifests that lie in the range, and the files of flipbooks
/// @error  OutOfRange where none does; WrongType where a manifest does not say how, or where all that does is neither
/// frames nor a flipbook; those of encodeFrames() and encodeFlipbook()
[[nodiscard]] Result<std::vector<CheckedFile>> renderAgain(
    const ManifestSet& set, const FrameRange& frames, const Task& task = {});

} // namespace fumage
