#include "core/base/open_file.h"

#include "core/base/file_error.h"

#include <cerrno>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace fumage {

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
    std::string text(size, '\0');
    std::size_t done = 0;
    while (done < text.size()) {
        const ssize_t count = ::read(m_descriptor.get(), text.data() + done, text.size() - done);
        if (count < 0 && errno == EINTR) {
            continue;
        }
        if (count < 0) {
            return fileError(errno, m_path, ErrorCode::ReadFailed, FileUse::Read);
        }
        if (count == 0) {
            text.resize(done);
        }
        done += static_cast<std::size_t>(count);
    }
    return text;
}

} // namespace fumage
