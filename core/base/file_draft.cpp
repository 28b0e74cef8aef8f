#include "core/base/file_draft.h"

#include "core/base/file_error.h"

#include <cerrno>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

namespace fumage {

namespace {

constexpr std::string_view kLeftoverPrefix = ".fumage-";
constexpr mode_t kAnyone = 0666; ///< less the umask
constexpr mode_t kUserAlone = 0600;
constexpr mode_t kModeBits = 07777;
constexpr int kMostLinks = 40; ///< as the kernel follows

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
    for (int i = 0; i < kMostLinks; ++i) {
        if (!std::filesystem::is_symlink(path, failure)) {
            return path;
        }
        // An absolute target replaces the folder.
        path = path.parent_path() / std::filesystem::read_symlink(path, failure);
    }
    return fileError(ELOOP, named, ErrorCode::WriteFailed, FileUse::Write);
}

/// @return a folder whose entries can be used; one that may not be listed cannot be flushed
Descriptor openFolder(const std::filesystem::path& folder)
{
    const char* name = folder.empty() ? "." : folder.c_str();
    Descriptor listed(::open(name, O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    return listed || errno != EACCES ? std::move(listed) : Descriptor(::open(name, O_PATH | O_DIRECTORY | O_CLOEXEC));
}

bool isLocked(int fd)
{
    return ::flock(fd, LOCK_EX | LOCK_NB) == 0;
}

std::string temporaryName(int attempt)
{
    return std::string(kLeftoverPrefix) + std::to_string(::getpid()) + "-" + std::to_string(attempt);
}

std::string linkToDescriptor(int fd)
{
    return "/proc/self/fd/" + std::to_string(fd);
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

FileDraft::FileDraft(const std::filesystem::path& path)
    : m_blame(path)
{
}

Result<FileDraft> FileDraft::make(const std::filesystem::path& path, std::span<const std::byte> bytes, FileAccess access, Naming naming)
{
    FileDraft draft(path);
    struct stat information { };
    const bool exists = ::stat(path.c_str(), &information) == 0;
    if (exists && S_ISDIR(information.st_mode)) {
        return draft.error(EISDIR);
    }
    if (exists && !S_ISREG(information.st_mode)) {
        return Error{ErrorCode::NotAFile, said("cannot write: %1", said("it is not a regular file")), path.string(), said("Name a file")};
    }
    if (exists && ::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0) {
        return draft.error(errno);
    }
    const Result<std::filesystem::path> target = followLinks(path);
    if (!target) {
        return target.error();
    }
    draft.m_target = target.value().filename().string();
    draft.m_folderPath = target.value().parent_path();
    draft.m_folder = openFolder(draft.m_folderPath);
    if (!draft.m_folder) {
        draft.m_blame = errno == ENOTDIR ? path : draft.m_folderPath;
        return draft.error(errno);
    }
    int failure = draft.open(exists ? FileAccess::Private : access, naming);
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

int FileDraft::open(FileAccess access, Naming naming)
{
    const mode_t mode = access == FileAccess::Private ? kUserAlone : kAnyone;
    if (naming == Naming::None && ::access("/proc/self/fd", X_OK) == 0) {
        m_file = Descriptor(::openat(m_folder.get(), ".", O_TMPFILE | O_WRONLY | O_CLOEXEC, mode));
    }
    if (m_file) {
        static_cast<void>(isLocked(m_file.get())); // before it has a name that others could see
        return 0;
    }
    return openNamed(mode);
}

int FileDraft::openNamed(mode_t mode)
{
    for (int attempt = 0;; ++attempt) {
        const std::string name = temporaryName(attempt);
        m_file = Descriptor(::openat(m_folder.get(), name.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, mode));
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

int FileDraft::takeName()
{
    for (int attempt = 0; m_temporary.empty(); ++attempt) {
        const std::string name = temporaryName(attempt);
        if (::linkat(AT_FDCWD, linkToDescriptor(m_file.get()).c_str(), m_folder.get(), name.c_str(), AT_SYMLINK_FOLLOW) == 0) {
            m_temporary = name;
        } else if (errno != EEXIST) {
            return errno;
        }
    }
    return 0;
}

int FileDraft::takePlace()
{
    const bool isNew = m_temporary.empty() && ::linkat(AT_FDCWD, linkToDescriptor(m_file.get()).c_str(), m_folder.get(), m_target.c_str(), AT_SYMLINK_FOLLOW) == 0;
    if (isNew) {
        return 0;
    }
    if (const int failure = takeName(); failure != 0) {
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
    while (::flock(m_folder.get(), LOCK_EX) != 0 && errno == EINTR) {
    }
}

Error FileDraft::error(int number) const
{
    return fileError(number, m_blame, ErrorCode::WriteFailed, FileUse::Write);
}

void clearLeftovers(const std::filesystem::path& folder)
{
    const Descriptor opened = openFolder(folder);
    std::error_code failure;
    for (std::filesystem::directory_iterator at(folder.empty() ? "." : folder, failure), end; !failure && at != end; at.increment(failure)) {
        const std::string name = at->path().filename().string();
        if (!name.starts_with(kLeftoverPrefix)) {
            continue;
        }
        const Descriptor file(::openat(opened.get(), name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
        if (file && isLocked(file.get())) {
            ::unlinkat(opened.get(), name.c_str(), 0);
        }
    }
}

} // namespace fumage
