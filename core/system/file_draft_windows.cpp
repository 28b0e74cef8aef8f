#include "core/system/file_draft.h"
#include "core/system/path.h"

#include "core/base/sha256.h"
#include "core/system/system_text.h"
#include "core/base/windows_api.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include <aclapi.h>
#include <sddl.h>

namespace fumage {

namespace {

/// FileRenameInfoEx, which mingw-w64's headers lack
constexpr auto kRenameInfoEx = static_cast<FILE_INFO_BY_HANDLE_CLASS>(22);
constexpr DWORD kShareAll = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;

int lastError()
{
    return static_cast<int>(::GetLastError());
}

/// @return 0, or the error of what failed
int writeAll(HANDLE file, std::span<const std::byte> bytes)
{
    constexpr std::size_t kMaxAtOnce = std::size_t{1} << 30U;
    while (!bytes.empty()) {
        DWORD count = 0;
        if (::WriteFile(file, bytes.data(), static_cast<DWORD>(std::min(bytes.size(), kMaxAtOnce)), &count, nullptr)
            == 0) {
            return lastError();
        }
        bytes = bytes.subspan(count);
    }
    return 0;
}

/// What an open file or folder is called when all links are followed.
std::filesystem::path finalPath(HANDLE file)
{
    std::wstring name(::GetFinalPathNameByHandleW(file, nullptr, 0, FILE_NAME_NORMALIZED), L'\0');
    name.resize(::GetFinalPathNameByHandleW(file, name.data(), static_cast<DWORD>(name.size()), FILE_NAME_NORMALIZED));
    return name;
}

std::filesystem::path temporaryName(int attempt)
{
    return pathFrom(
        std::string(kDraftPrefix) + std::to_string(::GetCurrentProcessId()) + "-" + std::to_string(attempt));
}

/// Gives a new file the permissions of the one that it replaces, if we may: without, it has those of its folder.
void takeOver(const std::filesystem::path& draft, HANDLE before)
{
    PACL list = nullptr;
    PSECURITY_DESCRIPTOR descriptor = nullptr;
    SECURITY_DESCRIPTOR_CONTROL control = 0;
    DWORD revision = 0;
    if (::GetSecurityInfo(
            before, SE_FILE_OBJECT, DACL_SECURITY_INFORMATION, nullptr, nullptr, &list, nullptr, &descriptor)
        != ERROR_SUCCESS) {
        return;
    }
    if (::GetSecurityDescriptorControl(descriptor, &control, &revision) != 0) {
        const SECURITY_INFORMATION inherits = (control & SE_DACL_PROTECTED) != 0
            ? PROTECTED_DACL_SECURITY_INFORMATION
            : UNPROTECTED_DACL_SECURITY_INFORMATION;
        std::wstring name = draft.wstring();
        static_cast<void>(::SetNamedSecurityInfoW(
            name.data(), SE_FILE_OBJECT, DACL_SECURITY_INFORMATION | inherits, nullptr, nullptr, list, nullptr));
    }
    ::LocalFree(descriptor);
}

/// The user who runs the program, as security descriptors name people; empty where the system does not say.
std::wstring userId()
{
    HANDLE opened = nullptr;
    if (::OpenProcessToken(::GetCurrentProcess(), TOKEN_QUERY, &opened) == 0) {
        return {};
    }
    const Descriptor token(opened);
    DWORD size = 0;
    ::GetTokenInformation(token.get(), TokenUser, nullptr, 0, &size);
    std::vector<std::byte> room(size);
    wchar_t* text = nullptr;
    if (::GetTokenInformation(token.get(), TokenUser, room.data(), size, &size) == 0
        || ::ConvertSidToStringSidW(reinterpret_cast<TOKEN_USER*>(room.data())->User.Sid, &text) == 0) {
        return {};
    }
    const std::wstring id = text;
    ::LocalFree(text);
    return id;
}

/// Who may use a file that is made.
class Permissions {
public:
    explicit Permissions(FileAccess access)
    {
        const std::wstring user = access == FileAccess::Private ? userId() : std::wstring();
        if (!user.empty()) {
            // User and system have all rights, nobody else has any, and none come from the folder.
            const std::wstring text = L"D:P(A;;FA;;;" + user + L")(A;;FA;;;SY)";
            static_cast<void>(::ConvertStringSecurityDescriptorToSecurityDescriptorW(
                text.c_str(), SDDL_REVISION_1, &m_attributes.lpSecurityDescriptor, nullptr));
        }
    }
    ~Permissions() { ::LocalFree(m_attributes.lpSecurityDescriptor); }
    Permissions(const Permissions&) = delete;
    Permissions& operator=(const Permissions&) = delete;
    Permissions(Permissions&&) = delete;
    Permissions& operator=(Permissions&&) = delete;

