#include "core/system/file_lock.h"

#include <cerrno>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace fumage {

namespace {

/// Locks what is open, where its file system can do that.
bool isHeldByAnother(int fd)
{
    return ::flock(fd, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
}

/// Whether a name still leads to what is open: whoever held the lock before may have taken the file away.
bool leadsTo(const std::filesystem::path& file, int fd)
{
    struct stat named = {};
    struct stat open = {};
    return ::stat(file.c_str(), &named) == 0 && ::fstat(fd, &open) == 0 && named.st_ino == open.st_ino
        && named.st_dev == open.st_dev;
}

} // namespace

std::unique_ptr<FileLock> FileLock::tryTake(const std::filesystem::path& file)
{
    constexpr mode_t kPrivate = 0600;
    while (true) {
        Descriptor descriptor(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, kPrivate));
        if (!descriptor || isHeldByAnother(descriptor.get())) {
            return nullptr;
        }
        if (leadsTo(file, descriptor.get())) {
            return std::unique_ptr<FileLock>(new FileLock(
                file, std::move(descriptor))); // NOLINT(cppcoreguidelines-owning-memory): its constructor is private
        }
    }
}

FileLock::~FileLock()
{
    ::unlink(m_file.c_str()); // while it is held: nobody else's
}

} // namespace fumage
