#include "core/base/file.h"

#include "core/base/file_draft.h"
#include "core/base/file_error.h"

#include <algorithm>
#include <cerrno>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>

namespace fumage {

namespace {

/// A regular file that is open for reading.
struct OpenFile {
    Descriptor descriptor;
    std::size_t size = 0;
};

Result<OpenFile> openFile(const std::filesystem::path& path)
{
    Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (file.get() < 0) {
        return fileError(errno, path, ErrorCode::ReadFailed, FileUse::Read);
    }
    struct stat information { };
    if (::fstat(file.get(), &information) != 0) {
        return fileError(errno, path, ErrorCode::ReadFailed, FileUse::Read);
    }
    if (S_ISDIR(information.st_mode)) {
        return fileError(EISDIR, path, ErrorCode::ReadFailed, FileUse::Read);
    }
    if (!S_ISREG(information.st_mode)) {
        return Error{ErrorCode::NotAFile, said("cannot read: %1", said("it is not a regular file")), path.string(), said("Name a file")};
    }
    return OpenFile{std::move(file), static_cast<std::size_t>(information.st_size)};
}

/// @param size of what is read; less where the file has become shorter
Result<std::string> readBytes(const OpenFile& file, std::size_t size, const std::filesystem::path& path)
{
    std::string text(size, '\0');
    std::size_t done = 0;
    while (done < text.size()) {
        const ssize_t count = ::read(file.descriptor.get(), text.data() + done, text.size() - done);
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

Result<std::string> readFile(const std::filesystem::path& path, std::size_t mostBytes)
{
    const Result<OpenFile> file = openFile(path);
    if (!file) {
        return file.error();
    }
    if (file.value().size > mostBytes) {
        return Error{ErrorCode::TooLarge, said("the file has %1 bytes, more than the %2 that are read", file.value().size, mostBytes), path.string(), said("Choose another file")};
    }
    return readBytes(file.value(), file.value().size, path);
}

Result<std::string> readFileHead(const std::filesystem::path& path, std::size_t mostBytes)
{
    const Result<OpenFile> file = openFile(path);
    return file ? readBytes(file.value(), std::min(mostBytes, file.value().size), path) : file.error();
}

Status makeFolderOf(const std::filesystem::path& file)
{
    const std::filesystem::path folder = file.parent_path();
    std::error_code failure;
    if (!folder.empty() && !std::filesystem::is_directory(folder, failure)) {
        std::filesystem::create_directories(folder, failure);
        if (failure) {
            return Error{ErrorCode::PermissionDenied, said("the folder cannot be made: %1", failure.message()), folder.string(), said("Choose another place")};
        }
    }
    clearLeftovers(folder);
    return Done{};
}

Status writeFileAtomically(const std::filesystem::path& path, std::span<const std::byte> bytes, FileAccess access)
{
    Result<FileDraft> draft = FileDraft::make(path, bytes, access);
    return draft ? draft.value().publish() : Status(draft.error());
}

Status writeFileAtomically(const std::filesystem::path& path, std::string_view text, FileAccess access)
{
    return writeFileAtomically(path, std::as_bytes(std::span(text.data(), text.size())), access);
}

Status writeTogetherAtomically(std::span<const FileContents> files)
{
    std::vector<FileDraft> drafts;
    for (const FileContents& file : files) {
        Result<FileDraft> draft = FileDraft::make(file.path, file.bytes, FileAccess::Usual);
        if (!draft) {
            return draft.error();
        }
        drafts.push_back(std::move(draft).value());
    }
    drafts.front().lockFolder();
    for (FileDraft& draft : drafts) {
        if (Status status = draft.publish(); !status) {
            return status;
        }
    }
    return Done{};
}

bool isSameFile(const std::filesystem::path& a, const std::filesystem::path& b)
{
    std::error_code missing;
    return std::filesystem::equivalent(a, b, missing);
}

} // namespace fumage
