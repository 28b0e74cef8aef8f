#include "core/base/file.h"

#include <cerrno>
#include <cstring>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace fumage {

namespace {

/// Closes a file descriptor.
class Descriptor {
public:
    explicit Descriptor(int fd)
        : m_fd(fd)
    {
    }
    ~Descriptor()
    {
        if (m_fd >= 0) {
            ::close(m_fd);
        }
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    [[nodiscard]] int get() const { return m_fd; }

private:
    int m_fd;
};

Error fromErrno(int number, const std::filesystem::path& path, ErrorCode otherwise, std::string_view doing)
{
    const std::string place = path.string();
    const std::string what(doing);
    switch (number) {
    case ENOENT: return {ErrorCode::FileNotFound, "cannot " + what + ": there is no such file or folder", place, "Check the spelling of the path"};
    case EACCES:
    case EPERM:
    case EROFS: return {ErrorCode::PermissionDenied, "cannot " + what + ": permission denied", place, "Choose a place that you may use, or change its permissions"};
    case EISDIR: return {ErrorCode::NotAFile, "cannot " + what + ": it is a folder", place, "Name a file"};
    case ENOTDIR: return {ErrorCode::NotAFile, "cannot " + what + ": a part of the path is not a folder", place, "Check the path"};
    case ENOSPC:
    case EDQUOT: return {ErrorCode::DiskFull, "cannot " + what + ": the disk is full", place, "Free some space or choose another disk"};
    case EFBIG: return {ErrorCode::DiskFull, "cannot " + what + ": the file is larger than may be written here", place, "Choose another disk or a smaller size"};
    default: return {otherwise, "cannot " + what + ": " + std::strerror(number), place, ""};
    }
}

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
    return ::fsync(fd) == 0 || errno == EINVAL || errno == ENOTSUP ? 0 : errno;
}

/// The mode of the file that is replaced, or what the umask leaves of 0666.
mode_t modeFor(const std::filesystem::path& path)
{
    struct stat information { };
    if (::stat(path.c_str(), &information) == 0) {
        return information.st_mode & 07777U;
    }
    const mode_t mask = ::umask(0);
    ::umask(mask);
    return 0666U & ~mask;
}

} // namespace

Result<std::string> readFile(const std::filesystem::path& path, std::size_t mostBytes)
{
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (file.get() < 0) {
        return fromErrno(errno, path, ErrorCode::ReadFailed, "read");
    }
    struct stat information { };
    if (::fstat(file.get(), &information) != 0) {
        return fromErrno(errno, path, ErrorCode::ReadFailed, "read");
    }
    if (S_ISDIR(information.st_mode)) {
        return fromErrno(EISDIR, path, ErrorCode::ReadFailed, "read");
    }
    if (!S_ISREG(information.st_mode)) {
        return Error{ErrorCode::NotAFile, "cannot read: it is not a regular file", path.string(), "Name a file"};
    }
    if (static_cast<std::size_t>(information.st_size) > mostBytes) {
        return Error{ErrorCode::TooLarge, "the file has " + std::to_string(information.st_size) + " bytes, more than the " + std::to_string(mostBytes) + " that are read", path.string(), "Choose another file"};
    }
    std::string text(static_cast<std::size_t>(information.st_size), '\0');
    std::size_t done = 0;
    while (done < text.size()) {
        const ssize_t count = ::read(file.get(), text.data() + done, text.size() - done);
        if (count < 0 && errno == EINTR) {
            continue;
        }
        if (count < 0) {
            return fromErrno(errno, path, ErrorCode::ReadFailed, "read");
        }
        if (count == 0) {
            text.resize(done);
        }
        done += static_cast<std::size_t>(count);
    }
    return text;
}

Status makeFolderOf(const std::filesystem::path& file)
{
    const std::filesystem::path folder = file.parent_path();
    std::error_code failure;
    if (!folder.empty() && !std::filesystem::is_directory(folder, failure)) {
        std::filesystem::create_directories(folder, failure);
        if (failure) {
            return Error{ErrorCode::PermissionDenied, "the folder cannot be made: " + failure.message(), folder.string(), "Choose another place"};
        }
    }
    return Done{};
}

Status writeFileAtomically(const std::filesystem::path& path, std::span<const std::byte> bytes)
{
    struct stat information { };
    if (::stat(path.c_str(), &information) == 0 && !S_ISREG(information.st_mode)) {
        return fromErrno(S_ISDIR(information.st_mode) ? EISDIR : ENOTDIR, path, ErrorCode::WriteFailed, "write");
    }
    if (::access(path.c_str(), F_OK) == 0 && ::access(path.c_str(), W_OK) != 0) {
        return fromErrno(EACCES, path, ErrorCode::WriteFailed, "write");
    }
    // A link stays a link: its target is replaced.
    std::error_code ignored;
    const std::filesystem::path target = std::filesystem::is_symlink(path, ignored) ? std::filesystem::weakly_canonical(path, ignored) : path;
    std::string temporary = target.string() + ".XXXXXX";
    const mode_t mode = modeFor(target);
    const Descriptor file(::mkostemp(temporary.data(), O_CLOEXEC));
    if (file.get() < 0) {
        return fromErrno(errno, path, ErrorCode::WriteFailed, "write");
    }
    int failure = writeAll(file.get(), bytes);
    if (failure == 0 && (::fchmod(file.get(), mode) != 0 || ::rename(temporary.c_str(), target.c_str()) != 0)) {
        failure = errno;
    }
    if (failure != 0) {
        ::unlink(temporary.c_str());
        return fromErrno(failure, path, ErrorCode::WriteFailed, "write");
    }
    return Done{};
}

Status writeFileAtomically(const std::filesystem::path& path, std::string_view text)
{
    return writeFileAtomically(path, std::as_bytes(std::span(text.data(), text.size())));
}

} // namespace fumage
