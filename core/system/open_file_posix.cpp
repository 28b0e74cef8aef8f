#include "core/system/open_file.h"

#include "core/system/file_error.h"

#include <algorithm>
#include <cerrno>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace fumage {

namespace {

/// @param readSome as read() does, told how much there is already
template <class ReadSome>
Result<std::string> readWhole(std::size_t size, const std::filesystem::path& path, const ReadSome& readSome)
{
    std::string text(size, '\0');
    std::size_t done = 0;
    while (done < text.size()) {
        const ssize_t count = readSome(text.data() + done, text.size() - done, done);
        if (count < 0 && errno == EINTR) {
            continue;
        }
        if (count < 0) {
            return fileError(errno, path, ErrorCode::ReadFailed, FileUse::Read);
        }
        if (count == 0) {
            text.resize(done);
        }
        done += static_cast<std::size_t>(count);
    }
    return text;
}

} // namespace

Result<OpenFile> OpenFile::open(const std::filesystem::path& path)
{
    Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat information { };
    if (!file || ::fstat(file.get(), &information) != 0) {
        return fileError(errno, path, ErrorCode::ReadFailed, FileUse::Read);
    }
    if (S_ISDIR(information.st_mode)) {
        return fileError(FileFailure::IsFolder, path, ErrorCode::ReadFailed, FileUse::Read);
    }
    if (!S_ISREG(information.st_mode)) {
        return fileError(FileFailure::NotAFile, path, ErrorCode::ReadFailed, FileUse::Read);
    }
    return OpenFile(path, std::move(file), static_cast<std::size_t>(information.st_size));
}

Result<std::string> OpenFile::read(std::size_t size) const
{
    return readWhole(size, m_path,
        [this](char* to, std::size_t count, std::size_t) { return ::read(m_descriptor.get(), to, count); });
}

Result<std::string> OpenFile::readAt(std::uint64_t at, std::size_t size) const
{
    const std::size_t there = at < m_size ? m_size - static_cast<std::size_t>(at) : 0;
    return readWhole(std::min(size, there), m_path, [this, at](char* to, std::size_t count, std::size_t done) {
        return ::pread(m_descriptor.get(), to, count, static_cast<off_t>(at + done));
    });
}

} // namespace fumage
