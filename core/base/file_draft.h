#pragma once

#include "core/base/descriptor.h"
#include "core/base/file.h"

#include <string>

#include <sys/types.h>

namespace fumage {

/// The contents of a file, complete and on the disk, which has yet to take its place. Given up if it does not.
///
/// While it has a name of its own it is locked: a temporary file that can be locked has no living writer.
class FileDraft {
public:
    enum class Naming {
        None, ///< where the file system can do that
        Temporary,
    };

    /// @error those of writeFileAtomically()
    [[nodiscard]] static Result<FileDraft> make(const std::filesystem::path& path, std::span<const std::byte> bytes, FileAccess access, Naming naming = Naming::None);

    ~FileDraft();
    FileDraft(FileDraft&& other) noexcept = default;
    FileDraft& operator=(FileDraft&& other) noexcept = delete;
    FileDraft(const FileDraft&) = delete;
    FileDraft& operator=(const FileDraft&) = delete;

    /// Where another program may write the contents while it has a temporary name; flush() then brings them to the disk.
    [[nodiscard]] std::filesystem::path path() const { return m_folderPath / m_temporary; }
    [[nodiscard]] Status flush();
    /// Takes the place of what is there.
    [[nodiscard]] Status publish();
    /// Waits until no other program publishes a pair in the folder; lasts until the draft is gone. Does nothing where there are no locks.
    void lockFolder() const;

private:
    explicit FileDraft(const std::filesystem::path& path);
    // These return 0, or the errno of what failed.
    [[nodiscard]] int open(FileAccess access, Naming naming);
    [[nodiscard]] int openNamed(mode_t mode);
    [[nodiscard]] int takeName();
    [[nodiscard]] int takePlace();
    [[nodiscard]] Error error(int number) const;

    std::filesystem::path m_folderPath;
    std::filesystem::path m_blame; ///< what failures are said of
    std::string m_target; ///< name in the folder
    std::string m_temporary; ///< name in the folder; empty while there is none
    Descriptor m_folder;
    Descriptor m_file;
};

} // namespace fumage
