#include "core/system/open_file.h"

#include "core/system/file_error.h"
#include "core/base/windows_api.h"

#include <algorithm>

namespace fumage {

namespace {

Error readError(DWORD number, const std::filesystem::path& path)
{
    return fileError(static_cast<int>(number), path, ErrorCode::ReadFailed, FileUse::Read);
}

} // namespace

Result<OpenFile> OpenFile::open(const std::filesystem::path& path)
{
    // Whoever replaces the file meanwhile may do so: what is open stays as it is.
    constexpr DWORD kShareAll = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
    Descriptor file(::CreateFileW(
        path.c_str(), GENERIC_READ, kShareAll, nullptr, OPEN_EXISTING, FILE_FLAG_SEQUENTIAL_SCAN, nullptr));
    if (!file) {
        const DWORD failure = ::GetLastError();
        const DWORD attributes = ::GetFileAttributesW(path.c_str());
        const bool isFolder = attributes != INVALID_FILE_ATTRIBUTES && (attributes & FILE_ATTRIBUTE_DIRECTORY) != 0;
        return isFolder ? fileError(FileFailure::IsFolder, path, ErrorCode::ReadFailed, FileUse::Read)
                        : readError(failure, path);
    }
    if (::GetFileType(file.get()) != FILE_TYPE_DISK) {
        return fileError(FileFailure::NotAFile, path, ErrorCode::ReadFailed, FileUse::Read);
    }
    LARGE_INTEGER size{};
    if (::GetFileSizeEx(file.get(), &size) == 0) {
        return readError(::GetLastError(), path);
    }
    return OpenFile(path, std::move(file), static_cast<std::size_t>(size.QuadPart));
}

Result<std::string> OpenFile::readAt(std::uint64_t at, std::size_t size) const
{
    LARGE_INTEGER place{};
    place.QuadPart = static_cast<LONGLONG>(at);
    if (::SetFilePointerEx(m_descriptor.get(), place, nullptr, FILE_BEGIN) == 0) {
        return readError(::GetLastError(), m_path);
    }
    return read(std::min(size, at < m_size ? m_size - static_cast<std::size_t>(at) : 0));
}

Result<std::string> OpenFile::read(std::size_t size) const
{
    constexpr std::size_t kMaxAtOnce = std::size_t{1} << 30U;
    std::string text(size, '\0');
    std::size_t done = 0;
    while (done < text.size()) {
        DWORD count = 0;
        if (::ReadFile(m_descriptor.get(), text.data() + done,
                static_cast<DWORD>(std::min(text.size() - done, kMaxAtOnce)), &count, nullptr)
            == 0) {
            return readError(::GetLastError(), m_path);
        }
        if (count == 0) {
            text.resize(done);
        }
        done += count;
    }
    return text;
}

} // namespace fumage
