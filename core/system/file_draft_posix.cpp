#include "core/system/file_draft.h"

#include <cerrno>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace fumage {

namespace {

constexpr mode_t kModeBits = 07777;
constexpr int kMaxLinks = 40; ///< as the kernel follows

#ifdef __linux__
constexpr int kWithoutName = O_TMPFILE;
constexpr int kNotListed = O_PATH;
#else // files have names, and folders that may not be listed cannot be opened
constexpr int kWithoutName = 0;
constexpr int kNotListed = O_RDONLY;
#endif

/// @return 0, or the errno of what failed
int writeAll(int fd, std::span<const std::byte> bytes)
{
    while (!bytes.empty()) {
        const ssize_t count = ::write(fd, bytes.data(), bytes.size());
        if (count < 0 && errno != EINTR) {
            return errno;
        }
        bytes = bytes.subspan(static_cast<std::size_t>(count < 0 ? 0 : count));
    }
    return 0;
}

/// Flushes a file or a folder to the disk, where the file system can do that.
int flush(int fd)
{
    return ::fsync(fd) == 0 || errno == EINVAL || errno == ENOTSUP || errno == EBADF ? 0 : errno;
}

/// What a path leads to; its last part may be missing.
Result<std::filesystem::path> followLinks(std::filesystem::path path)
{
    const std::filesystem::path named = path;
    std::error_code failure;
    for (int i = 0; i < kMaxLinks; ++i) {
        if (!std::filesystem::is_symlink(path, failure)) {
            return path;
        }
        // An absolute target replaces the folder.
        path = path.parent_path() / std::filesystem::read_symlink(path, failure);
    }
    return fileError(FileFailure::LinksInCircle, named, ErrorCode::WriteFailed, FileUse::Write);
}

bool isLocked(int fd)
{
    return ::flock(fd, LOCK_EX | LOCK_NB) == 0;
}

std::string temporaryName(int attempt)
{
    return std::string(kDraftPrefix) + std::to_string(::getpid()) + "-" + std::to_string(attempt);
}

mode_t modeOf(FileAccess access)
{
    constexpr mode_t kAnyone = 0666; // less the umask
    constexpr mode_t kUserAlone = 0600;
    return access == FileAccess::Private ? kUserAlone : kAnyone;
}

std::string linkToDescriptor(int fd)
{
    return "/proc/self/fd/" + std::to_string(fd);
}

/// Gives a file without a name one, of a temporary file. @return 0, or the errno of what failed
int takeName(int file, int folder, std::filesystem::path& name)
{
    for (int attempt = 0; name.empty(); ++attempt) {
        const std::string wanted = temporaryName(attempt);
        if (::linkat(AT_FDCWD, linkToDescriptor(file).c_str(), folder, wanted.c_str(), AT_SYMLINK_FOLLOW) == 0) {
            name = wanted;
        } else if (errno != EEXIST) {
            return errno;
        }
    }
    return 0;
}

/// Gives a new file the mode of the one that it replaces, and its owner and group if we may.
int takeOver(int fd, const struct stat& before)
{
    struct stat now { };
    if (::fstat(fd, &now) != 0) {
        return errno;
    }
    const bool sameOwner = now.st_uid == before.st_uid && now.st_gid == before.st_gid;
    if (!sameOwner && ::fchown(fd, before.st_uid, before.st_gid) != 0) {
        constexpr auto kKeep = static_cast<uid_t>(-1);
        static_cast<void>(::fchown(fd, kKeep, before.st_gid)); // only root gives files away
    }
    return ::fchmod(fd, before.st_mode & kModeBits) == 0 ? 0 : errno;
}

} // namespace

