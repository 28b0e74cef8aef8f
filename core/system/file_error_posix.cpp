#include "core/system/file_error.h"

#include <cerrno>
#include <cstring>

namespace fumage {

namespace {

FileFailure failureOf(int number)
{
    switch (number) {
    case ENOENT: return FileFailure::Missing;
    case EACCES:
    case EPERM: return FileFailure::Denied;
    case EROFS: return FileFailure::ReadOnlyDisk;
    case EISDIR: return FileFailure::IsFolder;
    case ENOTDIR: return FileFailure::NotAFolder;
    case ELOOP: return FileFailure::LinksInCircle;
    case ENAMETOOLONG: return FileFailure::NameTooLong;
    case ENOSPC:
    case EDQUOT: return FileFailure::DiskFull;
    case EFBIG: return FileFailure::TooLargeForDisk;
    case EINVAL:
    case EILSEQ:
    case ENODEV:
    case ENXIO:
    case ENOSYS:
    case ENOEXEC:
    case EXDEV:
    case EOPNOTSUPP:
#if ENOTSUP != EOPNOTSUPP
    case ENOTSUP:
#endif
    case EOVERFLOW: return FileFailure::Unusable;
    case EAGAIN:
    case EMFILE:
    case ENFILE:
    case ENOBUFS:
    case ENOMEM: return FileFailure::Exhausted;
    default: return FileFailure::Other;
    }
}

} // namespace

Error fileError(int number, const std::filesystem::path& path, ErrorCode otherwise, FileUse doing)
{
    return fileError(failureOf(number), path, otherwise, doing, std::strerror(number));
}

} // namespace fumage