    [[nodiscard]] SECURITY_ATTRIBUTES* get() { return &m_attributes; }

private:
    SECURITY_ATTRIBUTES m_attributes{sizeof(SECURITY_ATTRIBUTES), nullptr, FALSE};
};

/// Renames an open file; what has the name is replaced in one step, even while others read it, where the file system
/// can do that.
/// @return 0, or the error of what failed
int rename(HANDLE file, const std::filesystem::path& to)
{
    const std::wstring name = std::filesystem::absolute(to).wstring();
    std::vector<std::byte> room(sizeof(FILE_RENAME_INFO) + name.size() * sizeof(wchar_t));
    auto* const wish = reinterpret_cast<FILE_RENAME_INFO*>(room.data());
    wish->FileNameLength = static_cast<DWORD>(name.size() * sizeof(wchar_t));
    std::memcpy(wish->FileName, name.data(), wish->FileNameLength);
    wish->Flags = FILE_RENAME_FLAG_REPLACE_IF_EXISTS | FILE_RENAME_FLAG_POSIX_SEMANTICS;
    if (::SetFileInformationByHandle(file, kRenameInfoEx, wish, static_cast<DWORD>(room.size())) != 0) {
        return 0;
    }
    wish->Flags = 0;
    wish->ReplaceIfExists = TRUE;
    return ::SetFileInformationByHandle(file, FileRenameInfo, wish, static_cast<DWORD>(room.size())) != 0 ? 0
                                                                                                          : lastError();
}

} // namespace

Result<FileDraft> FileDraft::make(
    const std::filesystem::path& path, std::span<const std::byte> bytes, FileAccess access, Naming naming)
{
    FileDraft draft(path);
    draft.m_naming = naming;
    const DWORD attributes = ::GetFileAttributesW(path.c_str());
    const bool exists = attributes != INVALID_FILE_ATTRIBUTES;
    if (exists && (attributes & FILE_ATTRIBUTE_DIRECTORY) != 0) {
        return draft.error(FileFailure::IsFolder);
    }
    if (exists && (attributes & FILE_ATTRIBUTE_READONLY) != 0) {
        return draft.error(FileFailure::Denied);
    }
    const Descriptor before(::CreateFileW(path.c_str(), READ_CONTROL, kShareAll, nullptr, OPEN_EXISTING, 0, nullptr));
    if (before && ::GetFileType(before.get()) != FILE_TYPE_DISK) {
        return draft.error(FileFailure::NotAFile);
    }
    const bool isLink = before && (attributes & FILE_ATTRIBUTE_REPARSE_POINT) != 0;
    const std::filesystem::path target = isLink ? finalPath(before.get()) : path;
    draft.m_target = target.filename();
    int failure = draft.openFolder(target.parent_path());
    if (failure == 0) {
        failure = draft.open(access);
    }
    if (failure == 0) {
        failure = writeAll(draft.m_file.get(), bytes);
    }
    if (failure == 0 && before && access == FileAccess::Usual) {
        takeOver(draft.path(), before.get());
    }
    if (failure == 0 && ::FlushFileBuffers(draft.m_file.get()) == 0) {
        failure = lastError();
    }
    return failure == 0 ? Result<FileDraft>(std::move(draft)) : draft.error(failure);
}

FileDraft::~FileDraft()
{
    if (m_file && !m_temporary.empty()) {
        m_file = {};
        ::DeleteFileW(path().c_str());
    }
    if (m_folder) {
        ::ReleaseMutex(m_folder.get()); // fails where it was never locked
    }
}

/// Opens the lock of a folder, whose name all programs of this machine know.
int FileDraft::openFolder(const std::filesystem::path& folder)
{
    m_folderPath = folder;
    const Descriptor opened(::CreateFileW(folder.empty() ? L"." : folder.c_str(), 0, kShareAll, nullptr, OPEN_EXISTING,
        FILE_FLAG_BACKUP_SEMANTICS, nullptr));
    if (!opened) {
        m_blame = m_folderPath;
        return lastError();
    }
    const std::string name = finalPath(opened.get()).string();
    const HANDLE lock = ::CreateMutexW(nullptr, FALSE, wideFrom("Global\\fumage-" + sha256Of(name)).c_str());
    m_folder = lock == nullptr ? Descriptor() : Descriptor(lock); // without, nothing is locked
    return 0;
}

int FileDraft::open(FileAccess access)
{
    return openNamed(access);
}

int FileDraft::openNamed(FileAccess access)
{
    // Nobody else may write it or delete it, unless another program is to write it: such a program would not open what
    // may be renamed meanwhile.
    const bool isShared = m_naming == Naming::Temporary;
    const DWORD rights = isShared ? GENERIC_WRITE : GENERIC_WRITE | DELETE;
    const DWORD share = isShared ? FILE_SHARE_READ | FILE_SHARE_WRITE : FILE_SHARE_READ;
    Permissions permissions(access);
    for (int attempt = 0;; ++attempt) {
        m_temporary = temporaryName(attempt);
        m_file = Descriptor(::CreateFileW(
            path().c_str(), rights, share, permissions.get(), CREATE_NEW, FILE_ATTRIBUTE_NORMAL, nullptr));
        if (m_file) {
            return 0;
        }
        const int failure = lastError();
        if (failure != ERROR_FILE_EXISTS && failure != ERROR_ALREADY_EXISTS) {
            m_blame = failure == ERROR_ACCESS_DENIED && !m_folderPath.empty() ? m_folderPath : m_blame;
            return failure;
        }
    }
}

int FileDraft::takePlace()
{
    if (m_naming == Naming::Temporary) {
        m_file = {}; // it could not be renamed
        m_file = Descriptor(
            ::CreateFileW(path().c_str(), GENERIC_WRITE | DELETE, FILE_SHARE_READ, nullptr, OPEN_EXISTING, 0, nullptr));
        if (!m_file) {
            return lastError();
        }
    }
    const int failure = rename(m_file.get(), m_folderPath / m_target);
    if (failure == 0) {
        m_temporary.clear();
    }
    return failure;
}

Status FileDraft::flush()
{
    return ::FlushFileBuffers(m_file.get()) != 0 ? Status(Done{}) : error(lastError());
}

Status FileDraft::publish()
{
    if (const int failure = takePlace(); failure != 0) {
        return error(failure);
    }
    return flush(); // its new name, too
}

void FileDraft::lockFolder() const
{
    if (m_folder) {
        ::WaitForSingleObject(m_folder.get(), INFINITE);
    }
}

void removeUnlessWritten(const std::filesystem::path& draft)
{
    ::DeleteFileW(draft.c_str()); // fails while its writer has it open
}

} // namespace fumage
