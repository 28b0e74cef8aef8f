#include "core/system/file.h"

#include "core/system/file_draft.h"
#include "core/system/file_error.h"
#include "core/system/open_file.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace fumage {

Result<std::string> readFile(const std::filesystem::path& path, std::size_t mostBytes)
{
    const Result<OpenFile> file = OpenFile::open(path);
    if (!file) {
        return file.error();
    }
    if (file.value().size() > mostBytes) {
        return Error{ErrorCode::TooLarge,
            makeMessage("the file has %1 bytes, more than the %2 that are read", file.value().size(), mostBytes),
            path.string(), makeMessage("Choose another file")};
    }
    return file.value().read(file.value().size());
}

Result<std::string> readFileHead(const std::filesystem::path& path, std::size_t mostBytes)
{
    const Result<OpenFile> file = OpenFile::open(path);
    return file ? file.value().read(std::min(mostBytes, file.value().size())) : file.error();
}

Status makeFolderOf(const std::filesystem::path& file)
{
    const std::filesystem::path folder = file.parent_path();
    std::error_code failure;
    if (!folder.empty() && !std::filesystem::is_directory(folder, failure)) {
        std::filesystem::create_directories(folder, failure);
        if (failure) {
            Error error = fileError(failure.value(), folder, ErrorCode::WriteFailed, FileUse::Write);
            error.message = makeMessage("the folder cannot be made: %1", failure.message());
            error.remedy = error.remedy.empty() ? makeMessage("Choose another place") : error.remedy;
            return error;
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
