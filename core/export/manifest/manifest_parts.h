#pragma once

#include "core/export/manifest/manifest.h"
#include "core/export/sequence.h"

#include <filesystem>

namespace fumage {

/// Tasks that share a folder write a part each, so that none has to wait for another or can spoil what it wrote, on any
/// file system: fire.0-7.manifest.json.

/// The path of a file as a manifest names it: from the manifest's folder, be it within it or not.
[[nodiscard]] std::filesystem::path withinFolderOf(
    const std::filesystem::path& manifest, const std::filesystem::path& file);

/// The manifest that stands for an output where nobody names one: fire.manifest.json for fire_####.png.
[[nodiscard]] std::filesystem::path manifestBeside(const std::filesystem::path& output);

/// Whether a file is named as manifests are.
[[nodiscard]] bool isManifest(const std::filesystem::path& file);

/// The file of the part of some frames.
/// @param manifest its ending may be left out
/// @param frames   none: the manifest is not divided
[[nodiscard]] std::filesystem::path partOf(
    const std::filesystem::path& manifest, const std::optional<FrameRange>& frames);

/// A manifest, or part of one, that lies in a folder.
struct FoundManifest {
    std::filesystem::path path;
    Manifest manifest;
};

/// Reads one.
/// @error those of readFile() and parseManifest()
[[nodiscard]] Result<Manifest> readManifest(const std::filesystem::path& path);

/// All that lie in a folder, by name.
/// @param broken where it is given, what is wrong with those that cannot be read goes there, and the others are read
/// @error without it those of readManifest(); FileNotFound
[[nodiscard]] Result<std::vector<FoundManifest>> findManifests(
    const std::filesystem::path& folder, std::vector<Error>* broken = nullptr);

/// Writes down what files hold, and at the end a manifest of it.
class ManifestRecorder {
public:
    /// @param manifest in the folder of the files, or above it
    /// @param frames   see partOf()
    ManifestRecorder(ManifestJob job, const std::filesystem::path& manifest, const std::optional<FrameRange>& frames);

    /// @error OutOfRange: the file does not lie in the manifest's folder; those of contentOf()
    [[nodiscard]] Status add(
        const std::filesystem::path& file, std::optional<int> frame, std::span<const std::byte> bytes);
    /// The same of what is known already.
    [[nodiscard]] Status add(const std::filesystem::path& file, std::optional<int> frame, Content content);

    /// Writes the part, and takes away those of other jobs that name the same files: they are no longer true. Does
    /// nothing where nothing was added.
    /// @error those of writeFileAtomically()
    [[nodiscard]] Status write();

private:
    void removeOutdated() const;

    std::filesystem::path m_manifest;
    std::filesystem::path m_part;
    Manifest m_recorded;
};

} // namespace fumage
