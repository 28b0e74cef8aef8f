#pragma once

#include "core/base/result.h"
#include "core/effect/effect.h"
#include "core/image_io/image_metadata.h"
#include "core/version.h"
#include "core/preset/preset_file.h"

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fumage {

inline constexpr std::string_view kManifestFormat = "fumage-manifest";
inline constexpr int kManifestVersion = 1;
/// A manifest that is larger is not read: this is some hundred thousand files.
inline constexpr std::size_t kMaxManifestBytes = std::size_t{32} << 20U;

/// What a file is known by.
struct Content {
    /// Whether it is the hash of what a picture shows, see pictureHash(); else of the file's bytes
    bool ofPixels = false;
    std::string hash; ///< SHA-256
    friend bool operator==(const Content&, const Content&) = default;
};

/// The pixels of a PNG, TGA or EXR, and the bytes of any other file.
/// @error those of pictureHash(): a picture that is broken
[[nodiscard]] Result<Content> contentOf(std::span<const std::byte> file);
/// The same of a file that is read a part at a time; see pictureHash().
/// @error that of the reader
[[nodiscard]] Result<Content> contentOf(const PartReader& file);
/// The same of a file of any size.
/// @error those of OpenFile
[[nodiscard]] Result<Content> contentOfFile(const std::filesystem::path& path);

/// What files are made of: the same job makes the same files, on every machine.
struct ManifestJob {
    std::string kind; ///< "frames", "flipbook", "volumes", "air", "particles"
    std::map<std::string, std::string> settings; ///< that change what files hold, beside the effect
    Scene scene; ///< with the camera and the size that pictures are taken with
    std::string program = FUMAGE_VERSION;

    /// SHA-256 of all of it.
    [[nodiscard]] std::string hash() const;
};

struct ManifestEntry {
    std::string file; ///< path from the manifest's folder, with slashes; within it
    std::optional<int> frame; ///< none where it is of several
    Content content;
};

/// Which files a job has made, or one task of it its part of them.
struct Manifest {
    ManifestJob job;
    std::string jobHash; ///< as it was read; of one's own: job.hash()
    std::vector<ManifestEntry> files;
};

/// JSON with a newline at the end.
[[nodiscard]] std::string formatManifest(const Manifest& manifest);

/// Reads what formatManifest() gives, which anybody may have written: no file that it names lies outside of its folder.
/// @param place name of the file, for messages
/// @error those of parsePreset(); OutOfRange where a file lies elsewhere
[[nodiscard]] Result<Manifest> parseManifest(std::string_view json, const std::string& place);

} // namespace fumage
