#include "core/system/file_draft.h"

namespace fumage {

FileDraft::FileDraft(const std::filesystem::path& path)
    : m_blame(path)
{
}

Error FileDraft::error(int number) const
{
    return fileError(number, m_blame, ErrorCode::WriteFailed, FileUse::Write);
}

Error FileDraft::error(FileFailure failure) const
{
    return fileError(failure, m_blame, ErrorCode::WriteFailed, FileUse::Write);
}

void clearLeftovers(const std::filesystem::path& folder)
{
    std::error_code failure;
    for (std::filesystem::directory_iterator at(folder.empty() ? "." : folder, failure), end; !failure && at != end;
         at.increment(failure)) {
        if (at->path().filename().string().starts_with(kDraftPrefix)) {
            removeUnlessWritten(at->path());
        }
    }
}

} // namespace fumage
