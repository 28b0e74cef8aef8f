#pragma once

#include "core/system/descriptor.h"
#include "core/system/file_access.h"
#include "core/system/file_error.h"
#include "core/base/result.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace fumage {

/// Of a temporary file, whatever program it belongs to.
inline constexpr std::string_view kDraftPrefix = ".fumage-";

/// The contents of a file, complete and on the disk, which has yet to take its place. Given up if it does not.
///
/// While it has a name of its own nobody else can lock it, or on Windows delete it: a temporary file that can be has no
/// living writer.
class FileDraft {
public:
    enum class Naming {
        None, ///< where the file system can do that
        Temporary,
    };

    /// @error those of writeFileAtomically()
    [[nodiscard]] static Result<FileDraft> make(const std::filesystem::path& path, std::span<const std::byte> bytes,
        FileAccess access, Naming naming = Naming::None);

    ~FileDraft();
    FileDraft(FileDraft&& other) noexcept = default;
    FileDraft& operator=(FileDraft&& other) noexcept = delete;
    FileDraft(const FileDraft&) = delete;
    FileDraft& operator=(const FileDraft&) = delete;

    /// Where another program may write the contents while it has a temporary name; flush() then brings them to the
    /// disk.
    [[nodiscard]] std::filesystem::path path() const { return m_folderPath / m_temporary; }
    [[nodiscard]] Status flush();
    /// Takes the place of what is there.
    [[nodiscard]] Status publish();
    /// Waits until no other program publishes a pair in the folder; lasts until the draft is gone. Does nothing where
    /// there are no locks.
    void lockFolder() const;

private:
    explicit FileDraft(const std::filesystem::path& path);
    // These return 0, or what fileError() takes for what failed.
    [[nodiscard]] int openFolder(const std::filesystem::path& folder);
    [[nodiscard]] int open(FileAccess access);
    [[nodiscard]] int openNamed(FileAccess access);
    [[nodiscard]] int takePlace();
    [[nodiscard]] Error error(int number) const;
    [[nodiscard]] Error error(FileFailure failure) const;

    std::filesystem::path m_folderPath;
    std::filesystem::path m_blame; ///< what failures are said of
    std::filesystem::path m_target; ///< name in the folder
    std::filesystem::path m_temporary; ///< name in the folder; empty while there is none
    Naming m_naming = Naming::None;
    Descriptor m_folder; ///< what its files are named and locked by
    Descriptor m_file;
};

/// Removes a temporary file that has no living writer.
void removeUnlessWritten(const std::filesystem::path& draft);

} // namespace fumage