Result<FileDraft> FileDraft::make(
    const std::filesystem::path& path, std::span<const std::byte> bytes, FileAccess access, Naming naming)
{
    FileDraft draft(path);
    draft.m_naming = naming;
    struct stat information { };
    const bool exists = ::stat(path.c_str(), &information) == 0;
    if (exists && S_ISDIR(information.st_mode)) {
        return draft.error(FileFailure::IsFolder);
    }
    if (exists && !S_ISREG(information.st_mode)) {
        return draft.error(FileFailure::NotAFile);
    }
    if (exists && ::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0) {
        return draft.error(errno);
    }
    const Result<std::filesystem::path> target = followLinks(path);
    if (!target) {
        return target.error();
    }
    draft.m_target = target.value().filename();
    int failure = draft.openFolder(target.value().parent_path());
    if (failure == 0) {
        failure = draft.open(exists ? FileAccess::Private : access);
    }
    if (failure == 0) {
        failure = writeAll(draft.m_file.get(), bytes);
    }
    if (failure == 0 && exists && access == FileAccess::Usual) {
        failure = takeOver(draft.m_file.get(), information);
    }
    if (failure == 0) {
        failure = fumage::flush(draft.m_file.get());
    }
    return failure == 0 ? Result<FileDraft>(std::move(draft)) : draft.error(failure);
}

FileDraft::~FileDraft()
{
    if (m_file && !m_temporary.empty()) {
        ::unlinkat(m_folder.get(), m_temporary.c_str(), 0);
    }
}

/// Opens a folder so that its entries can be used; one that may not be listed cannot be flushed.
int FileDraft::openFolder(const std::filesystem::path& folder)
{
    m_folderPath = folder;
    const char* name = folder.empty() ? "." : folder.c_str();
    m_folder = Descriptor(::open(name, O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!m_folder && errno == EACCES) {
        m_folder = Descriptor(::open(name, kNotListed | O_DIRECTORY | O_CLOEXEC));
    }
    if (m_folder) {
        return 0;
    }
    const int failure = errno;
    m_blame = failure == ENOTDIR ? m_blame : m_folderPath;
    return failure;
}

int FileDraft::open(FileAccess access)
{
    if (kWithoutName != 0 && m_naming == Naming::None && ::access("/proc/self/fd", X_OK) == 0) {
        m_file = Descriptor(::openat(m_folder.get(), ".", kWithoutName | O_WRONLY | O_CLOEXEC, modeOf(access)));
    }
    if (m_file) {
        static_cast<void>(isLocked(m_file.get())); // before it has a name that others could see
        return 0;
    }
    return openNamed(access);
}

int FileDraft::openNamed(FileAccess access)
{
    for (int attempt = 0;; ++attempt) {
        const std::string name = temporaryName(attempt);
        m_file =
            Descriptor(::openat(m_folder.get(), name.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, modeOf(access)));
        if (!m_file && errno != EEXIST) {
            const int failure = errno;
            if ((failure == EACCES || failure == EPERM) && !m_folderPath.empty()) {
                m_blame = m_folderPath;
            }
            return failure;
        }
        // Between the two calls another program may have locked it to clear it away.
        struct stat information { };
        const bool lost = m_file && !isLocked(m_file.get()) && errno == EWOULDBLOCK;
        if (m_file && !lost && ::fstat(m_file.get(), &information) == 0 && information.st_nlink > 0) {
            m_temporary = name;
            return 0;
        }
    }
}

int FileDraft::takePlace()
{
    const bool isNew = m_temporary.empty()
        && ::linkat(
               AT_FDCWD, linkToDescriptor(m_file.get()).c_str(), m_folder.get(), m_target.c_str(), AT_SYMLINK_FOLLOW)
            == 0;
    if (isNew) {
        return 0;
    }
    if (const int failure = takeName(m_file.get(), m_folder.get(), m_temporary); failure != 0) {
        return failure;
    }
    if (::renameat(m_folder.get(), m_temporary.c_str(), m_folder.get(), m_target.c_str()) != 0) {
        return errno;
    }
    m_temporary.clear();
    return 0;
}

Status FileDraft::flush()
{
    const int failure = fumage::flush(m_file.get());
    return failure == 0 ? Status(Done{}) : error(failure);
}

Status FileDraft::publish()
{
    int failure = takePlace();
    if (failure == 0) {
        failure = fumage::flush(m_folder.get());
    }
    return failure == 0 ? Status(Done{}) : error(failure);
}

void FileDraft::lockFolder() const
{
    while (::flock(m_folder.get(), LOCK_EX) != 0 && errno == EINTR) { }
}

void removeUnlessWritten(const std::filesystem::path& draft)
{
    const Descriptor file(::open(draft.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    if (file && isLocked(file.get())) {
        ::unlink(draft.c_str());
    }
}

} // namespace fumage
